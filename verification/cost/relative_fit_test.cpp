#include "verification/cost/relative_fit.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

BOOST_AUTO_TEST_SUITE(relative_fit)

using porowave::verification::Measurement;
using porowave::verification::relative_fit;

BOOST_AUTO_TEST_CASE(an_exact_sum_gives_its_constants_back) {
  std::vector<Measurement> measurements;
  for (const double n : {10.0, 20.0, 40.0, 80.0}) {
    for (const double width : {1.0, 2.0}) {
      measurements.push_back(
          {{1.0, n, n * n, width * n * n, 0.0}, 3e-4 + 2e-6 * n + (1e-8 + 4e-9 * width) * n * n});
    }
  }
  const auto constants = relative_fit(measurements);
  BOOST_REQUIRE(constants.size() == 5U);
  BOOST_TEST(constants[0] == 3e-4, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(constants[1] == 2e-6, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(constants[2] == 1e-8, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(constants[3] == 4e-9, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(constants[4] == 0.0);
  BOOST_TEST(relative_fit({}).empty());
}

BOOST_AUTO_TEST_CASE(relative_errors_count_not_seconds) {
  // One constant c: the least sum of (c/v - 1)^2 is at (1/v1 + 1/v2) / (1/v1^2 + 1/v2^2).
  const std::vector<Measurement> two = {{{1.0}, 1.0}, {{1.0}, 100.0}};
  BOOST_TEST(relative_fit(two)[0] == 1.01 / 1.0001, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(no_constant_is_negative_and_the_others_are_the_best_without_it) {
  // v = 2x - 1/2: free of bounds the constant term would be negative.
  std::vector<Measurement> measurements;
  std::vector<Measurement> slope_only;
  for (const double x : {1.0, 2.0, 3.0}) {
    measurements.push_back({{1.0, x}, 2.0 * x - 0.5});
    slope_only.push_back({{x}, 2.0 * x - 0.5});
  }
  const auto constants = relative_fit(measurements);
  BOOST_TEST(constants[0] == 0.0);
  BOOST_TEST(constants[1] == relative_fit(slope_only)[0], boost::test_tools::tolerance(1e-10));
}

BOOST_AUTO_TEST_SUITE_END()
