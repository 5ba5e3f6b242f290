#include "verification/gate/observation.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "verification/gate/gate_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(observation)

using namespace porowave::verification;

BOOST_AUTO_TEST_CASE(cases_that_differ_in_level_and_seed_make_a_group) {
  const gate_fixtures::Trial trial;
  const auto groups = groups_of(trial.study, trial.store_with([](const auto&) { return 0.5; }));
  BOOST_REQUIRE(groups.size() == 2U);
  BOOST_TEST(groups[1].name == "discretization.kernel = \"bspline2\"");
  BOOST_TEST(groups[0].cases == 12U);
  BOOST_TEST(groups[0].missing.empty());
  BOOST_TEST(groups[0].broken.empty());
  const std::vector<double> spacing = {1.0 / 50, 1.0 / 100, 1.0 / 200};
  BOOST_TEST(groups[0].spacing == spacing, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(errors_stand_at_their_level_and_seed) {
  const gate_fixtures::Trial trial;
  const auto groups = groups_of(trial.study, trial.store_with([](const auto& d) {
    return d.elements + 0.1 * static_cast<double>(d.seed);
  }));
  const ErrorTable table = errors_of(groups[0], *measure_index("pore_pressure_field_l2"));
  for (std::size_t level = 0; level < 3; ++level) {
    for (std::size_t seed = 0; seed < 4; ++seed) {
      BOOST_TEST(table.errors[level][seed] ==
                 std::round(1.0 / table.spacing[level]) + 0.1 * static_cast<double>(seed + 1));
    }
  }
}

BOOST_AUTO_TEST_CASE(missing_failed_and_broken_cases_are_told_apart) {
  const gate_fixtures::Trial trial;
  int row = 0;
  const auto groups =
      groups_of(trial.study, trial.store_with([](const auto&) { return 0.5; },
                                              [&](Record& record) {
                                                ++row;
                                                if (row == 2) record.status = CaseStatus::failed;
                                                if (row == 3)
                                                  record.status = CaseStatus::broke_down;
                                                return row != 1;  // the first is not stored
                                              }));
  BOOST_TEST(groups[0].missing.size() == 2U);
  BOOST_TEST(groups[0].broken.size() == 1U);
  const ErrorTable table = errors_of(groups[0], *measure_index("pore_pressure_field_l2"));
  BOOST_TEST(std::isnan(table.errors[0][0]));
}

BOOST_AUTO_TEST_SUITE_END()
