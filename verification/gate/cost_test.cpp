#include "verification/gate/cost.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "verification/gate/gate_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(cost)

using namespace porowave;
using namespace porowave::verification;
using gate_fixtures::scattered;
using gate_fixtures::Trial;

namespace {

const std::string rules = "[gate]\nmeasures = [\"pore_pressure_field_l2\"]\ncost_tolerance = 0.5\n";

/// Groups whose point and step costs `cost` points of the loop on a machine of some speed, with a
/// scatter of 3 %.
std::vector<Group> groups_of_cost(
    const Trial& trial, double cost, double speed,
    const std::function<void(Record&)>& edit = [](Record&) {}) {
  int row = 0;
  const Store store =
      trial.store_with([](const auto& d) { return scattered(d, 2.0); },
                       [&](Record& record) {
                         record.points = 100;
                         record.steps = 10;
                         record.calibration_ns = 0.4 * speed;
                         const double noise = std::exp(0.03 * std::sin(2.3 * ++row));
                         record.cpu_seconds = 1e-9 * 1000.0 * cost * record.calibration_ns * noise;
                         edit(record);
                         return true;
                       });
  return groups_of(trial.study, store);
}

std::vector<Verdict> verdicts_of(const Trial& trial, const std::vector<Group>& groups) {
  const Baseline baseline = rebaselined(groups_of_cost(trial, 8.0, 1.0), trial.rules, std::nullopt,
                                        "2026-01-01", "first");
  // As it comes from the file.
  return judge_costs(groups, trial.rules, baseline_of_text(baseline_text(baseline), "b.csv"));
}

void check(const Verdict& verdict, VerdictKind kind, const std::string& words) {
  BOOST_TEST(to_string(verdict.kind) == to_string(kind), verdict.reason);
  BOOST_TEST(verdict.reason.find(words) != std::string::npos, verdict.reason);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_slower_machine_costs_no_more_and_a_slower_solver_does) {
  const Trial trial(rules);
  check(verdicts_of(trial, groups_of_cost(trial, 8.0, 1.0))[0], VerdictKind::pass, "1.00 times");
  check(verdicts_of(trial, groups_of_cost(trial, 8.0, 3.0))[0], VerdictKind::pass, "1.00 times");
  check(verdicts_of(trial, groups_of_cost(trial, 11.0, 1.0))[0], VerdictKind::pass, "1.3");
  check(verdicts_of(trial, groups_of_cost(trial, 16.0, 1.0))[0], VerdictKind::fail, "2.00 times");
  check(verdicts_of(trial, groups_of_cost(trial, 16.0, 1.0)).back(), VerdictKind::fail,
        "2.00 times");
  check(verdicts_of(trial, groups_of_cost(trial, 4.0, 1.0))[0], VerdictKind::fail, "rebaseline");
}

BOOST_AUTO_TEST_CASE(some_measurements_that_are_far_too_large_do_not_matter) {
  const Trial trial(rules);
  int row = 0;
  const auto groups = groups_of_cost(trial, 8.0, 1.0, [&](Record& record) {
    if (++row % 4 == 0) record.cpu_seconds *= 10.0;
  });
  check(verdicts_of(trial, groups)[0], VerdictKind::pass, "1.0");
}

BOOST_AUTO_TEST_CASE(one_group_that_has_become_slow_is_named) {
  const Trial trial(rules);
  int row = 0;
  const auto groups = groups_of_cost(trial, 8.0, 1.0, [&](Record& record) {
    if (++row > 12) record.cpu_seconds *= 2.0;  // the second kernel
  });
  const auto verdicts = verdicts_of(trial, groups);
  BOOST_REQUIRE(verdicts.size() == 3U);
  check(verdicts[0], VerdictKind::pass, "1.00 times");
  check(verdicts[1], VerdictKind::fail, "2.00 times");
  BOOST_TEST(verdicts[1].group.find("bspline2") != std::string::npos);
  check(verdicts[2], VerdictKind::pass, "1.41 times");
}

BOOST_AUTO_TEST_CASE(what_was_not_measured_is_inconclusive) {
  const Trial trial(rules);
  const auto unmeasured = groups_of_cost(trial, 8.0, 1.0, [](Record& record) {
    record.calibration_ns = std::numeric_limits<double>::quiet_NaN();
  });
  check(verdicts_of(trial, unmeasured)[0], VerdictKind::inconclusive, "no cost");
  check(judge_costs(groups_of_cost(trial, 8.0, 1.0), trial.rules, std::nullopt)[0],
        VerdictKind::inconclusive, "nothing to compare with");
  const Trial silent("[gate]\nmeasures = [\"pore_pressure_field_l2\"]\n");
  BOOST_TEST(judge_costs(groups_of_cost(silent, 8.0, 1.0), silent.rules, std::nullopt).empty());
}

BOOST_AUTO_TEST_SUITE_END()
