#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "reports/report/case_table.hpp"
#include "reports/report/group_summary.hpp"

namespace porowave::reports {

/// Why a case of a store is worth a look at its fields.
enum class RunRole { best_finest, worst_finest, broke_down, best_middle, worst_middle };
inline constexpr std::array<std::string_view, 5> run_role_names = {
    "best method, finest level", "worst method, finest level", "broke down",
    "best method, middle level", "worst method, middle level"};
constexpr std::string_view name(RunRole role) {
  return run_role_names[static_cast<std::size_t>(role)];
}

/// A case of a store that a report runs again for the pictures of its fields, which a store does
/// not hold.
struct ChosenRun {
  RunRole role;
  std::size_t problem;  ///< in parts_of(table, problem_axes(table))
  std::size_t group;    ///< in StudyTable::groups
  std::size_t row;      ///< in StudyTable::rows
};

/// The cases of a study that stand for the others; those that say most come first (in the order of
/// RunRole; of one role by problem). Errors of different problems do not compare, so of each
/// problem:
///   - the groups with the smallest and with the largest error at their finest level (if they are
///     two), of those of which all cases ended there: their finest level, and the middle one (of an
///     even number the coarser);
///   - a case that broke down: of the group with most of them, at its coarsest level with one.
/// Of the seeds of a level the one with the median error (of an even number the smaller), of broken
/// cases the first.
std::vector<ChosenRun> choose_runs(const StudyTable& table,
                                   const std::vector<GroupSummary>& summaries, std::size_t measure);

}  // namespace porowave::reports
