#include "verification/order/richardson.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(richardson)

using namespace porowave::verification;

BOOST_AUTO_TEST_CASE(order_limit_and_index_of_a_power_are_exact) {
  const std::array<double, 3> h = {0.1, 0.06, 0.02};
  for (const double order : {0.7, 1.0, 2.0, 4.0}) {
    std::array<double, 3> value{};
    for (std::size_t i = 0; i < 3; ++i) value[i] = 5.0 + 2.0 * std::pow(h[i], order);
    const Richardson found = extrapolate(h, value, 1.25);
    BOOST_TEST(found.order == order, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(found.extrapolated == 5.0, boost::test_tools::tolerance(1e-11));
    BOOST_TEST(found.gci == 1.25 * 2.0 * std::pow(0.02, order) / value[2],
               boost::test_tools::tolerance(1e-8));
    BOOST_TEST(!found.oscillating);
  }
}

BOOST_AUTO_TEST_CASE(values_that_go_to_and_fro_are_named) {
  BOOST_TEST(extrapolate({0.4, 0.2, 0.1}, {1.0, 1.4, 1.3}).oscillating);
}

BOOST_AUTO_TEST_CASE(values_that_do_not_converge_have_no_order) {
  BOOST_TEST(std::isnan(extrapolate({0.4, 0.2, 0.1}, {1.0, 1.1, 1.3}).order));
  BOOST_TEST(std::isnan(extrapolate({0.4, 0.2, 0.1}, {1.0, 1.0, 1.3}).gci));
}

BOOST_AUTO_TEST_CASE(wrong_arguments_are_refused) {
  BOOST_CHECK_THROW(extrapolate({0.1, 0.2, 0.4}, {1.0, 2.0, 3.0}), std::invalid_argument);
  BOOST_CHECK_THROW(extrapolate({0.4, 0.2, 0.0}, {1.0, 2.0, 3.0}), std::invalid_argument);
  BOOST_CHECK_THROW(extrapolate({0.4, 0.2, 0.1}, {1.0, std::nan(""), 3.0}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
