#include "reference/sine_transform.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

BOOST_AUTO_TEST_SUITE(sine_transform)

using namespace porowave::reference;

BOOST_AUTO_TEST_CASE(the_transform_is_the_sum_with_fewer_and_with_more_amplitudes_than_nodes) {
  for (const std::size_t intervals : {1u, 2u, 5u, 16u}) {
    for (const std::size_t count : {0u, 1u, 3u, 16u, 41u, 100u}) {
      std::vector<double> amplitudes(count);
      for (std::size_t n = 0; n < count; ++n) {
        amplitudes[n] = std::cos(7.0 * static_cast<double>(n * n));
      }
      const auto sines = quarter_wave_sines(amplitudes, intervals);
      const auto cosines = quarter_wave_cosines(amplitudes, intervals);
      BOOST_REQUIRE(sines.size() == intervals + 1);
      BOOST_REQUIRE(cosines.size() == intervals + 1);
      for (std::size_t j = 0; j <= intervals; ++j) {
        double sine = 0.0;
        double cosine = 0.0;
        for (std::size_t n = 0; n < count; ++n) {
          const double phase = (static_cast<double>(n) + 0.5) * std::numbers::pi *
                               static_cast<double>(j) / static_cast<double>(intervals);
          sine += amplitudes[n] * std::sin(phase);
          cosine += amplitudes[n] * std::cos(phase);
        }
        BOOST_TEST(std::abs(sines[j] - sine) < 1e-11);
        BOOST_TEST(std::abs(cosines[j] - cosine) < 1e-11);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
