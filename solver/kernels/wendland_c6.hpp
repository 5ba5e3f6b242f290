#pragma once

// Wendland's radial function of smoothness C⁶, positive definite in up to three dimensions.
//
//   φ(q) = (1 − q)⁸ (32q³ + 25q² + 8q + 1),  φ'(q) = −22 q (16q² + 7q + 1) (1 − q)⁷,  q < 1;
//   φ(0) = 1
//
// q = distance / support radius. φ'(0) = 0, so its gradient is smooth at the centre.
// Source: Wendland (1995), doi:10.1007/BF02123482 (φ_{3,3}).

#include <string_view>

namespace porowave::solver {

struct WendlandC6 {
  static constexpr std::string_view name = "wendland_c6";
  static constexpr double natural_radius = 2.0;  // in element lengths h; a choice of this program
  static constexpr bool radial = true;

  // q >= 0
  static constexpr double value(double q) {
    if (q >= 1.0) return 0.0;
    const double s2 = (1.0 - q) * (1.0 - q);
    const double s4 = s2 * s2;
    return s4 * s4 * (((32.0 * q + 25.0) * q + 8.0) * q + 1.0);
  }

  // d value / dq
  static constexpr double derivative(double q) {
    if (q >= 1.0) return 0.0;
    const double s = 1.0 - q;
    const double s2 = s * s;
    return -22.0 * q * ((16.0 * q + 7.0) * q + 1.0) * s2 * s2 * s2 * s;
  }
};

}  // namespace porowave::solver
