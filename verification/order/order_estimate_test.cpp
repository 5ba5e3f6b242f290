#include "verification/order/order_estimate.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "verification/order/manufactured_tables.hpp"

BOOST_AUTO_TEST_SUITE(order_estimate)

using namespace porowave::verification;
using namespace porowave::verification::manufactured;

namespace {

double square(double h) {
  return h * h;
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_exact_power_has_an_interval_of_no_width) {
  for (const double order : {2.0, 1.0, 3.0, 0.0, -1.0}) {
    const auto found =
        estimate_order(table_of(unequal, [&](double h) { return std::pow(h, order); }));
    BOOST_CHECK(found.status == OrderStatus::observed);
    BOOST_TEST(std::abs(found.order - order) < 1e-12);
    BOOST_TEST(found.high - found.low < 1e-11);
    BOOST_TEST(found.first_level == 0U);
  }
}

BOOST_AUTO_TEST_CASE(a_floor_does_not_lower_the_order_until_it_hides_it) {
  const auto found = estimate_order(table_of(halved, [](double h) { return h * h + 4e-5; }));
  BOOST_CHECK(found.status == OrderStatus::observed);
  BOOST_TEST(std::abs(found.order - 2.0) < 1e-4);
  BOOST_TEST(std::abs(found.floor - 4e-5) < 1e-8);
  const auto hidden = estimate_order(table_of(halved, [](double h) { return h * h + 1e-3; }));
  BOOST_CHECK(hidden.status == OrderStatus::at_floor);
}

BOOST_AUTO_TEST_CASE(coarse_levels_before_the_asymptotic_range_are_left_out) {
  // Errors of 100 % on grids too coarse to see anything, then second order.
  const std::vector<double> many = {0.8, 0.4, 0.2, 0.1, 0.05, 0.025, 0.0125};
  const auto found =
      estimate_order(table_of(many, [](double h) { return h * h / (0.01 + h * h); }));
  BOOST_CHECK(found.status == OrderStatus::observed);
  BOOST_TEST(found.first_level >= 3U);
  BOOST_TEST(std::abs(found.order - 2.0) < 0.2);
}

BOOST_AUTO_TEST_CASE(errors_that_go_up_and_down_have_no_order) {
  int level = 0;
  const auto found = estimate_order(
      table_of(halved, [&](double h) { return h * h * (++level % 2 == 0 ? 2.0 : 0.5); }));
  BOOST_CHECK(found.status == OrderStatus::not_asymptotic);
  BOOST_TEST(std::isnan(found.order));
}

BOOST_AUTO_TEST_CASE(a_hole_in_the_table_is_never_passed_over) {
  ErrorTable table = table_of(halved, square);
  table.errors[2][0] = std::nan("");
  const auto found = estimate_order(table);
  BOOST_CHECK(found.status == OrderStatus::not_finite);
  BOOST_TEST(std::isnan(found.order));
  BOOST_CHECK(estimate_order(table_of({0.2, 0.1}, square)).status == OrderStatus::too_few_levels);
}

BOOST_AUTO_TEST_CASE(growing_errors_have_a_negative_order) {
  const auto found = estimate_order(table_of(halved, [](double h) { return 1.0 / h; }));
  BOOST_TEST(found.order < -0.9);
  BOOST_TEST(found.high < 0.0);
}

BOOST_AUTO_TEST_CASE(intervals_hold_the_true_order_as_often_as_they_say) {
  for (const int replicates : {4, 8, 16}) {
    int held = 0;
    constexpr int trials = 400;
    OrderOptions options;
    options.resamples = 400;
    for (int trial = 0; trial < trials; ++trial) {
      const auto found = estimate_order(
          noisy_table(halved, square, 0.15, replicates, static_cast<unsigned>(1000 + trial)),
          options);
      held += found.status == OrderStatus::observed && found.low <= 2.0 && 2.0 <= found.high;
    }
    BOOST_TEST_MESSAGE(replicates << " replicates: 95 % intervals hold the order in "
                                  << 100.0 * held / trials << " % of " << trials << " tables");
    BOOST_TEST(held >= 0.91 * trials);
    BOOST_TEST(held <= 0.99 * trials);
  }
}

BOOST_AUTO_TEST_CASE(the_same_table_and_seed_give_the_same_interval) {
  const ErrorTable table = noisy_table(halved, square, 0.2, 6, 7);
  const auto once = estimate_order(table);
  const auto again = estimate_order(table);
  BOOST_TEST(once.low == again.low);
  BOOST_TEST(once.high == again.high);
  BOOST_TEST(once.low < once.high);
}

BOOST_AUTO_TEST_SUITE_END()
