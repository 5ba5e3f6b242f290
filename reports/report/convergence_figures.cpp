#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/report/curve_panels.hpp"
#include "reports/report/text_forms.hpp"

namespace porowave::reports {

namespace {

std::vector<std::size_t> groups_in(const StudyTable& table, const FigureAxes& axes,
                                   const FigurePart& part, const PanelRange& range) {
  std::vector<std::size_t> groups;
  for (const std::size_t g : part.groups) {
    const std::size_t panel = place_on(table.groups[g], axes.panel);
    if (panel >= range.first && panel < range.first + range.count) groups.push_back(g);
  }
  return groups;
}

Curve convergence_curve(const FigureInput& input, std::size_t g, const std::string& value,
                        std::size_t room) {
  const GroupSummary& summary = input.summaries[g];
  Curve curve;
  curve.name = input.table.groups[g].name;
  const std::string order = order_text(summary.order);
  curve.legend = value.empty() ? order : shortened(value, room - 16) + ": " + order;
  curve.floor = std::isfinite(summary.order.floor) ? summary.order.floor : 0.0;
  for (const LevelSummary& level : summary.levels) {
    if (level.ended > 0)
      curve.points.push_back({level.spacing, level.error, level.low, level.high});
  }
  return curve;
}

/// The triangle below the best curve of a panel that has an order.
std::string triangle(const FigureInput& input, const std::vector<std::size_t>& groups) {
  std::vector<std::size_t> with_order;
  for (const std::size_t g : groups) {
    const auto& order = input.summaries[g].order;
    if (order.status == verification::OrderStatus::observed && order.order > 0.0) {
      with_order.push_back(g);
    }
  }
  const auto best = extreme_group(input.summaries, with_order, false);
  if (!best) return "";
  const GroupSummary& summary = input.summaries[*best];
  constexpr double beside = 1.25;
  constexpr double below = 0.42;
  const double p = summary.order.order;
  return fmt::format("{} {} {:#.2f}", real_text(beside * summary.finest().spacing),
                     real_text(below * summary.finest().error * std::pow(beside, p)), p);
}

std::string level_phrase(const StudyTable& table, const LevelSummary& level) {
  return fmt::format("{} = {}", table.refined_by.substr(table.refined_by.rfind('.') + 1),
                     level.text.empty() ? "default" : level.text);
}

/// Best and worst group in words.
std::string extremes_claim(const FigureInput& input, const FigureAxes& axes,
                           const std::vector<std::size_t>& groups) {
  std::vector<std::size_t> shown_axes;
  if (axes.curve) shown_axes.push_back(*axes.curve);
  if (axes.panel) shown_axes.push_back(*axes.panel);
  const auto best = extreme_group(input.summaries, groups, false);
  const auto worst = extreme_group(input.summaries, groups, true);
  if (!best) return "No group has an error for all cases of its finest level.";
  const auto described_group = [&](std::size_t g) {
    const GroupSummary& s = input.summaries[g];
    return fmt::format("{}, with {:.2g} at {} (order: {})",
                       name_on(input.table, shown_axes, input.table.groups[g]), s.finest_error(),
                       level_phrase(input.table, s.finest()), order_text(s.order));
  };
  std::string text = "Smallest error: " + described_group(*best) + ".";
  if (*worst != *best) text += " Largest: " + described_group(*worst) + ".";
  return text;
}

/// The title within the figure: its claim in one line.
std::string short_claim(const FigureInput& input, const FigureAxes& axes,
                        const std::vector<std::size_t>& groups) {
  const auto best = extreme_group(input.summaries, groups, false);
  if (!best) return "Convergence";
  const TableGroup& group = input.table.groups[*best];
  std::string name = value_on(input.table, axes.curve, place_on(group, axes.curve));
  if (axes.panel) {
    name += fmt::format(", {} {}", input.table.axes[*axes.panel].title,
                        value_on(input.table, axes.panel, group.at[*axes.panel]));
  }
  const auto& order = input.summaries[*best].order;
  const std::string of_order = order.status == verification::OrderStatus::observed
                                   ? fmt::format(", order {:.2f}", order.order)
                                   : fmt::format(" ({})", order_text(order));
  return name.empty() ? "Convergence" + of_order
                      : shortened("Smallest error: " + name, 58) + of_order;
}

ReportFigure convergence_figure_of(const FigureInput& input, const FigureAxes& axes,
                                   const FigurePart& part, const PanelRange& range,
                                   const std::string& name, CurveScales scales) {
  const auto groups = groups_in(input.table, axes, part, range);
  ReportFigure result{{name, "report_curves", {}, {}, true}, "Convergence", {}, {}};
  Figure& figure = result.figure;
  figure.data = "panel,curve,spacing,error,smallest,largest,group\n";
  const std::string where = described(input.table, axes.rest, part.at);
  const std::size_t seeds = most_seeds(input.summaries, groups);
  const std::string how =
      seeds > 1 ? fmt::format("mean and range of {} seeds, dotted: floor", seeds) : "dotted: floor";
  const TextRoom room = text_room(range.count);
  add_text(figure, "caption", shortened(short_claim(input, axes, groups), room.title));
  add_text(figure, "subcaption",
           shortened(where.empty() ? how : where + " · " + how, room.subtitle));
  for (const std::size_t g : groups) {
    for (const LevelSummary& level : input.summaries[g].levels) {
      scales.y.see(level.low);
      scales.y.see(level.high);
    }
  }
  add_scales(figure, scales);
  add_panel_titles(figure, input.table, axes, range);
  Curves curves;
  for (const std::size_t g : groups) {
    const TableGroup& group = input.table.groups[g];
    const std::size_t c = place_on(group, axes.curve);
    curves[{place_on(group, axes.panel) - range.first, c}] =
        convergence_curve(input, g, value_on(input.table, axes.curve, c), room.legend);
  }
  add_curves(figure, curves, range.count, size_of(input.table, axes.curve));
  for (std::size_t p = 0; p < range.count; ++p) {
    std::vector<std::size_t> in_panel;
    for (const std::size_t g : groups) {
      if (place_on(input.table.groups[g], axes.panel) == range.first + p) in_panel.push_back(g);
    }
    add_text(figure, fmt::format("triangle{}", p + 1), triangle(input, in_panel));
  }
  result.claim = (where.empty() ? "" : where + ": ") + extremes_claim(input, axes, groups);
  result.alt = fmt::format("Error against element length on logarithmic axes, {} curves. {}",
                           groups.size(), result.claim);
  return result;
}

}  // namespace

std::vector<ReportFigure> convergence_figures(const FigureInput& input) {
  const FigureAxes axes = figure_axes(input.table);
  const std::string length = input.table.spacing_is_length ? "element length h (m)"
                             : input.table.refined_by == "discretization.elements"
                                 ? "1/elements (–)"
                                 : input.table.refined_by;
  CurveScales scales{
      length, "relative error (–): " + measure_title(verification::measure_names()[input.measure]),
      true,   {},
      {},     {}};
  std::size_t most_levels = 0;
  for (const GroupSummary& summary : input.summaries) {
    std::size_t levels = 0;
    for (const LevelSummary& level : summary.levels) {
      scales.x.see(level.spacing);
      scales.x_tics.push_back(level.spacing);
      if (level.ended > 0) ++levels;
    }
    most_levels = std::max(most_levels, levels);
  }
  std::vector<ReportFigure> figures;
  if (most_levels < 2) return figures;
  for (const FigurePart& part : parts_of(input.table, axes.rest)) {
    for (const PanelRange& range : panel_ranges(input.table, axes)) {
      if (figures.size() == most_figures) return figures;
      if (groups_in(input.table, axes, part, range).empty()) continue;
      const auto name = fmt::format("{}convergence_{:02}", input.prefix, figures.size() + 1);
      figures.push_back(convergence_figure_of(input, axes, part, range, name, scales));
    }
  }
  return figures;
}

}  // namespace porowave::reports
