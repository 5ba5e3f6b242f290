#pragma once

#include <cmath>

#include "verification/faults/fault.hpp"

namespace porowave::verification::faults {

/// What every weighting kernel must fulfil; the first that does not hold.
template <class Kernel>
Catch caught_by_kernel_facts() {
  const Catch none{"facts of kernels", ""};
  const auto caught = [&](const char* fact) {
    return Catch{none.by, std::string("does not hold: ") + fact};
  };
  constexpr int samples = 1000;
  constexpr double step = 1e-6;
  for (int k = 0; k < samples; ++k) {
    const double q = (k + 0.5) / samples;
    if (!(Kernel::value(q) > 0.0)) return caught("positive inside of the support");
    const double rise = Kernel::value(q + step) - Kernel::value(q - step);
    // Kinks and jumps of higher derivatives lie between the samples.
    if (!(std::abs(rise / (2.0 * step) - Kernel::derivative(q)) < 1e-5)) {
      return caught("the derivative is that of the value");
    }
    if (Kernel::value(1.0 + q) != 0.0) return caught("zero outside of the support");
  }
  if (!(std::abs(Kernel::value(1.0 - step)) < 1e-5)) return caught("zero at the support's end");
  for (int k = 0; k < samples; ++k) {
    const double q = static_cast<double>(k) / samples;
    const double jump = Kernel::value(q + 1e-12) - Kernel::value(std::abs(q - 1e-12));
    if (!(std::abs(jump) < 1e-10)) return caught("no jump inside of the support");
  }
  if (Kernel::radial) return none;
  // A B-spline on a grid of unit spacing.
  for (int k = 0; k < samples; ++k) {
    double sum = 0.0;
    for (int i = -4; i <= 4; ++i) {
      const double offset = i + static_cast<double>(k) / samples;
      sum += Kernel::value(std::abs(offset) / Kernel::natural_radius);
    }
    if (!(std::abs(sum - 1.0) < 1e-13)) return caught("B-splines of a grid sum up to 1");
  }
  return none;
}

}  // namespace porowave::verification::faults
