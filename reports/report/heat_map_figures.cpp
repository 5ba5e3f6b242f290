#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "reports/report/figure_parts.hpp"
#include "reports/report/text_forms.hpp"

namespace porowave::reports {

namespace {

constexpr std::size_t most_panels = 4;
constexpr std::size_t most_rows = 24;
constexpr std::size_t most_columns = 8;
/// Errors beyond this are of runs that went wrong; all have the darkest colour.
constexpr double largest_error = 10.0;
constexpr int black = 0x000000;
constexpr int white = 0xffffff;

/// Axes of a heat map: rows, columns, panels; a figure for every combination of the rest.
struct MapAxes {
  std::size_t row;
  std::size_t column;
  std::optional<std::size_t> panel;
  std::vector<std::size_t> rest;
};

std::optional<MapAxes> map_axes(const StudyTable& table) {
  const FigureAxes axes = figure_axes(table);
  if (!axes.curve) return std::nullopt;
  std::vector<std::size_t> rest = axes.rest;
  std::optional<std::size_t> column = axes.panel;
  if (!column && !rest.empty()) {
    column = rest.front();
    rest.erase(rest.begin());
  }
  if (!column) return std::nullopt;
  MapAxes result{*axes.curve, *column, std::nullopt, {}};
  for (const std::size_t a : rest) {
    if (!result.panel && table.axes[a].values.size() <= most_panels) {
      result.panel = a;
    } else {
      result.rest.push_back(a);
    }
  }
  return result;
}

std::string second_line(const GroupSummary& summary) {
  using verification::OrderStatus;
  switch (summary.order.status) {
    case OrderStatus::observed:
      return fmt::format("p = {:.2f}", summary.order.order);
    case OrderStatus::at_floor:
      return "floor";
    case OrderStatus::not_asymptotic:
      return "no order";
    default:
      return "";
  }
}

/// Where a value lies in the scale, 0 to 1.
double share(double log_error, double low, double high) {
  return high > low ? (log_error - low) / (high - low) : 0.0;
}

std::string cell(const FigureInput& input, std::size_t g, const MapAxes& axes, double low,
                 double high) {
  constexpr double dark = 0.72;  // there black and white have the same contrast
  const TableGroup& group = input.table.groups[g];
  const GroupSummary& summary = input.summaries[g];
  const double error = summary.finest_error();
  const std::size_t broken = summary.finest().cases - summary.finest().ended;
  const double log_error = std::log10(error);
  const bool whole = std::isfinite(log_error);
  return fmt::format("{},{},{},{},{},{},{},{}\n", place_on(group, axes.panel) + 1,
                     group.at[axes.column] + 1, group.at[axes.row] + 1,
                     whole ? fmt::format("{:.4f}", log_error) : "nan",
                     whole && share(log_error, low, high) > dark ? white : black,
                     whole ? fmt::format("{:.1e}", error)
                           : fmt::format("{} of {}", broken, summary.finest().cases),
                     whole ? second_line(summary) : "broke down", csv_field(group.name));
}

void add_names(Figure& figure, const StudyTable& table, const MapAxes& axes) {
  std::size_t longest = 0;
  const auto list = [&](const char* word, std::size_t axis, std::size_t most, std::size_t width) {
    const std::size_t count = std::min(table.axes[axis].values.size(), most);
    for (std::size_t i = 0; i < count; ++i) {
      const std::string name = shortened(table.axes[axis].values[i], width);
      if (axis == axes.row) longest = std::max(longest, name.size());
      add_text(figure, fmt::format("{}{}", word, i + 1), name);
    }
    return count;
  };
  const auto rows = list("row", axes.row, most_rows, 36);
  const auto columns = list("column", axes.column, most_columns, 14);
  const std::size_t panels = axes.panel ? table.axes[*axes.panel].values.size() : 1;
  for (std::size_t p = 0; p < panels; ++p) {
    const std::string value = value_on(table, axes.panel, p);
    add_text(figure, fmt::format("title{}", p + 1),
             axes.panel ? shortened(table.axes[*axes.panel].title + " = " + value, 36) : "");
  }
  add_text(figure, "row_count", fmt::format("{}", rows));
  add_text(figure, "column_count", fmt::format("{}", columns));
  add_text(figure, "panels", fmt::format("{}", panels));
  add_text(figure, "longest_row", fmt::format("{}", std::max<std::size_t>(longest, 6)));
  add_text(figure, "x_title", table.axes[axes.column].title);
}

std::string claim_of(const FigureInput& input, const MapAxes& axes, const FigurePart& part,
                     const std::string& where) {
  std::vector<std::size_t> shown_axes = {axes.row, axes.column};
  if (axes.panel) shown_axes.push_back(*axes.panel);
  const auto cell_name = [&](std::size_t g) {
    return name_on(input.table, shown_axes, input.table.groups[g]);
  };
  const auto best = extreme_group(input.summaries, part.groups, false);
  const auto worst = extreme_group(input.summaries, part.groups, true);
  std::string text = where.empty() ? "" : where + ": ";
  if (!best) return text + "no group has an error for all cases of its finest level.";
  text += fmt::format(
      "at the finest level {} has the smallest error ({:.2g}), {} the largest ({:.2g}).",
      cell_name(*best), input.summaries[*best].finest_error(), cell_name(*worst),
      input.summaries[*worst].finest_error());
  const auto broken = std::count_if(part.groups.begin(), part.groups.end(), [&](std::size_t g) {
    return std::isnan(input.summaries[g].finest_error());
  });
  if (broken > 0) text += fmt::format(" In {} cells runs broke down or are missing.", broken);
  return text;
}

ReportFigure figure_of(const FigureInput& input, const MapAxes& axes, const FigurePart& part,
                       const PositiveRange& errors, const std::string& name) {
  ReportFigure result{{name, "report_heat_map", {}, {}, true}, "Heat maps", {}, {}};
  Figure& figure = result.figure;
  const double low = std::log10(errors.low) - 0.05;
  const double high = std::log10(errors.high) + 0.05;
  figure.data = "panel,column,row,log10_error,ink,upper,lower,group\n";
  for (const std::size_t g : part.groups) {
    const TableGroup& group = input.table.groups[g];
    if (group.at[axes.row] >= most_rows || group.at[axes.column] >= most_columns) continue;
    figure.data += cell(input, g, axes, low, high);
  }
  const std::string where = described(input.table, axes.rest, part.at);
  add_names(figure, input.table, axes);
  const auto best = extreme_group(input.summaries, part.groups, false);
  const std::string best_name =
      best ? value_on(input.table, axes.row, input.table.groups[*best].at[axes.row]) + ", " +
                 input.table.axes[axes.column].title + " " +
                 value_on(input.table, axes.column, input.table.groups[*best].at[axes.column])
           : "";
  add_text(figure, "caption",
           best ? shortened("Smallest error: " + best_name, 60) : "Error at the finest level");
  add_text(
      figure, "subcaption",
      shortened((where.empty() ? "" : where + " · ") + "error at the finest level, p: order", 90));
  add_text(figure, "c_title", "relative error (–)");
  add_text(figure, "c_low", real_text(low));
  add_text(figure, "c_high", real_text(high));
  result.claim = claim_of(input, axes, part, where);
  result.alt = fmt::format("Table of cells coloured by error, rows: {}, columns: {}. {}",
                           input.table.axes[axes.row].title, input.table.axes[axes.column].title,
                           result.claim);
  return result;
}

}  // namespace

std::vector<ReportFigure> heat_map_figures(const FigureInput& input) {
  const auto axes = map_axes(input.table);
  std::vector<ReportFigure> figures;
  if (!axes) return figures;
  for (const FigurePart& part : parts_of(input.table, axes->rest)) {
    if (figures.size() == most_figures) break;
    PositiveRange errors;
    for (const std::size_t g : part.groups) {
      errors.see(std::min(input.summaries[g].finest_error(), largest_error));
    }
    if (errors.empty()) continue;
    figures.push_back(figure_of(input, *axes, part, errors,
                                fmt::format("{}heat_map_{:02}", input.prefix, figures.size() + 1)));
  }
  return figures;
}

std::vector<ReportFigure> figures_of(const FigureInput& input) {
  std::vector<ReportFigure> all;
  for (auto&& figures : {convergence_figures(input), work_precision_figures(input),
                         heat_map_figures(input), cost_figures(input)}) {
    all.insert(all.end(), figures.begin(), figures.end());
  }
  return all;
}

}  // namespace porowave::reports
