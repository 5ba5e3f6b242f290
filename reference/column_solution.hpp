#pragma once

#include <vector>

#include "reference/bounded_fields.hpp"
#include "reference/modes.hpp"
#include "reference/problem/problem.hpp"

namespace porowave::reference {

struct Ray;
class LoadTransform;

/// The saturated column solved exactly: Laplace transform, images (rays), and for the rays that
/// have arrived a closed contour around all singularities of the two modes (README.md of this
/// room).
///
/// Immutable after construction; one object may be used by several threads at once.
/// Valid for every near and far end and every load of the problem library.
///
/// Accuracy: the bound of a value counts the observed change of the quadrature under doubling and
/// the rounding of its terms; it is mostly 1e-14 to 1e-12 of the load, from no drag at all to
/// relaxation_rate * t of 1e5. Unresolved are values whose bound would exceed the load, and times
/// at which more than 200,000 images have arrived (some 400 crossings where modes convert at an
/// end), and those of a ricker wavelet that is still passing when relaxation_rate * duration
/// exceeds some 1,000.
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
  /// Values at the fronts themselves, and the jumps that rounding of an arrival may hide.
  void add_fronts(const std::vector<Ray>& rays, const LoadTransform& load, double t,
                  std::array<double, 4>& value, std::array<double, 4>& error) const;

  Problem problem_;
  WaveModes modes_;
};

}  // namespace porowave::reference
