#pragma once

// A centred B-spline on a node: bspline1 (linear), bspline2, bspline3, from the kernels of the same
// names. Their sum over the nodes is 1 and they reproduce linear fields.
//
// Sources: de Boor, A Practical Guide to Splines (1978), ch. IX; in the MPM: Steffen, Kirby &
// Berzins (2008), doi:10.1002/nme.2360.

#include <cmath>
#include <string_view>

namespace porowave::solver {

template <class Kernel>
struct SplineShape {
  static constexpr std::string_view name = Kernel::name;
  static constexpr bool has_domain = false;  // the size of the point's domain plays no part
  static constexpr bool convects = false;

  static constexpr double reach(double /*half*/) { return Kernel::natural_radius; }
  static double value(double t, double /*half*/) {
    return Kernel::value(std::abs(t) / Kernel::natural_radius);
  }
  static double derivative(double t, double /*half*/) {
    const double slope = Kernel::derivative(std::abs(t) / Kernel::natural_radius);
    return (t < 0.0 ? -slope : slope) / Kernel::natural_radius;
  }
};

}  // namespace porowave::solver
