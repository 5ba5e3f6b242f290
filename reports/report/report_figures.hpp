#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/gnuplot.hpp"
#include "reports/report/case_table.hpp"
#include "reports/report/group_summary.hpp"

namespace porowave::reports {

/// A figure with what is said below it.
struct ReportFigure {
  Figure figure;
  std::string heading;  ///< "Convergence"
  std::string claim;    ///< what it shows, in a sentence or two with numbers
  std::string alt;      ///< the same for those who cannot see it
};

/// What figures are made of: a study, and the summary of every group in one measure.
struct FigureInput {
  const StudyTable& table;
  const std::vector<GroupSummary>& summaries;
  std::size_t measure;
  std::string prefix;  ///< of the figures' file names; "" or "2_"
};

/// Which axes of a table become curves and panels; every combination of the others is a figure.
struct FigureAxes {
  std::optional<std::size_t> curve;  ///< the method's axis with most values
  std::optional<std::size_t> panel;  ///< another of the method, of numbers if there is one
  std::vector<std::size_t> rest;
};
FigureAxes figure_axes(const StudyTable& table);

/// Most figures of a kind for one study; the tables have all.
inline constexpr std::size_t most_figures = 12;

/// Error against element length: curves with a band over the seeds, orders in the legend, floors,
/// the triangle of the best curve's fitted order. None if no group has two levels with errors.
std::vector<ReportFigure> convergence_figures(const FigureInput& input);

/// Error against CPU time, one figure a problem, with the Pareto front named.
std::vector<ReportFigure> work_precision_figures(const FigureInput& input);

/// Groups and levels that no other beats in both error and CPU seconds, the cheapest first.
struct FrontMember {
  std::size_t group;
  std::size_t level;
  double cpu_seconds;
  double error;
};
std::vector<FrontMember> pareto_front(const std::vector<GroupSummary>& summaries,
                                      const std::vector<std::size_t>& groups);

/// Error at the finest level and observed order over two or three axes. None with fewer axes.
std::vector<ReportFigure> heat_map_figures(const FigureInput& input);

/// Nanoseconds for a point and step against the number of points.
std::vector<ReportFigure> cost_figures(const FigureInput& input);

/// All of these.
std::vector<ReportFigure> figures_of(const FigureInput& input);

}  // namespace porowave::reports
