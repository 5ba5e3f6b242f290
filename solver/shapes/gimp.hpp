#pragma once

// The generalised interpolation of GIMP: the linear function of a node, averaged over the point's
// domain [t − half, t + half],
//
//   S(t) = (A(t + half) − A(t − half)) / (2 half),  A' = 1 − |t| on [−1, 1], else 0.
//
// The sum over the nodes is 1, and linear fields are reproduced at the point.
//   gimp    uGIMP: the domain keeps its first size
//   cpgimp  cpGIMP: the domain is stretched with the solid (the caller changes `half`)
// Source: Bardenhagen & Kober (2004), doi:10.3970/cmes.2004.005.477.

#include <algorithm>
#include <cmath>
#include <string_view>

namespace porowave::solver {

template <bool Convects>
struct GimpShape {
  static constexpr std::string_view name = Convects ? "cpgimp" : "gimp";
  static constexpr bool has_domain = true;
  static constexpr bool convects = Convects;

  static constexpr double reach(double half) { return 1.0 + half; }
  static double value(double t, double half) {
    return (integral(t + half) - integral(t - half)) / (2.0 * half);
  }
  static double derivative(double t, double half) {
    return (hat(t + half) - hat(t - half)) / (2.0 * half);
  }

 private:
  static double hat(double t) { return std::max(0.0, 1.0 - std::abs(t)); }
  static double integral(double t) {
    const double a = std::min(std::abs(t), 1.0);
    return std::copysign(a - 0.5 * a * a, t);
  }
};

}  // namespace porowave::solver
