#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/report/curve_panels.hpp"
#include "reports/report/text_forms.hpp"

namespace porowave::reports {

namespace {

double median_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct LevelCosts {
  std::vector<double> points;
  std::vector<double> ns;
};

Curves cost_curves(const FigureInput& input, const FigureAxes& axes, const PanelRange& range) {
  std::map<std::pair<std::size_t, std::size_t>, std::map<double, LevelCosts>> costs;
  for (std::size_t g = 0; g < input.table.groups.size(); ++g) {
    const TableGroup& group = input.table.groups[g];
    const std::size_t panel = place_on(group, axes.panel);
    if (panel < range.first || panel >= range.first + range.count) continue;
    for (const LevelSummary& level : input.summaries[g].levels) {
      if (!(level.ns_per_point_step > 0.0) || !std::isfinite(level.ns_per_point_step)) continue;
      // Levels, not numbers of points: random points in a column with a gap differ in number.
      LevelCosts& of_level =
          costs[{panel - range.first, place_on(group, axes.curve)}][-level.spacing];
      of_level.points.push_back(level.points);
      of_level.ns.push_back(level.ns_per_point_step);
    }
  }
  Curves curves;
  for (const auto& [place, by_level] : costs) {
    Curve& curve = curves[place];
    curve.name = value_on(input.table, axes.curve, place.second);
    curve.legend =
        shortened(curve.name.empty() ? "all cases" : curve.name, text_room(range.count).legend);
    for (const auto& [spacing, level] : by_level) {
      curve.points.push_back({median_of(level.points), median_of(level.ns),
                              *std::min_element(level.ns.begin(), level.ns.end()),
                              *std::max_element(level.ns.begin(), level.ns.end())});
    }
  }
  return curves;
}

/// Cheapest and dearest curve at their largest numbers of points.
std::string cost_claim(const Curves& curves) {
  const Curve* cheap = nullptr;
  const Curve* dear = nullptr;
  for (const auto& [place, curve] : curves) {
    if (!cheap || curve.points.back().y < cheap->points.back().y) cheap = &curve;
    if (!dear || curve.points.back().y > dear->points.back().y) dear = &curve;
  }
  std::string text = fmt::format("{}: {:.3g} ns a point and step at {:.0f} points", cheap->legend,
                                 cheap->points.back().y, cheap->points.back().x);
  if (dear != cheap) {
    text += fmt::format("; {}: {:.3g} ns", dear->legend, dear->points.back().y);
  }
  return text + ". CPU time of the solver, medians; bands over all other keys.";
}

}  // namespace

std::vector<ReportFigure> cost_figures(const FigureInput& input) {
  const FigureAxes axes = figure_axes(input.table);
  std::vector<ReportFigure> figures;
  for (const PanelRange& range : panel_ranges(input.table, axes)) {
    if (figures.size() == 2) break;
    const Curves curves = cost_curves(input, axes, range);
    if (curves.empty()) continue;
    CurveScales scales{"material points (–)", "CPU time a point and step (ns)", false, {}, {}, {}};
    for (const auto& [place, curve] : curves) {
      for (const CurvePoint& point : curve.points) {
        scales.x.see(point.x);
        scales.y.see(point.low);
        scales.y.see(point.high);
        if (place == curves.begin()->first) scales.x_tics.push_back(point.x);
      }
    }
    ReportFigure result{{fmt::format("{}cost_{}", input.prefix, figures.size() + 1),
                         "report_curves",
                         {},
                         "panel,curve,points,ns_per_point_step,smallest,largest,curve_name\n",
                         true},
                        "Cost",
                        cost_claim(curves),
                        {}};
    add_text(result.figure, "caption",
             shortened(result.claim.substr(0, result.claim.find(". CPU")),
                       text_room(range.count).title));
    add_text(result.figure, "subcaption", "median over all other keys, band: smallest to largest");
    add_scales(result.figure, scales);
    add_panel_titles(result.figure, input.table, axes, range);
    add_curves(result.figure, curves, range.count, size_of(input.table, axes.curve));
    for (std::size_t p = 0; p < range.count; ++p) {
      add_text(result.figure, fmt::format("triangle{}", p + 1), "");
    }
    result.alt = "CPU time a point and step against the number of points. " + result.claim;
    figures.push_back(std::move(result));
  }
  return figures;
}

}  // namespace porowave::reports
