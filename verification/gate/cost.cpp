#include "verification/gate/cost.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

#include "verification/gate/gate.hpp"

namespace porowave::verification {

std::optional<Expected> expected_cost(const Group& group) {
  std::vector<double> logs;
  for (const Record& record : group.records.back()) {
    const double log = std::log(record.relative_cost());
    if (!std::isfinite(log)) return std::nullopt;
    logs.push_back(log);
  }
  std::sort(logs.begin(), logs.end());
  logs.resize((logs.size() + 1) / 2);
  double mean = 0.0;
  for (const double log : logs) mean += log / static_cast<double>(logs.size());
  double squares = 0.0;
  for (const double log : logs) squares += (log - mean) * (log - mean);
  Expected expected;
  expected.spacing = {group.spacing.back()};
  expected.mean_log = {mean};
  expected.replicates = static_cast<int>(logs.size());
  expected.sd_log = {logs.size() > 1 ? std::sqrt(squares / static_cast<double>(logs.size() - 1))
                                     : 0.0};
  expected.order = std::numeric_limits<double>::quiet_NaN();
  return expected;
}

namespace {

Verdict cost_verdict(const Group& group, const Expected* before, double tolerance, double level) {
  Verdict verdict{group.name, std::string(cost_name), VerdictKind::inconclusive, ""};
  const auto now = expected_cost(group);
  if (!now) {
    verdict.reason =
        "cases of the finest level have no cost: they are missing, did not end or were "
        "run by another solver";
    return verdict;
  }
  if (before == nullptr || before->spacing != now->spacing) {
    verdict.reason = "nothing to compare with: the baseline has no cost of this level";
    return verdict;
  }
  const double change = now->mean_log[0] - before->mean_log[0];
  const double variance = std::pow(now->sd_log[0], 2) / now->replicates +
                          std::pow(before->sd_log[0], 2) / before->replicates;
  const double freedom = std::max(1, now->replicates + before->replicates - 2);
  const double scatter = gsl_cdf_tdist_Qinv(0.5 * level, freedom) * std::sqrt(variance);
  const bool same = std::abs(change) <= std::log1p(tolerance) + scatter;
  verdict.kind = same ? VerdictKind::pass : VerdictKind::fail;
  verdict.reason = fmt::format(
      "a point and step costs {:.3g} points of the calibration loop, {:.2f} times as much as in "
      "the "
      "baseline, which allows {:.2f} times more or less{}",
      std::exp(now->mean_log[0]), std::exp(change), std::exp(std::log1p(tolerance) + scatter),
      !same && change < 0.0 ? "; if this is an improvement, rebaseline with its reason" : "");
  return verdict;
}

}  // namespace

std::vector<Verdict> judge_costs(const std::vector<Group>& groups, const GateRules& rules,
                                 const std::optional<Baseline>& baseline) {
  std::vector<Verdict> verdicts;
  if (!rules.cost_tolerance) return verdicts;
  const double level =
      rules.false_alarm / static_cast<double>(std::max<std::size_t>(1, groups.size()));
  for (const Group& group : groups) {
    const Expected* before = nullptr;
    if (baseline) {
      const auto found = baseline->expected.find({group.name, std::string(cost_name)});
      if (found != baseline->expected.end()) before = &found->second;
    }
    verdicts.push_back(cost_verdict(group, before, *rules.cost_tolerance, level));
  }
  return verdicts;
}

}  // namespace porowave::verification
