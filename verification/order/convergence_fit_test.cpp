#include "verification/order/convergence_fit.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>

#include "verification/order/manufactured_tables.hpp"

BOOST_AUTO_TEST_SUITE(convergence_fit)

using namespace porowave::verification;
using namespace porowave::verification::manufactured;

BOOST_AUTO_TEST_CASE(a_power_is_found_exactly_whatever_the_ratios_and_the_sign_of_its_order) {
  for (const double order : {2.0, 0.5, 0.0, -1.5, 7.0}) {
    const LogMeans levels =
        log_means(table_of(unequal, [&](double h) { return 3.0 * std::pow(h, order); }));
    const ConvergenceFit fit = fit_power(levels);
    BOOST_TEST(std::abs(fit.order - order) < 1e-12);
    BOOST_TEST(std::abs(fit.log_constant - std::log(3.0)) < 1e-11);
    BOOST_TEST(fit.floor == 0.0);
    for (const double pair : pairwise_orders(levels)) BOOST_TEST(std::abs(pair - order) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(order_and_floor_are_found_in_one_fit) {
  for (const double floor : {1e-5, 3e-5, 1e-3}) {
    const LogMeans levels =
        log_means(table_of(unequal, [&](double h) { return 0.7 * h * h + floor; }));
    const ConvergenceFit fit = fit_convergence(levels);
    BOOST_TEST_CONTEXT("floor " << floor) {
      BOOST_TEST(fit.order == 2.0, boost::test_tools::tolerance(1e-6));
      BOOST_TEST(fit.floor == floor, boost::test_tools::tolerance(1e-6));
      BOOST_TEST(fit.log_error(std::log(0.03)) == std::log(0.7 * 0.0009 + floor),
                 boost::test_tools::tolerance(1e-8));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_higher_order_term_is_no_floor) {
  for (const double coefficient : {-2.0, 0.5, 2.0}) {
    const LogMeans levels =
        log_means(table_of(halved, [&](double h) { return h * h * (1.0 + coefficient * h); }));
    BOOST_TEST(fit_convergence(levels).floor == 0.0);
  }
}

BOOST_AUTO_TEST_CASE(noise_is_no_floor_but_once_in_fifty_times) {
  int floors = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    const auto square = [](double h) { return h * h; };
    floors += fit_convergence(log_means(noisy_table(halved, square, 0.1, 8, seed))).floor > 0.0;
  }
  BOOST_TEST(floors <= 8);
}

BOOST_AUTO_TEST_CASE(certain_levels_weigh_more) {
  const LogMeans levels{{0.0, -1.0, -2.0}, {0.0, -2.0, -5.0}, {1e-8, 1e-8, 100.0}};
  const LogMeans equal{levels.log_spacing, levels.mean, {1.0, 1.0, 1.0}};
  BOOST_TEST(fit_power(equal).order == 2.5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(fit_power(levels).order < 2.4);  // the two certain levels have 2
}

BOOST_AUTO_TEST_CASE(too_few_or_not_finite_levels_are_refused) {
  const auto square = [](double h) { return h * h; };
  BOOST_CHECK_THROW(fit_power(log_means(table_of({0.1}, square))), std::invalid_argument);
  BOOST_CHECK_THROW(fit_with_floor(log_means(table_of({0.3, 0.2, 0.1}, square))),
                    std::invalid_argument);
  BOOST_CHECK_THROW(fit_power(log_means({{0.2, 0.1}, {{1.0}, {std::nan("")}}})),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
