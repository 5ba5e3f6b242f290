#pragma once

// Centred uniform B-spline of order 3 (cubic); C².
//
//   B(t) = 2/3 − t² + t³/2,  t ≤ 1
//          (2 − t)³ / 6,     t ≤ 2      with t = |x|/h.  Sum over unit-spaced nodes: 1.
//
// q = distance / support radius, so t = natural_radius · q. In Dim > 1 a product over the axes.
// Source: de Boor, A Practical Guide to Splines (1978), ch. IX; in the MPM: Steffen, Kirby &
// Berzins (2008), doi:10.1002/nme.2360.

#include <string_view>

namespace porowave::solver {

struct BSpline3 {
  static constexpr std::string_view name = "bspline3";
  static constexpr double natural_radius = 2.0;  // in element lengths h
  static constexpr bool radial = false;

  // q >= 0
  static constexpr double value(double q) {
    const double t = natural_radius * q;
    if (t <= 1.0) return 2.0 / 3.0 - t * t * (1.0 - 0.5 * t);
    if (q < 1.0) return (2.0 - t) * (2.0 - t) * (2.0 - t) / 6.0;
    return 0.0;
  }

  // d value / dq
  static constexpr double derivative(double q) {
    const double t = natural_radius * q;
    if (t <= 1.0) return natural_radius * t * (1.5 * t - 2.0);
    if (q < 1.0) return natural_radius * -0.5 * (2.0 - t) * (2.0 - t);
    return 0.0;
  }
};

}  // namespace porowave::solver
