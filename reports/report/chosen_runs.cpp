#include "reports/report/chosen_runs.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "reports/report/figure_parts.hpp"

namespace porowave::reports {

namespace {

using verification::CaseStatus;
using verification::Record;

/// The case of a level with the median error.
std::optional<std::size_t> median_row(const StudyTable& table, const TableLevel& level,
                                      std::size_t measure) {
  std::vector<std::size_t> ended;
  for (const std::size_t i : level.rows) {
    const Record& row = table.rows[i];
    if (row.status == CaseStatus::done && std::isfinite(row.measures[measure])) ended.push_back(i);
  }
  if (ended.empty()) return std::nullopt;
  std::stable_sort(ended.begin(), ended.end(), [&](std::size_t a, std::size_t b) {
    return table.rows[a].measures[measure] < table.rows[b].measures[measure];
  });
  return ended[(ended.size() - 1) / 2];
}

std::optional<std::size_t> first_broken(const StudyTable& table, const TableGroup& group) {
  for (const TableLevel& level : group.levels) {
    for (const std::size_t i : level.rows) {
      if (table.rows[i].status == CaseStatus::broke_down) return i;
    }
  }
  return std::nullopt;
}

std::size_t count_broken(const StudyTable& table, const TableGroup& group) {
  std::size_t count = 0;
  for (const TableLevel& level : group.levels) {
    count += static_cast<std::size_t>(std::count_if(
        level.rows.begin(), level.rows.end(),
        [&](std::size_t i) { return table.rows[i].status == CaseStatus::broke_down; }));
  }
  return count;
}

class Chooser {
 public:
  Chooser(const StudyTable& table, const std::vector<GroupSummary>& summaries, std::size_t measure)
      : table_(table), summaries_(summaries), measure_(measure) {}

  void add(std::size_t problem, const std::vector<std::size_t>& groups) {
    const auto best = extreme_group(summaries_, groups, false);
    const auto worst = extreme_group(summaries_, groups, true);
    if (best) add(problem, *best, RunRole::best_finest, RunRole::best_middle);
    if (worst && worst != best) add(problem, *worst, RunRole::worst_finest, RunRole::worst_middle);
    add_broken(problem, groups);
  }

  std::vector<ChosenRun> in_order() {
    std::stable_sort(chosen_.begin(), chosen_.end(),
                     [](const ChosenRun& a, const ChosenRun& b) { return a.role < b.role; });
    return std::move(chosen_);
  }

 private:
  void add(std::size_t problem, std::size_t group, RunRole finest, RunRole middle) {
    const auto& levels = table_.groups[group].levels;
    const std::size_t half = (levels.size() - 1) / 2;
    if (const auto row = median_row(table_, levels.back(), measure_)) {
      chosen_.push_back({finest, problem, group, *row});
    }
    if (half + 1 == levels.size()) return;
    if (const auto row = median_row(table_, levels[half], measure_)) {
      chosen_.push_back({middle, problem, group, *row});
    }
  }

  void add_broken(std::size_t problem, const std::vector<std::size_t>& groups) {
    const auto most =
        std::max_element(groups.begin(), groups.end(), [&](std::size_t a, std::size_t b) {
          return count_broken(table_, table_.groups[a]) < count_broken(table_, table_.groups[b]);
        });
    if (most == groups.end()) return;
    const auto row = first_broken(table_, table_.groups[*most]);
    if (row) chosen_.push_back({RunRole::broke_down, problem, *most, *row});
  }

  const StudyTable& table_;
  const std::vector<GroupSummary>& summaries_;
  std::size_t measure_;
  std::vector<ChosenRun> chosen_;
};

}  // namespace

std::vector<ChosenRun> choose_runs(const StudyTable& table,
                                   const std::vector<GroupSummary>& summaries,
                                   std::size_t measure) {
  Chooser chooser(table, summaries, measure);
  const auto problems = parts_of(table, problem_axes(table));
  for (std::size_t p = 0; p < problems.size(); ++p) chooser.add(p, problems[p].groups);
  return chooser.in_order();
}

}  // namespace porowave::reports
