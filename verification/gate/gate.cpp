#include "verification/gate/gate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "verification/gate/cost.hpp"

namespace porowave::verification {

namespace {

/// Errors nearer to the reference's own than this factor do not tell about the solver.
constexpr double reference_margin = 20.0;
/// An error of a lower order than this has all but stopped to fall.
constexpr double still = 0.3;
/// Orders of the same program may differ by this much and more only by chance.
constexpr double order_resolution = 0.02;

std::string seeds_text(const Group& group) {
  return fmt::format("{}", fmt::join(group.seeds, " "));
}

std::string list_of(const std::vector<std::string>& items) {
  constexpr std::size_t shown = 3;
  const auto end = items.begin() + static_cast<std::ptrdiff_t>(std::min(shown, items.size()));
  return fmt::format(
      "{}{}", fmt::join(items.begin(), end, "; "),
      items.size() > shown ? fmt::format("; and {} more", items.size() - shown) : std::string());
}

Expected expectation_of(const Group& group, std::size_t measure) {
  const ErrorTable table = errors_of(group, measure);
  const LogMeans levels = log_means(table);
  const OrderEstimate order = estimate_order(table);
  Expected expected;
  expected.seeds = seeds_text(group);
  expected.spacing = group.spacing;
  expected.mean_log = levels.mean;
  expected.replicates = static_cast<int>(table.replicates());
  for (const double v : levels.variance) {
    expected.sd_log.push_back(std::sqrt(v * expected.replicates));
  }
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  expected.order = order.status == OrderStatus::observed ? order.order : none;
  expected.order_half = 0.5 * (order.high - order.low);
  return expected;
}

class Judge {
 public:
  Judge(const GateRules& rules, const std::optional<Baseline>& baseline,
        const FloorExplanation& explain, std::size_t comparisons)
      : rules_(rules),
        baseline_(baseline),
        explain_(explain),
        level_(rules.false_alarm / static_cast<double>(comparisons)) {}

  Verdict operator()(const Group& group, std::size_t measure) const {
    Verdict verdict{group.name, measure_names()[measure], VerdictKind::pass, {}};
    decide(group, measure, verdict);
    for (const auto& known : rules_.known_failures) {
      const bool meant = std::all_of(known.where.begin(), known.where.end(), [&](const auto& w) {
        return same_value(group.coordinates[w.first], w.second);
      });
      if (!meant) continue;
      verdict.kind = as_known_failure(verdict.kind);
      verdict.reason += fmt::format(" (known to fail: {})", known.reason);
      break;
    }
    return verdict;
  }

 private:
  static void set(Verdict& verdict, VerdictKind kind, std::string reason) {
    verdict.kind = kind;
    verdict.reason = std::move(reason);
  }

  void decide(const Group& group, std::size_t measure, Verdict& verdict) const {
    if (!group.missing.empty()) {
      return set(verdict, VerdictKind::inconclusive,
                 fmt::format("incomplete: {} of {} cases missing: {}", group.missing.size(),
                             group.cases, list_of(group.missing)));
    }
    if (!group.broken.empty()) {
      return set(verdict, VerdictKind::fail,
                 fmt::format("{} of {} cases did not end: {}", group.broken.size(), group.cases,
                             list_of(group.broken)));
    }
    if (reference_limited(group, measure, verdict)) return;
    const OrderEstimate order = estimate_order(errors_of(group, measure), {.confidence = 0.95});
    const Expected* expected = expectation(group, measure);
    if (!rules_.order && expected == nullptr) {
      return set(verdict, VerdictKind::inconclusive,
                 "nothing to compare with: the study names no order, the baseline not this group");
    }
    if (baseline_ && expected == nullptr) {
      return set(verdict, VerdictKind::inconclusive,
                 "nothing to compare with: the baseline has not this group");
    }
    if (rules_.order && !order_is_right(order, group, measure, verdict)) return;
    if (expected != nullptr && !as_before(group, measure, *expected, order, verdict)) return;
    set(verdict, VerdictKind::pass, described(order));
  }

  bool reference_limited(const Group& group, std::size_t measure, Verdict& verdict) const {
    const auto reference = *measure_index("reference_error");
    for (const auto& level : group.records) {
      for (const Record& record : level) {
        if (record.measures[reference] * reference_margin <= record.measures[measure]) continue;
        if (std::isnan(record.measures[measure])) continue;
        set(verdict, VerdictKind::inconclusive,
            fmt::format("reference-limited: error {:.2g}, the reference's own is {:.2g}",
                        record.measures[measure], record.measures[reference]));
        return true;
      }
    }
    return false;
  }

  const Expected* expectation(const Group& group, std::size_t measure) const {
    if (!baseline_) return nullptr;
    const auto found = baseline_->expected.find({group.name, measure_names()[measure]});
    return found == baseline_->expected.end() ? nullptr : &found->second;
  }

  static std::string described(const OrderEstimate& order) {
    if (order.status != OrderStatus::observed) {
      return fmt::format("no order: {}",
                         order_status_names[static_cast<std::size_t>(order.status)]);
    }
    return fmt::format("observed order {:.2f} ± {:.2f}", order.order,
                       0.5 * (order.high - order.low));
  }

  /// The loose bound, against theory.
  bool order_is_right(const OrderEstimate& order, const Group& group, std::size_t measure,
                      Verdict& verdict) const {
    if (order.status != OrderStatus::observed) {
      const bool wrong = order.status == OrderStatus::not_finite;
      set(verdict, wrong ? VerdictKind::fail : VerdictKind::inconclusive,
          reason_of(order, group, measure));
      return false;
    }
    const double low = *rules_.order - rules_.order_tolerance;
    const double high = *rules_.order + rules_.order_tolerance;
    const auto text = [&](const char* what) {
      return fmt::format("{}, expected {:g} ± {:g}{}", described(order), *rules_.order,
                         rules_.order_tolerance, what);
    };
    if (order.high < low || order.low > high) {
      std::string reason = text(order.high < low ? ": too low" : ": too high");
      const bool stands_still = std::abs(order.order) < still && order.high < low;
      if (stands_still && explain_) reason += "; the error is " + explain_(group, measure);
      set(verdict, VerdictKind::fail, std::move(reason));
      return false;
    }
    if (order.low < low || order.high > high) {
      set(verdict, VerdictKind::inconclusive,
          text(": the interval reaches beyond; more seeds or finer levels would tell"));
      return false;
    }
    return true;
  }

  std::string reason_of(const OrderEstimate& order, const Group& group, std::size_t measure) const {
    switch (order.status) {
      case OrderStatus::not_finite:
        return "an error is not a positive, finite number";
      case OrderStatus::too_few_levels:
        return "too few levels: expected at least three";
      case OrderStatus::at_floor:
        return fmt::format("refinement no longer lowers the error: it has a floor of {:.2g}{}",
                           order.floor, explain_ ? ", " + explain_(group, measure) : std::string());
      default:
        return fmt::format("not yet asymptotic: orders from level to level are {:.2f}",
                           fmt::join(order.pairwise, ", "));
    }
  }

  /// The tight bound, against the baseline.
  bool as_before(const Group& group, std::size_t measure, const Expected& expected,
                 const OrderEstimate& order, Verdict& verdict) const {
    if (expected.spacing != group.spacing) {
      set(verdict, VerdictKind::inconclusive, "the baseline has other levels: rebaseline");
      return false;
    }
    const LogMeans now = log_means(errors_of(group, measure));
    for (std::size_t i = 0; i < now.mean.size(); ++i) {
      const double change = now.mean[i] - expected.mean_log[i];
      const double allowed = tolerance(group, expected, now, i);
      if (std::abs(change) <= allowed) continue;  // false for NaN
      set(verdict, VerdictKind::fail,
          fmt::format(
              "{} = {}: error {:.3g}, {:+.1f} % against the baseline, which allows ±{:.1f} "
              "%{}",
              "level", group.levels[i].text(), std::exp(now.mean[i]), 100.0 * std::expm1(change),
              100.0 * std::expm1(allowed),
              change < 0.0 ? "; if this is an improvement, rebaseline with its reason" : ""));
      return false;
    }
    const bool both = order.status == OrderStatus::observed && std::isfinite(expected.order);
    const double allowed = order_resolution + 0.5 * (order.high - order.low) + expected.order_half;
    if (both && !(std::abs(order.order - expected.order) <= allowed)) {
      set(verdict, VerdictKind::fail,
          fmt::format("{}, the baseline has {:.2f}", described(order), expected.order));
      return false;
    }
    if (!both && std::isfinite(expected.order)) {
      set(verdict, VerdictKind::inconclusive, reason_of(order, group, measure));
      return false;
    }
    return true;
  }

  /// Of the change of a level's mean logarithm.
  double tolerance(const Group& group, const Expected& expected, const LogMeans& now,
                   std::size_t i) const {
    const double same = std::log1p(rules_.error_tolerance);
    if (expected.seeds == seeds_text(group)) return same;
    const double then = std::pow(expected.sd_log[i], 2) / expected.replicates;
    const double freedom = static_cast<double>(group.seeds.size()) + expected.replicates - 2.0;
    if (freedom < 1.0) return same;
    return same + gsl_cdf_tdist_Qinv(0.5 * level_, freedom) * std::sqrt(now.variance[i] + then);
  }

  const GateRules& rules_;
  const std::optional<Baseline>& baseline_;
  const FloorExplanation& explain_;
  double level_;  ///< of one comparison
};

}  // namespace

std::vector<Verdict> judge(const std::vector<Group>& groups, const GateRules& rules,
                           const std::optional<Baseline>& baseline,
                           const FloorExplanation& explain) {
  std::size_t comparisons = 0;
  for (const Group& group : groups) comparisons += rules.measures.size() * group.levels.size();
  const Judge judge(rules, baseline, explain, std::max<std::size_t>(1, comparisons));
  std::vector<Verdict> verdicts;
  for (const Group& group : groups) {
    for (const std::size_t measure : rules.measures) verdicts.push_back(judge(group, measure));
  }
  return verdicts;
}

Baseline rebaselined(const std::vector<Group>& groups, const GateRules& rules,
                     const std::optional<Baseline>& old, const std::string& date,
                     const std::string& reason) {
  Baseline baseline;
  if (old) baseline.history = old->history;
  baseline.history.push_back(date + ": " + reason);
  for (const Group& group : groups) {
    for (const std::size_t measure : rules.measures) {
      const std::pair key(group.name, measure_names()[measure]);
      if (group.missing.empty() && group.broken.empty()) {
        baseline.expected[key] = expectation_of(group, measure);
      } else if (old && old->expected.contains(key)) {
        baseline.expected[key] = old->expected.at(key);
      }
    }
    const std::pair cost_key(group.name, std::string(cost_name));
    const auto cost = rules.cost_tolerance ? expected_cost(group) : std::nullopt;
    if (cost) {
      baseline.expected[cost_key] = *cost;
    } else if (old && old->expected.contains(cost_key)) {
      baseline.expected[cost_key] = old->expected.at(cost_key);
    }
  }
  return baseline;
}

}  // namespace porowave::verification
