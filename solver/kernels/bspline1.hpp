#pragma once

// Centred uniform B-spline of order 1, the hat function; C⁰.
//
//   B(t) = 1 − t,  t ≤ 1,  with t = |x|/h.  Sum over unit-spaced nodes: 1.
//
// q = distance / support radius, so t = natural_radius · q. In Dim > 1 a product over the axes.
// The derivative at q = 0 is the one from the right; the kernel has a kink there.
// Source: Steffen, Kirby & Berzins (2008), doi:10.1002/nme.2360.

#include <string_view>

namespace porowave::solver {

struct BSpline1 {
  static constexpr std::string_view name = "bspline1";
  static constexpr double natural_radius = 1.0;  // in element lengths h
  static constexpr bool radial = false;

  // q >= 0
  static constexpr double value(double q) { return q < 1.0 ? 1.0 - q : 0.0; }

  // d value / dq
  static constexpr double derivative(double q) { return q < 1.0 ? -1.0 : 0.0; }
};

}  // namespace porowave::solver
