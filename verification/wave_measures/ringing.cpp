#include "verification/wave_measures/ringing.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "verification/not_a_number.hpp"

namespace porowave::verification {

namespace {

double sum_of_squares(std::span<const double> values, Places places) {
  const double sum = std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
  if (places == Places::cell_middles) return sum;
  return sum - 0.5 * (values.front() * values.front() + values.back() * values.back());
}

}  // namespace

Ringing ringing(std::span<const double> values, std::span<const double> reference, Places places) {
  if (values.size() != reference.size()) {
    throw std::invalid_argument("ringing: as many values as references");
  }
  std::vector<double> error(values.begin(), values.end());
  for (std::size_t i = 0; i < error.size(); ++i) error[i] -= reference[i];
  const std::vector<double> energy = cosine_spectrum(error, places);
  const std::size_t cells = places == Places::nodes ? values.size() - 1 : values.size();
  const auto shorter = energy.begin() + static_cast<std::ptrdiff_t>(cells / 2 + 1);
  const double in_short = std::accumulate(shorter, energy.end(), 0.0);
  const double in_long = std::accumulate(energy.begin(), shorter, 0.0);
  const double of_reference = sum_of_squares(reference, places);
  if (!std::isfinite(in_short + in_long) || !std::isfinite(of_reference)) return {nan, nan};
  const double all = in_short + in_long;
  const double nothing = in_short == 0.0 ? 0.0 : nan;
  return {of_reference > 0.0 ? std::sqrt(in_short / of_reference) : nothing,
          all > 0.0 ? in_short / all : 0.0};
}

}  // namespace porowave::verification
