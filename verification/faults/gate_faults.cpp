// Wrong gates: each does not stop something that must be stopped. Judged by stores whose verdict is
// known.

#include <cmath>

#include "verification/faults/gate_check.hpp"
#include "verification/gate/gate_fixtures.hpp"

namespace porowave::verification::faults {

namespace {

using gate_fixtures::scattered;
using gate_fixtures::Trial;

struct Situation {
  std::string name;
  VerdictKind expected;
  std::function<Verdict(const JudgeFunction&)> judged;
};

const std::string one_measure = "[gate]\nmeasures = [\"pore_pressure_field_l2\"]\n";
const std::string theory = one_measure + "order = 2.0\n";
const std::string known =
    "[[known_failure]]\n\"discretization.kernel\" = \"bspline1\"\nreason = \"issue 12\"\n";

double of_order(double order, const solver::Discretization& d) {
  return scattered(d, order);
}

/// The first group, its errors of an order, times a factor, against theory or against a baseline of
/// order two.
Situation errors(const std::string& name, VerdictKind expected, double order, double factor,
                 bool baseline, const std::string& more = "") {
  return {name, expected, [=](const JudgeFunction& judge) {
            const Trial trial((baseline ? one_measure : theory) + more);
            const auto error = [=](const auto& d) { return factor * of_order(order, d); };
            std::optional<Baseline> before;
            if (baseline) {
              before =
                  rebaselined(trial.groups_with([](const auto& d) { return of_order(2.0, d); }),
                              trial.rules, std::nullopt, "2026-01-01", "first");
            }
            return judge(trial.groups_with(error), trial.rules, before)[0];
          }};
}

/// Errors of order two in rows that `edit` changes, or drops by returning false.
Situation rows(const std::string& name, VerdictKind expected,
               const std::function<bool(int row, Record&)>& edit) {
  return {name, expected, [=](const JudgeFunction& judge) {
            const Trial trial(theory);
            int row = 0;
            const Store store =
                trial.store_with([](const auto& d) { return of_order(2.0, d); },
                                 [&](Record& record) { return edit(++row, record); });
            return judge(groups_of(trial.study, store), trial.rules, std::nullopt)[0];
          }};
}

const std::vector<Situation>& situations() {
  static const std::vector<Situation> all = {
      errors("errors as theory has them", VerdictKind::pass, 2.0, 1.0, false),
      errors("order 1.5 where theory has 2", VerdictKind::fail, 1.5, 1.0, false),
      errors("order 2.5 where theory has 2", VerdictKind::fail, 2.5, 1.0, false),
      errors("errors as in the baseline", VerdictKind::pass, 2.0, 1.0, true),
      errors("errors 5 % larger than before", VerdictKind::fail, 2.0, 1.05, true),
      errors("errors 5 % smaller than before", VerdictKind::fail, 2.0, 0.95, true),
      errors("errors of the reference's size", VerdictKind::inconclusive, 2.0, 1e-9, false),
      errors("a known failure that fails", VerdictKind::xfail, 1.0, 1.0, false, known),
      errors("a known failure that fails no more", VerdictKind::xpass, 2.0, 1.0, false, known),
      rows("a case is missing", VerdictKind::inconclusive,
           [](int row, Record&) { return row != 3; }),
      rows("a case has broken down", VerdictKind::fail,
           [](int row, Record& record) {
             if (row == 3) record.status = CaseStatus::broke_down;
             return true;
           }),
      rows("an error is not a number", VerdictKind::fail,
           [](int row, Record& record) {
             if (row == 3) record.measures[*measure_index("pore_pressure_field_l2")] = std::nan("");
             return true;
           }),
  };
  return all;
}

/// The right gate after something was done to the groups or rules, or to its verdicts.
using GroupChange = std::function<void(Group&)>;
using RuleChange = std::function<void(GateRules&)>;
using VerdictChange = std::function<void(Verdict&)>;

JudgeFunction with_groups(const GroupChange& change) {
  return [change](std::vector<Group> groups, const GateRules& rules, const auto& baseline) {
    for (Group& group : groups) change(group);
    return judge(groups, rules, baseline);
  };
}
JudgeFunction with_rules(const RuleChange& change) {
  return [change](const std::vector<Group>& groups, GateRules rules, const auto& baseline) {
    change(rules);
    return judge(groups, rules, baseline);
  };
}
JudgeFunction with_verdicts(const VerdictChange& change) {
  return [change](const std::vector<Group>& groups, const GateRules& rules, const auto& baseline) {
    auto verdicts = judge(groups, rules, baseline);
    for (Verdict& verdict : verdicts) change(verdict);
    return verdicts;
  };
}

/// What a gate sees that drops rows it has no error for: the others' values in their place.
void fill_rows(Group& group, bool (*hole)(const Record&)) {
  for (auto& level : group.records) {
    for (Record& record : level) {
      if (hole(record)) record = level.back();
    }
  }
}

Fault in_gate(const std::string& what, const std::string& named, const JudgeFunction& wrong) {
  return {"gate", what, named, [wrong] { return caught_by_gate_facts(wrong); }};
}

}  // namespace

Catch caught_by_gate_facts(const JudgeFunction& judge) {
  for (const Situation& situation : situations()) {
    const Verdict verdict = situation.judged(judge);
    if (verdict.kind == situation.expected) continue;
    return {"facts of gates", situation.name + ": " + std::string(to_string(verdict.kind)) +
                                  " where " + std::string(to_string(situation.expected)) +
                                  " is right"};
  }
  return {"facts of gates", ""};
}

std::vector<Fault> gate_faults() {
  return {
      in_gate("missing cases are left out", "a case is missing: pass", with_groups([](Group& g) {
                g.missing.clear();
                fill_rows(g, [](const Record& r) { return r.id.empty(); });
              })),
      in_gate("cases that broke down are left out", "a case has broken down: pass",
              with_groups([](Group& g) {
                g.broken.clear();
                fill_rows(g, [](const Record& r) { return r.status != CaseStatus::done; });
              })),
      in_gate("NaN compares as not worse", "an error is not a number: pass",
              with_groups([](Group& g) {
                fill_rows(g, [](const Record& r) {
                  return std::isnan(r.measures[*measure_index("pore_pressure_field_l2")]);
                });
              })),
      in_gate("better than expected is welcome", "order 2.5 where theory has 2: pass",
              with_verdicts([](Verdict& v) {
                if (v.reason.find("too high") != std::string::npos) v.kind = VerdictKind::pass;
              })),
      in_gate("smaller errors are welcome", "errors 5 % smaller than before: pass",
              with_verdicts([](Verdict& v) {
                if (v.reason.find("improvement") != std::string::npos) v.kind = VerdictKind::pass;
              })),
      in_gate("the baseline is not looked at", "errors as in the baseline: inconclusive",
              [](const auto& groups, const auto& rules, const auto&) {
                return judge(groups, rules, std::nullopt);
              }),
      in_gate("the tight bound is 10 %", "errors 5 % larger than before: pass",
              with_rules([](GateRules& rules) { rules.error_tolerance = 0.1; })),
      in_gate("the order of theory is not looked at", "errors as theory has them: inconclusive",
              with_rules([](GateRules& rules) { rules.order.reset(); })),
      in_gate("the reference counts as exact", "errors of the reference's size: pass",
              with_groups([](Group& g) {
                for (auto& level : g.records) {
                  for (Record& r : level) r.measures[*measure_index("reference_error")] = 0.0;
                }
              })),
      in_gate("known failures are not known", "a known failure that fails: fail",
              with_rules([](GateRules& rules) { rules.known_failures.clear(); })),
      in_gate("a known failure may pass unnoticed", "fails no more: pass",
              with_verdicts([](Verdict& v) {
                if (v.kind == VerdictKind::xpass) v.kind = VerdictKind::pass;
              })),
      in_gate("what cannot be told passes", "errors of the reference's size: pass",
              with_verdicts([](Verdict& v) {
                if (v.kind == VerdictKind::inconclusive) v.kind = VerdictKind::pass;
              })),
  };
}

}  // namespace porowave::verification::faults
