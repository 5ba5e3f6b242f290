#pragma once

// Wendland's radial function of smoothness C⁴, positive definite in up to three dimensions.
//
//   φ(q) = (1 − q)⁶ (35q² + 18q + 3) / 3,  φ'(q) = −56/3 q (1 + 5q) (1 − q)⁵,  q < 1;  φ(0) = 1
//
// q = distance / support radius. φ'(0) = 0, so its gradient is smooth at the centre.
// Source: Wendland (1995), doi:10.1007/BF02123482 (φ_{3,2}).

#include <string_view>

namespace porowave::solver {

struct WendlandC4 {
  static constexpr std::string_view name = "wendland_c4";
  static constexpr double natural_radius = 2.0;  // in element lengths h; a choice of this program
  static constexpr bool radial = true;

  // q >= 0
  static constexpr double value(double q) {
    if (q >= 1.0) return 0.0;
    const double s2 = (1.0 - q) * (1.0 - q);
    return s2 * s2 * s2 * ((35.0 * q + 18.0) * q + 3.0) / 3.0;
  }

  // d value / dq
  static constexpr double derivative(double q) {
    if (q >= 1.0) return 0.0;
    const double s = 1.0 - q;
    const double s2 = s * s;
    return -56.0 / 3.0 * q * (1.0 + 5.0 * q) * s2 * s2 * s;
  }
};

}  // namespace porowave::solver
