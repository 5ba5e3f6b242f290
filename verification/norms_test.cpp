#include "verification/norms.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(norms)

using porowave::verification::Norms;
using porowave::verification::relative_norms;
namespace tt = boost::test_tools;

BOOST_AUTO_TEST_CASE(they_follow_their_definition) {
  const std::vector<double> values = {1.0, -2.0, 5.0};
  const std::vector<double> reference = {2.0, -2.0, 1.0};
  const std::vector<double> weights = {1.0, 10.0, 0.5};
  const Norms n = relative_norms(values, reference, weights);
  BOOST_TEST(n.l1 == (1.0 * 1 + 0.5 * 4) / (1.0 * 2 + 10 * 2 + 0.5 * 1), tt::tolerance(1e-15));
  BOOST_TEST(n.l2 == std::sqrt((1.0 * 1 + 0.5 * 16) / (1.0 * 4 + 10 * 4 + 0.5 * 1)),
             tt::tolerance(1e-15));
  BOOST_TEST(n.linf == 4.0 / 2.0, tt::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(they_do_not_depend_on_units) {
  const std::vector<double> values = {1.0, -2.0, 5.0};
  const std::vector<double> reference = {2.0, -2.0, 1.0};
  const std::vector<double> weights = {1.0, 10.0, 0.5};
  const auto scaled = [](std::vector<double> v, double factor) {
    for (double& x : v) x *= factor;
    return v;
  };
  const Norms a = relative_norms(values, reference, weights);
  const Norms b =
      relative_norms(scaled(values, -1e-7), scaled(reference, -1e-7), scaled(weights, 1e3));
  BOOST_TEST(a.l1 == b.l1, tt::tolerance(1e-14));
  BOOST_TEST(a.l2 == b.l2, tt::tolerance(1e-14));
  BOOST_TEST(a.linf == b.linf, tt::tolerance(1e-14));
  for (const double unit : {1e-160, 1e-300, 1e160, 1e300}) {  // whose squares are no numbers
    const Norms c = relative_norms(scaled(values, unit), scaled(reference, unit), weights);
    BOOST_TEST(a.l2 == c.l2, tt::tolerance(1e-14));
    BOOST_TEST(a.linf == c.linf, tt::tolerance(1e-14));
  }
}

BOOST_AUTO_TEST_CASE(a_value_that_is_not_finite_never_looks_small) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double inf = std::numeric_limits<double>::infinity();
  const std::vector<double> ones = {1.0, 1.0, 1.0};
  for (const double bad : {nan, inf, -inf}) {
    for (const std::size_t place : {0u, 1u, 2u}) {
      std::vector<double> values = ones;
      values[place] = bad;
      for (const Norms& n :
           {relative_norms(values, ones, ones), relative_norms(ones, values, ones)}) {
        BOOST_TEST(std::isnan(n.l1));
        BOOST_TEST(std::isnan(n.l2));
        BOOST_TEST(std::isnan(n.linf));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_reference_at_rest_has_no_relative_error) {
  const std::vector<double> zero = {0.0, 0.0};
  const std::vector<double> ones = {1.0, 1.0};
  BOOST_TEST(std::isnan(relative_norms(ones, zero, ones).l2));
  BOOST_TEST(relative_norms(zero, zero, ones).l2 == 0.0);
}

BOOST_AUTO_TEST_CASE(lengths_must_agree) {
  const std::vector<double> one = {1.0};
  const std::vector<double> two = {1.0, 1.0};
  BOOST_CHECK_THROW(relative_norms(one, two, two), std::invalid_argument);
  BOOST_CHECK_THROW(relative_norms(two, two, one), std::invalid_argument);
  BOOST_CHECK_THROW(relative_norms({}, {}, {}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
