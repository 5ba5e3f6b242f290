#pragma once

// Wendland's radial function of smoothness C², positive definite in up to three dimensions.
//
//   φ(q) = (1 − q)⁴ (4q + 1),  φ'(q) = −20 q (1 − q)³,  q < 1;  φ(0) = 1
//
// q = distance / support radius. φ'(0) = 0, so its gradient is smooth at the centre.
// Source: Wendland (1995), doi:10.1007/BF02123482 (φ_{3,1}).

#include <string_view>

namespace porowave::solver {

struct WendlandC2 {
  static constexpr std::string_view name = "wendland_c2";
  static constexpr double natural_radius = 2.0;  // in element lengths h; a choice of this program
  static constexpr bool radial = true;

  // q >= 0
  static constexpr double value(double q) {
    if (q >= 1.0) return 0.0;
    const double s2 = (1.0 - q) * (1.0 - q);
    return s2 * s2 * (4.0 * q + 1.0);
  }

  // d value / dq
  static constexpr double derivative(double q) {
    if (q >= 1.0) return 0.0;
    const double s = 1.0 - q;
    return -20.0 * q * s * s * s;
  }
};

}  // namespace porowave::solver
