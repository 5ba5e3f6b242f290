#include "verification/order.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace porowave::verification {

double fitted_order(std::span<const LevelError> levels) {
  if (levels.size() < 2) throw std::invalid_argument("order: fewer than two levels");
  bool known = true;
  double mean_length = 0.0;
  double mean_error = 0.0;
  for (const auto& [length, error] : levels) {
    if (!(length > 0.0)) throw std::invalid_argument("order: an element length that is not > 0");
    known = known && error > 0.0 && std::isfinite(error);
    mean_length += std::log(length) / static_cast<double>(levels.size());
    mean_error += std::log(error) / static_cast<double>(levels.size());
  }
  double spread = 0.0;
  double rise = 0.0;
  for (const auto& [length, error] : levels) {
    const double distance = std::log(length) - mean_length;
    spread += distance * distance;
    rise += distance * (std::log(error) - mean_error);
  }
  // Equal lengths are apart by rounding only.
  if (!(spread > 1e-20)) throw std::invalid_argument("order: all levels have the same length");
  return known ? rise / spread : std::numeric_limits<double>::quiet_NaN();
}

double observed_order(const LevelError& coarse, const LevelError& fine) {
  return fitted_order(std::array{coarse, fine});
}

}  // namespace porowave::verification
