#include "verification/order/richardson.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

namespace porowave::verification {

namespace {

constexpr double lowest = 1e-3;
constexpr double highest = 20.0;

/// Root of a function that changes sign once between `low` and `high`; NaN if it does not.
double bisect(const std::function<double(double)>& f, double low, double high) {
  double at_low = f(low);
  if (!(at_low * f(high) <= 0.0)) return std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    const double at_middle = f(middle);
    if (at_low * at_middle <= 0.0) {
      high = middle;
    } else {
      low = middle;
      at_low = at_middle;
    }
  }
  return 0.5 * (low + high);
}

}  // namespace

Richardson extrapolate(const std::array<double, 3>& spacing, const std::array<double, 3>& value,
                       double safety) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(spacing[i] > 0.0) || (i > 0 && !(spacing[i] < spacing[i - 1]))) {
      throw std::invalid_argument("Richardson extrapolation: expected falling, positive spacings");
    }
    if (!std::isfinite(value[i])) {
      throw std::invalid_argument("Richardson extrapolation: expected finite values");
    }
  }
  const double coarse_ratio = spacing[0] / spacing[1];
  const double fine_ratio = spacing[1] / spacing[2];
  const double coarse = value[0] - value[1];
  const double fine = value[1] - value[2];
  Richardson result;
  result.oscillating = coarse * fine < 0.0;
  // |coarse/fine| = r_21^p (r_32^p - 1)/(r_21^p - 1), r_21 the finer ratio.
  const double quotient = std::abs(coarse / fine);
  result.order = bisect(
      [&](double p) {
        const double finer = std::pow(fine_ratio, p);
        return finer * (std::pow(coarse_ratio, p) - 1.0) / (finer - 1.0) - quotient;
      },
      lowest, highest);
  const double growth = std::pow(fine_ratio, result.order) - 1.0;
  result.extrapolated = value[2] - fine / growth;
  result.gci = safety * std::abs(fine / value[2]) / growth;
  return result;
}

}  // namespace porowave::verification
