#include "reports/report/curve_panels.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/report/text_forms.hpp"

namespace porowave::reports {

namespace {

constexpr std::size_t panels_in_figure = 3;
constexpr std::size_t curves_in_panel = 16;
/// Errors beyond this are of runs that went wrong; axes leave them out.
constexpr double largest_shown = 30.0;

/// Every one, every second, ... so that they have room.
std::string tics_text(std::vector<double> tics) {
  std::sort(tics.begin(), tics.end());
  tics.erase(std::unique(tics.begin(), tics.end()), tics.end());
  const std::size_t stride = (tics.size() + most_tics - 1) / most_tics;
  std::string text;
  for (std::size_t i = 0; i < tics.size(); i += stride) {
    text += tics[i] >= 1000.0 ? fmt::format("{:.0f} ", tics[i]) : fmt::format("{:.4g} ", tics[i]);
  }
  return text;
}

}  // namespace

TextRoom text_room(std::size_t panels) {
  if (panels == 1) return {80, 72, 95};
  return {panels == 2 ? std::size_t{52} : std::size_t{34}, 100, 130};
}

void add_scales(Figure& figure, const CurveScales& scales) {
  add_text(figure, "x_title", scales.x_title);
  add_text(figure, "y_title", scales.y_title);
  add_text(figure, "y_power", scales.y_power ? "yes" : "no");
  add_text(figure, "x_low", real_text(0.7 * scales.x.low));
  add_text(figure, "x_high", real_text(1.5 * scales.x.high));
  add_text(figure, "y_low", real_text((scales.y_power ? 0.25 : 0.7) * scales.y.low));
  const double high = std::min(scales.y.high, std::max(largest_shown, 2.0 * scales.y.low));
  add_text(figure, "y_high", real_text(scales.y_power ? 1.6 * high : 1.4 * scales.y.high));
  add_text(figure, "x_tics", tics_text(scales.x_tics));
}

void add_curves(Figure& figure, const Curves& curves, std::size_t panels, std::size_t total) {
  total = std::min(total, curves_in_panel);
  std::size_t legend_lines = 0;
  for (std::size_t p = 0; p < panels; ++p) {
    std::size_t lines = 0;
    for (std::size_t c = 0; c < total; ++c) {
      const auto found = curves.find({p, c});
      const bool there = found != curves.end() && !found->second.points.empty();
      add_text(figure, fmt::format("legend_{}_{}", p + 1, c + 1),
               there ? found->second.legend : "");
      const double floor = there ? found->second.floor : 0.0;
      add_text(figure, fmt::format("floor_{}_{}", p + 1, c + 1),
               floor > 0.0 ? real_text(floor) : "");
      if (!there) continue;
      ++lines;
      for (const CurvePoint& point : found->second.points) {
        figure.data += fmt::format("{},{},{:.6g},{:.4e},{:.4e},{:.4e},{}\n", p + 1, c + 1, point.x,
                                   point.y, point.low, point.high, csv_field(found->second.name));
      }
    }
    legend_lines = std::max(legend_lines, lines);
  }
  add_text(figure, "panels", fmt::format("{}", panels));
  add_text(figure, "curves", fmt::format("{}", total));
  add_text(figure, "legend_lines", fmt::format("{}", legend_lines));
}

std::vector<PanelRange> panel_ranges(const StudyTable& table, const FigureAxes& axes) {
  std::vector<PanelRange> ranges;
  const std::size_t size = size_of(table, axes.panel);
  for (std::size_t first = 0; first < size; first += panels_in_figure) {
    ranges.push_back({first, std::min(panels_in_figure, size - first)});
  }
  return ranges;
}

void add_panel_titles(Figure& figure, const StudyTable& table, const FigureAxes& axes,
                      const PanelRange& range) {
  for (std::size_t p = 0; p < range.count; ++p) {
    const std::string value = value_on(table, axes.panel, range.first + p);
    add_text(figure, fmt::format("title{}", p + 1),
             axes.panel ? shortened(table.axes[*axes.panel].title + " = " + value,
                                    text_room(range.count).legend)
                        : std::string());
  }
}

}  // namespace porowave::reports
