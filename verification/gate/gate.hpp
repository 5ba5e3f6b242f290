#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reference/problem/toml_document.hpp"
#include "verification/gate/baseline.hpp"
#include "verification/gate/observation.hpp"
#include "verification/gate/verdict.hpp"

namespace porowave::verification {

/// What a study is judged by: its tables [gate] and [[known_failure]].
///
///   [gate]  measures = ["effective_stress_field_l2", ...]   all L2 errors if absent; those at the
///                                   points if an adapter runs the cases, which gives no others
///           order = 2.0             of theory; absent: judged by the baseline alone
///           order_tolerance = 0.25  the loose bound, to both sides
///           error_tolerance = 0.01  the tight bound on errors for the seeds of the baseline
///           cost_tolerance = 1.0    costs are judged as well: by how much (1.0: to twice) a step
///           may
///                                   cost more or less than in the baseline, as a multiple of the
///                                   calibration loop, beyond what its scatter explains
///   [[known_failure]]               groups that are known to fail: xfail, or xpass if they do not
///           "discretization.kernel" = "bspline1"
///           reason = "..."
struct GateRules {
  std::vector<std::size_t> measures;  ///< indices in measure_names()
  std::optional<double> order;
  double order_tolerance = 0.25;
  double error_tolerance = 0.01;
  std::optional<double> cost_tolerance;
  struct KnownFailure {
    std::vector<std::pair<std::size_t, TomlValue>> where;  ///< axis and value
    std::string reason;
  };
  std::vector<KnownFailure> known_failures;
  /// A gate whose code has not changed is red with at most this probability, whatever its seeds.
  double false_alarm = 0.002;
};
GateRules read_gate_rules(const TomlDocument& document, const Study& study);

/// What makes a floor in the errors of a group and measure, in words (floor_cause.hpp).
using FloorExplanation = std::function<std::string(const Group&, std::size_t measure)>;

/// A verdict for every group and measure. In this order: cases missing (inconclusive) or broken
/// (fail); errors near the reference's own (inconclusive); no order to be told (inconclusive);
/// the order against theory; order and errors against the baseline, both to both sides: exactly
/// where the seeds are the same; where they are others, by Student's test, corrected for the number
/// of comparisons (Bonferroni). `explain` is asked only where refinement no longer lowers an error.
std::vector<Verdict> judge(const std::vector<Group>& groups, const GateRules& rules,
                           const std::optional<Baseline>& baseline,
                           const FloorExplanation& explain = {});

/// A verdict for the cost of every group, by cost_tolerance; none without it. The cost of a group
/// is that of its finest level, where little but steps is paid for.
std::vector<Verdict> judge_costs(const std::vector<Group>& groups, const GateRules& rules,
                                 const std::optional<Baseline>& baseline);

/// What the groups are now, to be expected from now on. Groups with missing or broken cases keep
/// what the old baseline says of them. `date` and `reason` join the history.
Baseline rebaselined(const std::vector<Group>& groups, const GateRules& rules,
                     const std::optional<Baseline>& old, const std::string& date,
                     const std::string& reason);

}  // namespace porowave::verification
