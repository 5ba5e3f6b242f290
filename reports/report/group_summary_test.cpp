#include "reports/report/group_summary.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reports/report/report_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(group_summary)

using namespace porowave;
using namespace porowave::reports;
using namespace porowave::reports::report_fixtures;
namespace tt = boost::test_tools;

BOOST_AUTO_TEST_CASE(means_ranges_and_orders_of_made_up_errors) {
  const auto table = case_tables(full_study()).front();
  const auto summaries = summaries_of(table, 1);
  BOOST_REQUIRE(summaries.size() == 4u);
  for (std::size_t g = 0; g < 4; ++g) {
    const double order = g < 2 ? 1.0 : 2.0;
    const double coarsest = 0.1 * (g % 2 == 0 ? 2.0 : 3.0);
    const LevelSummary& finest = summaries[g].finest();
    BOOST_TEST(finest.error == coarsest * std::pow(0.125, order), tt::tolerance(1e-12));
    BOOST_TEST(finest.low == finest.error * std::exp(-0.1), tt::tolerance(1e-12));
    BOOST_TEST(finest.high == finest.error * std::exp(0.1), tt::tolerance(1e-12));
    BOOST_TEST(summaries[g].order.order == order, tt::tolerance(1e-9));
    BOOST_TEST(finest.ns_per_point_step == 10.0, tt::tolerance(1e-9));
    BOOST_TEST(finest.points == 1600.0);
    BOOST_TEST(finest.cpu_seconds == 1e-8 * 200.0 * 1600.0, tt::tolerance(1e-12));
    BOOST_TEST(summaries[g].cases == 12u);
    BOOST_TEST(summaries[g].ended == 12u);
    BOOST_TEST(summaries[g].finest_error() == finest.error);
  }
  BOOST_TEST(order_text(summaries[3].order) == "2.000 ± 0.000");
}

BOOST_AUTO_TEST_CASE(a_broken_case_leaves_no_error_of_its_group) {
  auto rows = full_study();
  rows[3] = broken(rows[3]);  // finest level of the first group
  const auto table = case_tables(rows).front();
  const auto summaries = summaries_of(table, 0);
  BOOST_TEST(std::isnan(summaries[0].finest_error()));
  BOOST_TEST(summaries[0].finest().ended == 2u);
  BOOST_TEST(summaries[0].finest().error == 0.025 * std::exp(0.05), tt::tolerance(1e-12));
  BOOST_TEST(order_text(summaries[0].order) == "errors missing");
  BOOST_TEST(!std::isnan(summaries[1].finest_error()));
}

BOOST_AUTO_TEST_CASE(measures_at_the_points_where_there_are_no_others) {
  auto record = row({}, 0.1);
  for (std::size_t m = 0; m < record.measures.size(); ++m) {
    if (verification::measure_names()[m].find("_field_") != std::string::npos) {
      record.measures[m] = NAN;
    }
  }
  const auto names = [](const std::vector<verification::Record>& rows) {
    return verification::measure_names()[measures_of(case_tables(rows).front()).front()];
  };
  BOOST_TEST(names({record}) == "effective_stress_points_l2");
  BOOST_TEST(names({row({}, 0.1)}) == "effective_stress_field_l2");
  BOOST_TEST(measure_title("pore_pressure_points_linf") == "pore pressure, points, L∞");
}

BOOST_AUTO_TEST_SUITE_END()
