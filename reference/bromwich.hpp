#pragma once

#include <vector>

#include "reference/bounded_fields.hpp"
#include "reference/bromwich_load.hpp"
#include "reference/bromwich_waves.hpp"

namespace porowave::reference {

/// The saturated column by the Bromwich integral itself, as a check of ColumnSolution, with which
/// it shares the statement of the problem only.
///
/// For every image that has arrived and every piece of the load that has arrived with it, let F(s)
/// be the transform of its fields, tau the time since. The first three terms of the expansion of F
/// in 1/s (the front, and what follows it at once) are inverted in closed form; the rest is
///
///   (2/pi) e^(sigma tau) integral_0^infinity Re rest(sigma + i omega) cos(omega tau) d omega
///
/// (the rest is 0 for tau < 0), by gsl_integration_qawf. Images that have not arrived are 0.
///
/// Ends and loads: all. Range: the error that is given with a value grows with e^(sigma tau), where
/// sigma stays right of the point at which both modes meet, and with relaxation_rate * t; see
/// README.md for what was measured. Values that GSL cannot find, whose error would exceed the load,
/// or to which more than 600 images contribute, are NaN with an error of infinity.
class BromwichSolution {
 public:
  /// tolerance: wanted error relative to the load. Throws InputError unless 1e-13 <= tolerance < 1.
  explicit BromwichSolution(const Problem& problem, double tolerance = 1e-9);

  /// Fields at 0 <= x <= length and time t, each with an estimate of its error. On a front, the
  /// value behind it, with the jump in the error. Throws InputError for x outside of the column or
  /// values that are not finite. May be called from several threads at once.
  BoundedFields at(double x, double t) const;

  const Problem& problem() const { return problem_; }

 private:
  Problem problem_;
  double tolerance_;
  line::Medium medium_;
  std::vector<line::LoadPiece> pieces_;
};

}  // namespace porowave::reference
