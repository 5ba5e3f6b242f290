#pragma once

#include "reference/problem/problem.hpp"

/// The exact solution by a second route, for tests: slow, in 50 decimal digits and more, and
/// sharing nothing with the reference but the statement of the problem.
namespace porowave::fixtures {

struct ExactFields {
  Fields value;
  /// Largest difference between two sets of different contours, relative to the load
  /// (Problem::stress_scale, velocity_scale); infinite where no contour serves.
  double agreement = 0.0;
};

/// Fields at 0 <= x <= length and t, in Pa and m/s; before rounding to double right to some 1e-20
/// of the load, as `agreement` tells. The doubles of problem, x and t are taken as exact numbers. A
/// wave that arrives up to 8 epsilon t after t has arrived: on a front, the value behind it; before
/// the first arrival, exactly zero. A ricker wavelet is not truncated to its duration (4e-17).
///
/// Method: images of the column as in physics, each with its own arrival; modes, ends and loads by
/// plain linear algebra at a complex s; contours by trying many in double precision.
ExactFields fifty_digits(const Problem& problem, double x, double t);

}  // namespace porowave::fixtures
