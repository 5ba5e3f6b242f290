#include "reports/report/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "verification/not_a_number.hpp"

namespace porowave::reports {

namespace {

using verification::CaseStatus;
using verification::Record;

using Key = std::pair<std::string, std::string>;  // study, specification

using verification::nan;

bool ended(const Record& row, std::size_t measure) {
  return row.status == CaseStatus::done && row.measures[measure] > 0.0 &&
         std::isfinite(row.measures[measure]);
}

std::string judged(const ComparedGroup& group) {
  if (group.cases == 0) return "nothing in common";
  if (group.now_broken > 0) return "worse";
  if (group.error_ratio > 1.0 + compared_tolerance) return "worse";
  if (group.error_ratio < 1.0 / (1.0 + compared_tolerance) || group.now_ended > 0) return "better";
  return "same";
}

/// What the levels of a group sum up to.
class Comparing {
 public:
  explicit Comparing(std::size_t measure) : measure_(measure) {}

  void add(const Record& before, const Record& after) {
    ++group.cases;
    const bool was = ended(before, measure_);
    const bool is = ended(after, measure_);
    if (was && !is) ++group.now_broken;
    if (!was && is) ++group.now_ended;
    if (!was || !is) return;
    logs_.push_back(std::log(after.measures[measure_] / before.measures[measure_]));
    worst_ = std::max(worst_, logs_.back());
    costs_.push_back(after.cpu_seconds / before.cpu_seconds);
  }
  /// The finest level that both have decides: levels come coarse to fine.
  void end_of_level() {
    if (!logs_.empty()) {
      double sum = 0.0;
      for (const double l : logs_) sum += l;
      finest_ = sum / static_cast<double>(logs_.size());
    }
    logs_.clear();
  }
  ComparedGroup result() {
    group.error_ratio = std::exp(finest_);
    group.worst_ratio = std::isfinite(worst_) ? std::exp(worst_) : nan;
    std::sort(costs_.begin(), costs_.end());
    group.cost_ratio = costs_.empty() ? nan : costs_[costs_.size() / 2];
    group.verdict = judged(group);
    return group;
  }

  ComparedGroup group;

 private:
  std::size_t measure_;
  std::vector<double> logs_;
  std::vector<double> costs_;
  double finest_ = nan;
  double worst_ = -std::numeric_limits<double>::infinity();
};

/// Broken ones first, then by the error's growth; groups without one last.
bool worse_first(const ComparedGroup& a, const ComparedGroup& b) {
  const auto key = [](const ComparedGroup& g) {
    return std::pair(static_cast<double>(g.now_broken),
                     std::isfinite(g.error_ratio) ? g.error_ratio : -1.0);
  };
  return key(a) > key(b);
}

}  // namespace

Comparison compare(const std::vector<StudyTable>& before, const std::vector<Record>& after,
                   std::size_t measure) {
  std::map<Key, const Record*> others;
  for (const Record& row : after) others[{row.study, row.specification}] = &row;
  Comparison result;
  std::size_t matched = 0;
  for (const StudyTable& table : before) {
    for (const TableGroup& group : table.groups) {
      Comparing comparing(measure);
      comparing.group.study = table.study;
      comparing.group.group = group.name;
      for (const TableLevel& level : group.levels) {
        for (const std::size_t row : level.rows) {
          const auto other = others.find({table.study, table.rows[row].specification});
          if (other == others.end()) {
            ++result.only_before;
            continue;
          }
          ++matched;
          comparing.add(table.rows[row], *other->second);
        }
        comparing.end_of_level();
      }
      result.groups.push_back(comparing.result());
    }
  }
  result.only_after = others.size() - std::min(matched, others.size());
  std::stable_sort(result.groups.begin(), result.groups.end(), worse_first);
  return result;
}

}  // namespace porowave::reports
