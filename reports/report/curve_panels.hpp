#pragma once

// Curves with bands in panels side by side: what convergence and cost share.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "reports/report/figure_parts.hpp"

namespace porowave::reports {

/// How many characters there is room for, by the number of panels: in a legend, in the title, in
/// the line below it.
struct TextRoom {
  std::size_t legend;
  std::size_t title;
  std::size_t subtitle;
};
TextRoom text_room(std::size_t panels);

inline constexpr std::size_t most_tics = 6;

struct CurvePoint {
  double x, y, low, high;
};
struct Curve {
  std::string legend;
  std::vector<CurvePoint> points;
  double floor = 0.0;  ///< 0: none
  std::string name;    ///< last column of the data
};
/// By panel and by value of the curve axis, both counted within the figure.
using Curves = std::map<std::pair<std::size_t, std::size_t>, Curve>;

struct CurveScales {
  std::string x_title;
  std::string y_title;
  bool y_power = true;         ///< numbers on the y axis as powers of ten, else 1, 2, 5, 10
  std::vector<double> x_tics;  ///< these numbers stand on the x axis, at most most_tics of them
  PositiveRange x;
  PositiveRange y;
};
void add_scales(Figure& figure, const CurveScales& scales);

/// Data, legends and floors; curves beyond what can be told apart are left out.
void add_curves(Figure& figure, const Curves& curves, std::size_t panels, std::size_t total);

/// Values of the panel axis in one figure: [first, first + count).
struct PanelRange {
  std::size_t first;
  std::size_t count;
};
std::vector<PanelRange> panel_ranges(const StudyTable& table, const FigureAxes& axes);
void add_panel_titles(Figure& figure, const StudyTable& table, const FigureAxes& axes,
                      const PanelRange& range);

}  // namespace porowave::reports
