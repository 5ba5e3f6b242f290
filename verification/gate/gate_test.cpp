#include "verification/gate/gate.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/problem/errors.hpp"
#include "verification/gate/gate_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(gate)

using namespace porowave;
using namespace porowave::verification;
using gate_fixtures::scattered;
using gate_fixtures::Trial;

namespace {

const std::string theory = "[gate]\norder = 2.0\nmeasures = [\"pore_pressure_field_l2\"]\n";

double second_order(const solver::Discretization& d) {
  return scattered(d, 2.0);
}

Baseline baseline_of(const Trial& trial, const Trial::ErrorOf& error) {
  return rebaselined(trial.groups_with(error), trial.rules, std::nullopt, "2026-01-01", "first");
}

std::vector<Verdict> verdicts_of(const Trial& trial, const Trial::ErrorOf& error,
                                 const std::optional<Baseline>& baseline = std::nullopt) {
  return judge(trial.groups_with(error), trial.rules, baseline);
}

void check(const Verdict& verdict, VerdictKind kind, const std::string& words) {
  BOOST_TEST(to_string(verdict.kind) == to_string(kind));
  BOOST_TEST(verdict.reason.find(words) != std::string::npos,
             "\"" << verdict.reason << "\" lacks \"" << words << "\"");
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_order_of_theory_is_judged_to_both_sides) {
  const Trial trial(theory);
  const auto with_order = [](double order) {
    return [order](const solver::Discretization& d) { return scattered(d, order); };
  };
  check(verdicts_of(trial, with_order(2.0))[0], VerdictKind::pass, "observed order 2.0");
  check(verdicts_of(trial, with_order(1.5))[0], VerdictKind::fail, "too low");
  check(verdicts_of(trial, with_order(2.5))[0], VerdictKind::fail, "too high");
  check(verdicts_of(trial, with_order(-2.0))[0], VerdictKind::fail, "too low");
  check(verdicts_of(trial, with_order(1.76))[0], VerdictKind::inconclusive, "reaches beyond");
}

BOOST_AUTO_TEST_CASE(a_table_that_cannot_tell_is_inconclusive_and_says_why) {
  const Trial trial(theory);
  check(verdicts_of(trial, [](const auto& d) { return d.elements == 100 ? 1.0 : 0.01; })[0],
        VerdictKind::inconclusive, "not yet asymptotic");
  check(verdicts_of(trial, [](const auto& d) { return 1e-7 * scattered(d, 2.0); })[0],
        VerdictKind::pass, "order");
  check(verdicts_of(trial, [](const auto& d) { return 1e-9 * scattered(d, 2.0); })[0],
        VerdictKind::inconclusive, "reference-limited");
  check(verdicts_of(trial, [](const auto& d) { return d.seed == 2 ? std::nan("") : 0.1; })[0],
        VerdictKind::fail, "not a positive, finite number");
}

BOOST_AUTO_TEST_CASE(missing_cases_are_named_and_broken_ones_fail) {
  const Trial trial(theory);
  int row = 0;
  const auto verdicts =
      judge(groups_of(trial.study, trial.store_with(second_order,
                                                    [&](Record& record) {
                                                      ++row;
                                                      if (row == 15) {
                                                        record.status = CaseStatus::broke_down;
                                                        record.reason = "step 7: too large";
                                                      }
                                                      return row != 3;
                                                    })),
            trial.rules, std::nullopt);
  check(verdicts[0], VerdictKind::inconclusive, "incomplete: 1 of 12 cases missing");
  check(verdicts[0], VerdictKind::inconclusive, "discretization.elements = 200");
  check(verdicts[1], VerdictKind::fail, "1 of 12 cases did not end");
  check(verdicts[1], VerdictKind::fail, "step 7: too large");
}

BOOST_AUTO_TEST_CASE(the_same_errors_pass_the_baseline_and_small_changes_do_not) {
  const Trial trial("[gate]\nmeasures = [\"pore_pressure_field_l2\"]\n");
  const Baseline baseline = baseline_of(trial, second_order);
  check(verdicts_of(trial, second_order, baseline)[0], VerdictKind::pass, "order");
  const auto times = [](double factor) {
    return [factor](const solver::Discretization& d) {
      return d.elements == 200 ? factor * second_order(d) : second_order(d);
    };
  };
  check(verdicts_of(trial, times(1.005), baseline)[0], VerdictKind::pass, "order");
  check(verdicts_of(trial, times(1.02), baseline)[0], VerdictKind::fail, "level = 200");
  check(verdicts_of(trial, times(0.97), baseline)[0], VerdictKind::fail, "rebaseline");
}

BOOST_AUTO_TEST_CASE(errors_with_a_floor_pass_if_they_had_it_before) {
  const Trial trial("[gate]\nmeasures = [\"pore_pressure_field_l2\"]\n");
  const auto floor = [](const auto& d) { return 1e-3 * second_order(d) + 0.1; };
  const Baseline baseline = baseline_of(trial, floor);
  check(verdicts_of(trial, floor, baseline)[0], VerdictKind::pass, "");
  const auto other = [&](const auto& d) { return 1.02 * floor(d); };
  check(verdicts_of(trial, other, baseline)[0], VerdictKind::fail, "against the baseline");
  // An order that could be told before and no more is not passed over.
  Baseline with_order = baseline;
  for (auto& [key, expected] : with_order.expected) expected.order = 2.0;
  const VerdictKind kind = verdicts_of(trial, floor, with_order)[0].kind;
  BOOST_TEST((kind != VerdictKind::pass));
}

BOOST_AUTO_TEST_CASE(other_seeds_are_compared_by_their_scatter) {
  const Trial then("[gate]\nmeasures = [\"pore_pressure_field_l2\"]\n");
  const Trial now("[gate]\nmeasures = [\"pore_pressure_field_l2\"]\n", 101);
  const Baseline baseline = baseline_of(then, second_order);
  check(verdicts_of(now, second_order, baseline)[0], VerdictKind::pass, "order");
  const auto doubled = [](const auto& d) { return 2.0 * second_order(d); };
  check(verdicts_of(now, doubled, baseline)[0], VerdictKind::fail, "against the baseline");
}

BOOST_AUTO_TEST_CASE(known_failures_are_expected_to_stay) {
  const Trial trial(theory +
                    "[[known_failure]]\n\"discretization.kernel\" = \"bspline1\"\nreason = "
                    "\"issue 12\"\n");
  const auto first_order = [](const auto& d) { return scattered(d, 1.0); };
  const auto failing = verdicts_of(trial, first_order);
  check(failing[0], VerdictKind::xfail, "issue 12");
  check(failing[1], VerdictKind::fail, "too low");
  const auto passing = verdicts_of(trial, second_order);
  check(passing[0], VerdictKind::xpass, "issue 12");
  check(passing[1], VerdictKind::pass, "order");
}

BOOST_AUTO_TEST_CASE(nothing_to_compare_with_is_inconclusive) {
  const Trial trial("[gate]\nmeasures = [\"pore_pressure_field_l2\"]\n");
  check(verdicts_of(trial, second_order)[0], VerdictKind::inconclusive, "nothing to compare with");
  BOOST_TEST(exit_code({}) == 3);
}

// A renamed value or the wrong file would else be no check at all.
BOOST_AUTO_TEST_CASE(a_group_that_the_baseline_has_not_is_inconclusive_whatever_its_order) {
  const Trial trial("[gate]\norder = 2.0\nmeasures = [\"pore_pressure_field_l2\"]\n");
  check(verdicts_of(trial, second_order)[0], VerdictKind::pass, "order");
  check(verdicts_of(trial, second_order, Baseline{})[0], VerdictKind::inconclusive,
        "the baseline has not this group");
}

BOOST_AUTO_TEST_CASE(a_baseline_keeps_what_cannot_be_renewed_and_remembers_reasons) {
  const Trial trial("[gate]\nmeasures = [\"pore_pressure_field_l2\"]\n");
  const Baseline old = baseline_of(trial, second_order);
  int row = 0;
  const auto groups = groups_of(trial.study, trial.store_with([](const auto&) { return 0.5; },
                                                              [&](Record&) { return ++row > 1; }));
  const Baseline fresh = rebaselined(groups, trial.rules, old, "2026-02-02", "other kernel");
  BOOST_TEST(
      fresh.history == (std::vector<std::string>{"2026-01-01: first", "2026-02-02: other kernel"}),
      boost::test_tools::per_element());
  const std::pair first(groups[0].name, std::string("pore_pressure_field_l2"));
  const std::pair second(groups[1].name, std::string("pore_pressure_field_l2"));
  BOOST_TEST(fresh.expected.at(first).mean_log == old.expected.at(first).mean_log,
             boost::test_tools::per_element());
  BOOST_TEST(fresh.expected.at(second).mean_log[0] == std::log(0.5));
}

BOOST_AUTO_TEST_CASE(exit_codes_follow_the_worst_verdict) {
  const auto code = [](std::initializer_list<VerdictKind> kinds) {
    std::vector<Verdict> verdicts;
    for (const VerdictKind kind : kinds) verdicts.push_back({"", "", kind, ""});
    return exit_code(verdicts);
  };
  BOOST_TEST(code({VerdictKind::pass, VerdictKind::xfail}) == 0);
  BOOST_TEST(code({VerdictKind::pass, VerdictKind::inconclusive}) == 3);
  BOOST_TEST(code({VerdictKind::inconclusive, VerdictKind::fail}) == 1);
  BOOST_TEST(code({VerdictKind::pass, VerdictKind::xpass}) == 1);
}

BOOST_AUTO_TEST_CASE(wrong_rules_are_refused) {
  BOOST_CHECK_THROW(Trial("[gate]\nmeasures = [\"pore_presure_field_l2\"]\n"), InputError);
  BOOST_CHECK_THROW(Trial("[gate]\nordr = 2\n"), InputError);
  BOOST_CHECK_THROW(Trial("[gate]\norder_tolerance = 0\n"), InputError);
  BOOST_CHECK_THROW(Trial("[[known_failure]]\n\"discretization.kernel\" = \"bspline1\"\n"),
                    InputError);
  BOOST_CHECK_THROW(Trial("[[known_failure]]\n\"discretization.elements\" = 50\nreason = \"r\"\n"),
                    InputError);
}

BOOST_AUTO_TEST_SUITE_END()
