#pragma once

#include <array>
#include <functional>
#include <vector>

#include "reference/column_solution.hpp"

namespace porowave::reference {

class TimeSlice;

/// All four fields along the column at one time, as fast to evaluate as a short series.
///
/// Between the fronts (and the places where later breaks of the load have arrived) the fields are
/// analytic, so Chebyshev interpolation on each smooth piece converges geometrically; pieces are
/// halved where it does not. Immutable after construction: one object may serve many threads.
/// Source: Trefethen, Approximation Theory and Approximation Practice (2013), chapters 3 and 8.
class Profile {
 public:
  /// Fields for 0 <= x <= end. Throws InputError where the solution is not defined.
  Profile(const ColumnSolution& solution, double t, double end);

  /// Fields at x; at a front the value ahead of it (larger x).
  Fields at(double x) const;

  /// Integral over 0 <= x <= end; exact for the series, up to rounding, if `f` is of degree two in
  /// the fields (Gauss-Legendre on every piece).
  double integral(const std::function<double(const Fields&)>& f) const;

  /// Estimate of the largest error anywhere, relative to the load: interpolation (size of the last
  /// coefficients) and the bounds of the values it interpolates. Infinite if one was unresolved.
  double error() const { return error_; }
  double time() const { return time_; }
  std::size_t pieces() const { return pieces_.size(); }
  std::size_t evaluations() const { return evaluations_; }  ///< of the solution, for the cost

 private:
  struct Piece {
    double begin;
    double end;
    std::vector<std::array<double, 4>> coefficients;  ///< [degree][field]
    Fields at(double x) const;
  };
  /// Largest difference between series and solution at a few places, as a share of the scales.
  double largest_deviation(TimeSlice& slice, const Piece& piece,
                           const std::array<double, 4>& scale);
  void add(TimeSlice& slice, const Problem& problem, double begin, double end, int depth);

  double time_;
  double error_ = 0.0;
  std::size_t evaluations_ = 0;
  std::vector<Piece> pieces_;
};

}  // namespace porowave::reference
