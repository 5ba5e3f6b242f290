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

/// Fields at 0 <= x <= length and t, in Pa and m/s; before they are rounded to double, right to
/// `agreement`, mostly 1e-25 of the load. The doubles of problem, x and t are taken as exact
/// numbers. A wave that arrives up to 8 epsilon t after t has arrived: on a front, the value behind
/// it; before the first arrival, exactly zero. A ricker wavelet is not truncated to its duration,
/// where it is 4e-17.
///
/// Method: the images of the column, with modes, ends and loads by plain linear algebra at complex
/// s; each image with each event of the load is inverted on a hyperbola or circle that was found by
/// trying many in double precision. For a ricker wavelet, which is smooth, the whole column on a
/// vertical line. Valid for drag rate * time from 0 to 1e8 and up to some 300 crossings of the
/// column; takes 10 to 200 ms, in rare cases seconds.
ExactFields fifty_digits(const Problem& problem, double x, double t);

}  // namespace porowave::fixtures
