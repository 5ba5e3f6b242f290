#pragma once

// Centred uniform B-spline of order 2 (quadratic); C¹.
//
//   B(t) = 3/4 − t²,        t ≤ 1/2
//          (3/2 − t)² / 2,  t ≤ 3/2      with t = |x|/h.  Sum over unit-spaced nodes: 1.
//
// q = distance / support radius, so t = natural_radius · q. In Dim > 1 a product over the axes.
// Source: de Boor, A Practical Guide to Splines (1978), ch. IX; in the MPM: Steffen, Kirby &
// Berzins (2008), doi:10.1002/nme.2360.

#include <string_view>

namespace porowave::solver {

struct BSpline2 {
  static constexpr std::string_view name = "bspline2";
  static constexpr double natural_radius = 1.5;  // in element lengths h
  static constexpr bool radial = false;

  // q >= 0
  static constexpr double value(double q) {
    const double t = natural_radius * q;
    if (t <= 0.5) return 0.75 - t * t;
    if (q < 1.0) return 0.5 * (1.5 - t) * (1.5 - t);
    return 0.0;
  }

  // d value / dq
  static constexpr double derivative(double q) {
    const double t = natural_radius * q;
    if (t <= 0.5) return natural_radius * -2.0 * t;
    if (q < 1.0) return natural_radius * (t - 1.5);
    return 0.0;
  }
};

}  // namespace porowave::solver
