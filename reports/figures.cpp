#include "reports/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/profile.hpp"

namespace porowave::reports {

namespace {

struct Extent {
  double low = 0.0;
  double high = 0.0;
  void see(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double size() const { return high - low; }
};

/// A title within a comment of the data, which ends with its line.
std::string one_line(std::string title) {
  std::replace_if(
      title.begin(), title.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return title;
}

constexpr int reference_points = 801;

/// The reference as a curve; on both sides of every front a point, so that jumps stay upright.
std::string reference_block(const ProfileRow& row, const std::vector<double>& fronts,
                            Extent& stress, Extent& pressure) {
  const reference::ColumnSolution solution(row.scene.problem);
  const double end = solver::ColumnSolver::grid_length(row.scene);
  const reference::Profile profile(solution, row.snapshot.time, end);
  const double q = row.scene.problem.stress_scale();
  std::vector<double> x;
  for (int i = 0; i < reference_points; ++i) x.push_back(end * i / (reference_points - 1.0));
  for (const double front : fronts) {
    x.push_back(front * (1.0 - 1e-12));
    x.push_back(front * (1.0 + 1e-12));
  }
  std::sort(x.begin(), x.end());
  std::string block;
  for (const double position : x) {
    const Fields f = profile.at(std::min(position, end));
    stress.see(f.effective_stress / q);
    pressure.see(f.pore_pressure / q);
    block += fmt::format("{:.10g} {:.10g} {:.10g}\n", position, f.effective_stress / q,
                         f.pore_pressure / q);
  }
  return block;
}

/// Points with a finite value from left to right, or the lowest and highest of each part.
std::vector<std::size_t> drawn_points(const solver::PhasePoints& points, std::size_t most) {
  std::vector<std::size_t> order;
  for (std::size_t p = 0; p < points.x.size(); ++p) {
    if (std::isfinite(points.stress[p])) order.push_back(p);
  }
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return points.x[a] < points.x[b]; });
  if (order.size() <= most) return order;
  const double end = points.x[order.back()];
  const auto parts = static_cast<double>(most / 2);
  const auto part = [&](std::size_t p) { return std::floor(parts * points.x[p] / end); };
  std::vector<std::size_t> kept;
  for (auto begin = order.begin(); begin != order.end();) {
    const auto next =
        std::find_if(begin, order.end(), [&](std::size_t p) { return part(p) != part(*begin); });
    const auto [low, high] = std::minmax_element(begin, next, [&](std::size_t a, std::size_t b) {
      return points.stress[a] < points.stress[b];
    });
    kept.push_back(*std::min(low, high));
    if (low != high) kept.push_back(*std::max(low, high));
    begin = next;
  }
  return kept;
}

std::string points_block(const solver::PhasePoints& points, double q, std::size_t most,
                         Extent& extent) {
  std::string block;
  for (const std::size_t p : drawn_points(points, most)) {
    extent.see(points.stress[p] / q);
    block += fmt::format("{:.10g} {:.10g}\n", points.x[p], points.stress[p] / q);
  }
  return block;
}

/// Begin and end of every empty element, m.
std::string gap_text(const solver::Case& scene) {
  const double h = solver::ColumnSolver::grid_length(scene) / scene.discretization.elements;
  std::string text;
  for (const double inside : scene.discretization.empty_elements) {
    const double begin = std::floor(inside / h) * h;
    text += fmt::format("{:#.10g} {:#.10g} ", begin, begin + h);
  }
  return text;
}

/// Fronts inside the column; those that are too weak to see stay unmarked.
std::vector<double> visible_fronts(const ProfileRow& row) {
  constexpr double visible = 0.01;
  const reference::ColumnSolution solution(row.scene.problem);
  const double t = row.snapshot.time;
  const double end = solver::ColumnSolver::grid_length(row.scene);
  std::vector<double> fronts;
  for (const double x : solution.fronts(t)) {
    const double step = 1e-9 * end;
    if (x <= step || x >= end - step) continue;
    const Fields behind = solution.at(x - step, t).value;
    const Fields ahead = solution.at(x + step, t).value;
    const double jump = std::max(std::abs(behind.effective_stress - ahead.effective_stress),
                                 std::abs(behind.pore_pressure - ahead.pore_pressure));
    if (jump > visible * row.scene.problem.stress_scale()) fronts.push_back(x);
  }
  return fronts;
}

// Numbers for gnuplot's real() keep their point (#): without one it cannot read "1e-05".

/// What the axis shows: the reference and a margin; points beyond it at most as far again.
std::pair<std::string, std::string> axis(const Extent& reference, const Extent& points) {
  const double margin = 0.08 * reference.size();
  const double low = std::max(points.low, reference.low - reference.size());
  const double high = std::min(points.high, reference.high + reference.size());
  return {fmt::format("{:#.4g}", std::min(reference.low, low) - margin),
          fmt::format("{:#.4g}", std::max(reference.high, high) + margin)};
}

}  // namespace

Figure profile_figure(const std::string& name, const std::string& caption,
                      const std::vector<ProfileRow>& rows) {
  Figure figure{name, "profiles", {}, ""};
  Extent stress, pressure, stress_points, pressure_points;
  int number = 0;
  for (const ProfileRow& row : rows) {
    ++number;
    const double q = row.scene.problem.stress_scale();
    const auto jumps = visible_fronts(row);
    std::vector<double> fronts = row.fronts ? std::vector<double>() : jumps;
    std::string waves;
    for (const WaveFront& front : row.fronts.value_or(std::vector<WaveFront>())) {
      fronts.push_back(front.x);
      waves += front.fast ? "P1 " : "P2 ";
    }
    figure.texts.emplace_back(fmt::format("row{}", number), row.title);
    figure.texts.emplace_back(fmt::format("fronts{}", number),
                              fmt::format("{:#.10g}", fmt::join(fronts, " ")));
    figure.texts.emplace_back(fmt::format("waves{}", number), waves);
    figure.texts.emplace_back(fmt::format("gaps{}", number), gap_text(row.scene));
    figure.data += fmt::format("# {}: reference: x (m), effective stress/q, pore pressure/q\n",
                               one_line(row.title));
    figure.data += reference_block(row, jumps, stress, pressure);
    figure.data += "\n\n# solid points: x (m), effective stress/q\n";
    figure.data += points_block(row.snapshot.solid, q, row.most_points, stress_points);
    figure.data += "\n\n# fluid points: x (m), pore pressure/q\n";
    figure.data += points_block(row.snapshot.fluid, q, row.most_points, pressure_points) + "\n\n";
  }
  double end = 0.0;
  for (const ProfileRow& row : rows) {
    end = std::max(end, solver::ColumnSolver::grid_length(row.scene));
  }
  const auto text = [&](const char* variable, const std::string& value) {
    figure.texts.emplace_back(variable, value);
  };
  text("caption", caption);
  text("rows", fmt::format("{}", rows.size()));
  text("x_end", fmt::format("{:#.10g}", end));
  const auto [stress_low, stress_high] = axis(stress, stress_points);
  const auto [pressure_low, pressure_high] = axis(pressure, pressure_points);
  text("stress_low", stress_low);
  text("stress_high", stress_high);
  text("pressure_low", pressure_low);
  text("pressure_high", pressure_high);
  return figure;
}

Figure convergence_figure(const std::string& name, const std::string& caption,
                          const std::vector<ConvergenceCurve>& curves) {
  Figure figure{name, "convergence", {{"caption", caption}}, ""};
  figure.texts.emplace_back("curves", fmt::format("{}", curves.size()));
  int number = 0;
  for (const ConvergenceCurve& curve : curves) {
    figure.texts.emplace_back(fmt::format("curve{}", ++number), curve.title);
    figure.data += fmt::format(
        "# {}: elements, element length (m), relative L2 error of the "
        "reconstructed effective stress, CPU seconds\n",
        one_line(curve.title));
    for (const auto& level : curve.levels) {
      figure.data += fmt::format("{} {:.10g} {:.6e} {:.4e}\n", level.elements, level.element_length,
                                 level.error, level.cpu_seconds);
    }
    figure.data += "\n\n";
  }
  // The triangle of second order stands below the curves, over their finest refinement.
  double lowest = HUGE_VAL;
  double h = HUGE_VAL;
  for (const ConvergenceCurve& curve : curves) {
    lowest = std::min(lowest, curve.levels.back().error);
    h = std::min(h, curve.levels.back().element_length);
  }
  figure.texts.emplace_back("triangle_h", fmt::format("{:#.6g}", 2.2 * h));
  figure.texts.emplace_back("triangle_error", fmt::format("{:#.6g}", 1.6 * lowest));
  return figure;
}

}  // namespace porowave::reports
