#include "verification/order.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

using porowave::verification::fitted_order;
using porowave::verification::LevelError;
using porowave::verification::observed_order;

BOOST_AUTO_TEST_SUITE(order)

BOOST_AUTO_TEST_CASE(a_power_of_the_length_has_its_exponent) {
  for (const double exponent : {-1.0, 0.0, 0.5, 2.0, 4.0}) {
    std::vector<LevelError> levels;
    for (const double h : {0.1, 0.07, 0.02, 0.0199}) {
      levels.push_back({h, 3.0 * std::pow(h, exponent)});
    }
    BOOST_TEST(std::abs(fitted_order(levels) - exponent) < 1e-12);
    BOOST_TEST(std::abs(observed_order(levels[0], levels[2]) - exponent) < 1e-12);
  }
}

// Divergence must not look like convergence, in whatever sequence the levels come.
BOOST_AUTO_TEST_CASE(an_error_that_grows_has_a_negative_order) {
  BOOST_TEST(std::abs(observed_order({0.2, 1.0}, {0.1, 4.0}) + 2.0) < 1e-12);
  BOOST_TEST(std::abs(observed_order({0.1, 4.0}, {0.2, 1.0}) + 2.0) < 1e-12);
}

// Ratios of 2 and of 3: the second pair weighs more because it is longer.
BOOST_AUTO_TEST_CASE(the_fit_is_that_of_least_squares) {
  const std::vector<LevelError> levels = {{6.0, 1.0}, {3.0, 0.5}, {1.0, 0.5 / 9.0}};
  const double a = std::log(2.0);
  const double b = std::log(3.0);
  // Slope of the points (a+b, a+2b), (b, 2b), (0, 0) by the normal equations.
  const double sx = a + 2.0 * b;
  const double sy = a + 4.0 * b;
  const double sxy = (a + b) * (a + 2.0 * b) + 2.0 * b * b;
  const double sxx = (a + b) * (a + b) + b * b;
  const double expected = (3.0 * sxy - sx * sy) / (3.0 * sxx - sx * sx);
  BOOST_TEST(std::abs(fitted_order(levels) - expected) < 1e-12);
  BOOST_TEST(expected > 1.5);
}

BOOST_AUTO_TEST_CASE(an_error_that_is_not_a_positive_number_gives_no_order) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), 0.0, -1.0}) {
    BOOST_TEST(std::isnan(observed_order({0.2, bad}, {0.1, 1.0})));
    BOOST_TEST(std::isnan(observed_order({0.2, 1.0}, {0.1, bad})));
  }
}

BOOST_AUTO_TEST_CASE(levels_that_cannot_be_compared_are_refused) {
  BOOST_CHECK_THROW(fitted_order(std::vector<LevelError>{{0.1, 1.0}}), std::invalid_argument);
  BOOST_CHECK_THROW(observed_order({0.1, 1.0}, {0.1, 0.5}), std::invalid_argument);
  BOOST_CHECK_THROW(observed_order({0.1, 1.0}, {0.0, 0.5}), std::invalid_argument);
  BOOST_CHECK_THROW(observed_order({-0.1, 1.0}, {0.2, 0.5}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
