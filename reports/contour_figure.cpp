#include "reports/contour_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/explanation.hpp"
#include "reference/problem/errors.hpp"

namespace porowave::reports {

namespace {

using reference::Complex;
using reference::ExplainedGroup;

constexpr int columns = 180;
constexpr int rows = 120;

/// Part of the plane, in 1/t.
struct Window {
  double left;
  double right;
  double height;
};

/// Shows the nodes that matter and, unless they are far larger, the singularities.
Window window_of(const ExplainedGroup& group, const reference::WaveModes& modes, double t) {
  double nodes = 0.0;
  const std::size_t shown = group.nodes.size() * 3 / 5;
  for (std::size_t i = 0; i < shown; ++i) nodes = std::max(nodes, std::abs(group.nodes[i]) * t);
  const double singular = std::max(modes.relaxation_rate(), std::abs(modes.branch_point())) * t;
  const double size = singular < 4.0 * nodes ? std::max(1.3 * singular, 0.6 * nodes) : nodes;
  return {-size, 0.45 * size, size};
}

const ExplainedGroup& largest(const std::vector<ExplainedGroup>& groups,
                              const ContourPanel& panel) {
  if (groups.empty()) {
    throw InputError(fmt::format("no wave has arrived at x = {} m by t = {} s", panel.x, panel.t));
  }
  return *std::max_element(groups.begin(), groups.end(), [](const auto& a, const auto& b) {
    return a.oldest * static_cast<double>(a.waves) < b.oldest * static_cast<double>(b.waves);
  });
}

std::string field_block(const ExplainedGroup& group, const Problem& problem, const Window& window,
                        double t) {
  std::vector<Complex> places;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double x = std::lerp(window.left, window.right, (column + 0.5) / columns);
      places.emplace_back(x / t, window.height * (row + 0.5) / rows / t);
    }
  }
  const auto heights = group.log_heights(problem, places);
  std::string block = "# Re s t, Im s t, log10 of |integrand s| over the load\n";
  for (std::size_t i = 0; i < places.size(); ++i) {
    block += fmt::format("{:.6g} {:.6g} {:.3f}\n", places[i].real() * t, places[i].imag() * t,
                         std::clamp(heights[i], -12.0, 8.0));
  }
  return block;
}

std::string panel_data(const ContourPanel& panel, int number, Figure& figure) {
  const reference::ColumnSolution solution(panel.problem);
  const auto groups = reference::explain(solution, panel.x, panel.t);
  const ExplainedGroup& group = largest(groups, panel);
  const Window window = window_of(group, solution.modes(), panel.t);
  const auto text = [&](const char* key, double value) {
    figure.texts.emplace_back(fmt::format("{}{}", key, number), fmt::format("{:#.8g}", value));
  };
  figure.texts.emplace_back(fmt::format("title{}", number), panel.title);
  text("left", window.left);
  text("right", window.right);
  text("height", window.height);
  text("cut", -solution.modes().relaxation_rate() * panel.t);
  std::vector<Complex> nodes = group.nodes;
  std::sort(nodes.begin(), nodes.end(), [](Complex a, Complex b) { return a.imag() < b.imag(); });
  std::string data = field_block(group, panel.problem, window, panel.t);
  data += "\n\n# nodes: Re s t, Im s t\n";
  for (const Complex s : nodes) {
    data += fmt::format("{:.8g} {:.8g}\n", s.real() * panel.t, s.imag() * panel.t);
  }
  const Complex branch = solution.modes().branch_point() * panel.t;
  data += fmt::format("\n\n# branch point\n{:.8g} {:.8g}\n\n\n", branch.real(), branch.imag());
  return data;
}

}  // namespace

Figure contour_figure(const std::string& name, const std::string& caption,
                      const std::vector<ContourPanel>& panels) {
  Figure figure{name, "contour", {{"caption", caption}}, ""};
  figure.texts.emplace_back("panels", fmt::format("{}", panels.size()));
  int number = 0;
  for (const ContourPanel& panel : panels) figure.data += panel_data(panel, ++number, figure);
  return figure;
}

}  // namespace porowave::reports
