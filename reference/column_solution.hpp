#pragma once

#include <vector>

#include "reference/modes.hpp"
#include "reference/problem/problem.hpp"

namespace porowave::reference {

/// Values at one point and time, each with a bound for its own error (same unit). A value that
/// could not be resolved is NaN with a bound of infinity.
struct BoundedFields {
  Fields value;
  Fields error;
};

/// The saturated column solved exactly: Laplace transform, images (rays), and for the rays that
/// have arrived a closed contour around all singularities of the two modes (README.md of this
/// room).
///
/// Immutable after construction; one object may be used by several threads at once.
/// Valid for every near and far end and every load of the problem library.
///
/// Accuracy: the bound of a value counts the observed convergence of the quadrature and the
/// rounding of its terms. With relaxation_rate * t up to about 50 it is below 1e-12 of the load.
/// In stiffer problems the bound grows; where it would exceed the load (with relaxation_rate * t
/// above some 300, mostly), the value is unresolved.
class ColumnSolution {
 public:
  explicit ColumnSolution(const Problem& problem);

  /// Fields at 0 <= x <= length and time t; exactly zero before the first arrival. On a front,
  /// the value behind it. Throws InputError for x outside of the column or values not finite.
  BoundedFields at(double x, double t) const;

  const Problem& problem() const { return problem_; }
  const WaveModes& modes() const { return modes_; }

  /// Where the fields may jump or have a kink at time t: positions of all fronts inside the column,
  /// ascending, without those of later load jumps.
  std::vector<double> fronts(double t) const;

 private:
  Problem problem_;
  WaveModes modes_;
};

}  // namespace porowave::reference
