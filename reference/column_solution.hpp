#pragma once

#include <vector>

#include "reference/bounded_fields.hpp"
#include "reference/modes.hpp"
#include "reference/problem/problem.hpp"

namespace porowave::reference {

/// The saturated column solved exactly: Laplace transform, images (rays), and for the rays that
/// have arrived a hyperbola round the singularities of the two modes (README.md of this room).
///
/// Immutable after construction; one object may be used by several threads at once. Many points of
/// one time are cheaper by TimeSlice, or by Profile.
///
/// Valid for every near and far end and every load of the problem library; tried for permeability
/// 1e-18 to 1e-2 m^2, porosity 0.02 to 0.98, E_oed/K_f 1e-6 to 1e6, relaxation_rate * t up to 1e8
/// and up to 300 crossings of the column. Bounds are mostly 1e-15 to 1e-12 of the load there; they
/// count the rounding of all terms and the observed convergence. Near the undrained front they grow
/// like 1e-16 sqrt(relaxation_rate * t), and with the number of images. A front lies within 8
/// roundings of its time of arrival: there, the value behind it is given, and the bound includes
/// the jump. Unresolved are times at which more than 200,000 images have arrived (some 400
/// crossings where modes convert at an end), and values whose bound would exceed the load.
class ColumnSolution {
 public:
  explicit ColumnSolution(const Problem& problem);

  /// Fields at 0 <= x <= length and time t; exactly zero before the first arrival. Throws
  /// InputError for x outside of the column or values not finite.
  BoundedFields at(double x, double t) const;
  /// Integrals of the four fields over time, from 0 to t: Pa s, Pa s, and the displacements of
  /// solid and fluid in m. Their bounds are of the same size, relative to load times t. Throws as
  /// `at`.
  BoundedFields time_integral(double x, double t) const;

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
