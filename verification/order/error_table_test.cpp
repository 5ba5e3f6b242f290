#include "verification/order/error_table.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(error_table)

using namespace porowave::verification;

BOOST_AUTO_TEST_CASE(means_are_of_logarithms_and_their_variance_of_the_mean) {
  const LogMeans levels = log_means({{0.5, 0.25}, {{1.0, 4.0}, {3.0, 3.0}}});
  BOOST_TEST(levels.mean[0] == std::log(2.0), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(levels.variance[0] == std::pow(std::log(2.0), 2), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(levels.mean[1] == std::log(3.0), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(levels.variance[1] == 0.0);
}

BOOST_AUTO_TEST_CASE(one_error_that_is_not_positive_and_finite_spoils_its_level_only) {
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    const LogMeans levels = log_means({{0.5, 0.25}, {{1.0, bad}, {3.0, 3.0}}});
    BOOST_TEST(std::isnan(levels.mean[0]));
    BOOST_TEST(std::isfinite(levels.mean[1]));
  }
}

BOOST_AUTO_TEST_CASE(resampling_keeps_columns_together) {
  const ErrorTable table{{0.5, 0.25, 0.125}, {{1.0, 2.0}, {3.0, 4.0}, {5.0, 6.0}}};
  const ErrorTable sample = resampled(table, 1, {1, 1, 0});
  BOOST_TEST(sample.spacing == (std::vector<double>{0.25, 0.125}),
             boost::test_tools::per_element());
  BOOST_TEST(sample.errors[0] == (std::vector<double>{4.0, 4.0, 3.0}),
             boost::test_tools::per_element());
  BOOST_TEST(sample.errors[1] == (std::vector<double>{6.0, 6.0, 5.0}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(ill_formed_tables_are_refused) {
  BOOST_CHECK_THROW(log_means({{0.5, 0.5}, {{1.0}, {1.0}}}), std::invalid_argument);
  BOOST_CHECK_THROW(log_means({{0.5, -0.1}, {{1.0}, {1.0}}}), std::invalid_argument);
  BOOST_CHECK_THROW(log_means({{0.5, 0.25}, {{1.0}}}), std::invalid_argument);
  BOOST_CHECK_THROW(log_means({{0.5, 0.25}, {{1.0, 2.0}, {1.0}}}), std::invalid_argument);
  BOOST_CHECK_THROW(log_means({{0.5}, {{}}}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
