#include "verification/wave_measures/cosine_spectrum.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <thread>

BOOST_AUTO_TEST_SUITE(cosine_spectrum)

using namespace porowave::verification;

namespace {

std::vector<double> random_values(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<double> values(count);
  for (double& v : values) v = uniform(random);
  return values;
}

/// cos(pi k x/L) at the places of n cells.
std::vector<double> cosine(std::size_t cells, std::size_t k, Places places) {
  std::vector<double> values(places == Places::nodes ? cells + 1 : cells);
  const double offset = places == Places::nodes ? 0.0 : 0.5;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double x = (static_cast<double>(i) + offset) / static_cast<double>(cells);
    values[i] = std::cos(std::numbers::pi * static_cast<double>(k) * x);
  }
  return values;
}

double weighted_squares(const std::vector<double>& v, Places places) {
  double sum = std::inner_product(v.begin(), v.end(), v.begin(), 0.0);
  if (places == Places::nodes) sum -= 0.5 * (v.front() * v.front() + v.back() * v.back());
  return sum;
}

}  // namespace

BOOST_AUTO_TEST_CASE(energies_add_up_to_the_squares_of_the_values) {
  for (const Places places : {Places::cell_middles, Places::nodes}) {
    for (const std::size_t size : {2u, 3u, 7u, 64u, 101u, 400u, 1009u}) {
      const auto values = random_values(size, 3);
      const auto energy = porowave::verification::cosine_spectrum(values, places);
      BOOST_TEST(energy.size() == size);
      BOOST_TEST(
          std::accumulate(energy.begin(), energy.end(), 0.0) == weighted_squares(values, places),
          boost::test_tools::tolerance(1e-12));
    }
  }
  BOOST_TEST(porowave::verification::cosine_spectrum(std::vector{-3.0}, Places::cell_middles) ==
                 std::vector{9.0},
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_cosine_has_all_its_energy_in_one_place) {
  constexpr std::size_t cells = 24;
  for (const Places places : {Places::cell_middles, Places::nodes}) {
    const std::size_t most = places == Places::nodes ? cells : cells - 1;
    for (std::size_t k = 0; k <= most; ++k) {
      const auto energy = porowave::verification::cosine_spectrum(cosine(cells, k, places), places);
      const double own = k == 0 || k == cells ? cells : 0.5 * cells;
      for (std::size_t m = 0; m < energy.size(); ++m) {
        BOOST_TEST(std::abs(energy[m] - (m == k ? own : 0.0)) < 1e-12);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_straight_line_leaks_with_the_fourth_power) {
  // Mirrored it is a triangle: amplitudes fall as k^-2 for odd k, and there are no others.
  std::vector<double> line(401);
  std::iota(line.begin(), line.end(), 0.0);
  const auto energy = porowave::verification::cosine_spectrum(line, Places::nodes);
  BOOST_TEST(energy[1] / energy[3] == 81.0, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(energy[3] / energy[9] == 81.0, boost::test_tools::tolerance(1e-2));
  BOOST_TEST(energy[2] < 1e-20 * energy[1]);
}

BOOST_AUTO_TEST_CASE(threads_get_the_same_numbers) {
  constexpr std::size_t sizes = 60;
  std::vector<std::vector<double>> alone(sizes);
  const auto run = [](std::vector<std::vector<double>>& results, Places places) {
    for (std::size_t i = 0; i < sizes; ++i) {
      results[i] = porowave::verification::cosine_spectrum(random_values(40 + 7 * i, 11), places);
    }
  };
  std::array<std::vector<std::vector<double>>, 4> together;
  together.fill(alone);
  {
    std::vector<std::jthread> threads;
    for (auto& results : together) threads.emplace_back(run, std::ref(results), Places::nodes);
  }
  run(alone, Places::nodes);
  for (const auto& results : together) BOOST_TEST((results == alone));
}

BOOST_AUTO_TEST_CASE(no_cell_is_refused) {
  BOOST_CHECK_THROW(porowave::verification::cosine_spectrum({}, Places::cell_middles),
                    std::invalid_argument);
  BOOST_CHECK_THROW(porowave::verification::cosine_spectrum(std::vector{1.0}, Places::nodes),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
