#include "verification/wave_measures/overshoot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "verification/not_a_number.hpp"

namespace porowave::verification {

namespace {

double total_variation(std::span<const double> values) {
  double sum = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i) sum += std::abs(values[i] - values[i - 1]);
  return sum;
}

}  // namespace

Overshoot overshoot(std::span<const double> values, std::span<const double> reference) {
  if (values.empty() || values.size() != reference.size()) {
    throw std::invalid_argument("overshoot: as many values as references, at least one");
  }
  const double variation = total_variation(values);
  const double reference_variation = total_variation(reference);
  // Only sums keep a NaN.
  if (!std::isfinite(variation + values[0]) || !std::isfinite(reference_variation + reference[0])) {
    return {nan, nan};
  }
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const auto [bottom, top] = std::minmax_element(reference.begin(), reference.end());
  const double excess = std::max({0.0, *high - *top, *bottom - *low});
  if (reference_variation > 0.0)
    return {excess / (*top - *bottom), variation / reference_variation};
  if (excess == 0.0) return {};
  return {nan, nan};
}

}  // namespace porowave::verification
