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

struct CostPair {
  const Group* group;
  std::optional<Expected> now;
  const Expected* before;  ///< null if the baseline has none of this level

  bool comparable() const { return now && before != nullptr; }
  double change() const { return now->mean_log[0] - before->mean_log[0]; }
  /// Of the change, in units of the variance of one measurement.
  double variance() const { return 1.0 / now->replicates + 1.0 / before->replicates; }
};

std::vector<CostPair> pairs_of(const std::vector<Group>& groups,
                               const std::optional<Baseline>& baseline) {
  std::vector<CostPair> pairs;
  for (const Group& group : groups) {
    CostPair pair{&group, expected_cost(group), nullptr};
    if (baseline && pair.now) {
      const auto found = baseline->expected.find({group.name, std::string(cost_name)});
      const bool same_level =
          found != baseline->expected.end() && found->second.spacing == pair.now->spacing;
      if (same_level) pair.before = &found->second;
    }
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

/// Scatter of one measurement's logarithm, the same for all groups: each alone has too few.
struct Scatter {
  double variance = 0.0;
  double freedom = 0.0;

  void add(const Expected& costs) {
    variance += (costs.replicates - 1) * costs.sd_log[0] * costs.sd_log[0];
    freedom += costs.replicates - 1;
  }
  /// Of a change whose variance is given in units of one measurement's.
  double half_interval(double level, double units) const {
    if (freedom < 1.0) return 0.0;
    return gsl_cdf_tdist_Qinv(0.5 * level, freedom) * std::sqrt(variance / freedom * units);
  }
};

Verdict compared(std::string group, double change, double tolerance, double scatter) {
  Verdict verdict{std::move(group), std::string(cost_name), VerdictKind::pass, ""};
  const bool same = std::abs(change) <= std::log1p(tolerance) + scatter;
  if (!same) verdict.kind = VerdictKind::fail;
  verdict.reason = fmt::format(
      "a point and step costs {:.2f} times as much as in the baseline, which allows {:.2f} times "
      "more or less{}",
      std::exp(change), std::exp(std::log1p(tolerance) + scatter),
      !same && change < 0.0 ? "; if this is an improvement, rebaseline with its reason" : "");
  return verdict;
}

Verdict not_compared(const CostPair& pair) {
  return {pair.group->name, std::string(cost_name), VerdictKind::inconclusive,
          pair.now ? "nothing to compare with: the baseline has no cost of this level"
                   : "cases of the finest level have no cost: they are missing, did not end or "
                     "were run by another solver"};
}

}  // namespace

std::vector<Verdict> judge_costs(const std::vector<Group>& groups, const GateRules& rules,
                                 const std::optional<Baseline>& baseline) {
  std::vector<Verdict> verdicts;
  if (!rules.cost_tolerance) return verdicts;
  const std::vector<CostPair> pairs = pairs_of(groups, baseline);
  Scatter scatter;
  double sum = 0.0;
  double variance = 0.0;
  double count = 0.0;
  for (const CostPair& pair : pairs) {
    if (!pair.comparable()) continue;
    scatter.add(*pair.now);
    scatter.add(*pair.before);
    sum += pair.change();
    variance += pair.variance();
    ++count;
  }
  const double level = rules.false_alarm / (static_cast<double>(groups.size()) + 1.0);
  for (const CostPair& pair : pairs) {
    verdicts.push_back(pair.comparable()
                           ? compared(pair.group->name, pair.change(), *rules.cost_tolerance,
                                      scatter.half_interval(level, pair.variance()))
                           : not_compared(pair));
  }
  if (count > 1.0) {
    verdicts.push_back(compared("all groups", sum / count, *rules.cost_tolerance,
                                scatter.half_interval(level, variance / (count * count))));
  }
  return verdicts;
}

}  // namespace porowave::verification
