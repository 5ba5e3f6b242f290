#pragma once

// What the figures of a report share.

#include <string>
#include <vector>

#include "reports/report/report_figures.hpp"

namespace porowave::reports {

/// Groups of one figure: those with the same values on some axes.
struct FigurePart {
  std::vector<std::size_t> at;      ///< values on these axes
  std::vector<std::size_t> groups;  ///< in StudyTable::groups
};
std::vector<FigurePart> parts_of(const StudyTable& table, const std::vector<std::size_t>& axes);

/// Axes of the problem.
std::vector<std::size_t> problem_axes(const StudyTable& table);

/// "shape = step, placement = random"; empty without axes.
std::string described(const StudyTable& table, const std::vector<std::size_t>& axes,
                      const std::vector<std::size_t>& at);

/// A group's name by some of its axes; "all cases" without any.
std::string name_on(const StudyTable& table, const std::vector<std::size_t>& axes,
                    const TableGroup& group);

/// "bspline2, support_radius 3.0, 200 elements": a group and level without what is its problem.
std::string method_name(const StudyTable& table, std::size_t group, std::size_t level);

/// Value of a group on an axis that a figure may not have: then 0, "".
std::size_t place_on(const TableGroup& group, std::optional<std::size_t> axis);
std::size_t size_of(const StudyTable& table, std::optional<std::size_t> axis);
std::string value_on(const StudyTable& table, std::optional<std::size_t> axis, std::size_t value);

/// A number that gnuplot's real() reads.
std::string real_text(double value);

/// The smallest and largest of what it has seen; positive numbers only.
struct PositiveRange {
  double low = 0.0;
  double high = 0.0;
  void see(double value);
  bool empty() const { return high <= 0.0; }
};

/// "seed 1 to 16": how many cases a point of a figure stands for.
std::size_t most_seeds(const std::vector<GroupSummary>& summaries,
                       const std::vector<std::size_t>& groups);

/// The group with the smallest error at its finest level, of those that have all their cases; none
/// if there is none. With `worst` that with the largest.
std::optional<std::size_t> extreme_group(const std::vector<GroupSummary>& summaries,
                                         const std::vector<std::size_t>& groups, bool worst);

/// Adds a text that the figure's script uses.
void add_text(Figure& figure, const std::string& variable, const std::string& value);

}  // namespace porowave::reports
