#include "reference/explanation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/time_slice.hpp"

namespace porowave::reference {

namespace {

constexpr double uncertainty = 8.0 * std::numeric_limits<double>::epsilon();
constexpr int levels = 7;
/// Terms below this share of the load are not shown.
constexpr double counts = 1e-17;

void sum_levels(Integrand& integrand, NodeTable& table, ExplainedGroup& group) {
  FourSums sum{};
  std::size_t nodes = 0;
  double last = 0.0;
  for (int level = 0; level < levels; ++level) {
    for (std::size_t j = 0;; ++j) {
      const Node& node = table.at(level, j);
      if (node.u > last + (level == 0 ? 2.5 : 0.5)) break;
      const NodeSum term = integrand.at(node);
      if (!term.finite()) return;
      ++nodes;
      for (std::size_t f = 0; f < 4; ++f) sum[f] += term.value[f];
      if (term.size > counts) {
        last = std::max(last, node.u);
        if (level < 4) group.nodes.push_back(node.s);
      }
    }
    FourSums value;
    for (std::size_t f = 0; f < 4; ++f) value[f] = sum[f] * NodeTable::step(level);
    group.by_level.push_back(value);
    group.nodes_by_level.push_back(nodes);
  }
}

}  // namespace

std::vector<double> ExplainedGroup::log_heights(const Problem& problem,
                                                const std::vector<Complex>& s) const {
  const WaveModes modes(problem.material);
  const LoadTransform load(problem.load);
  Integrand integrand(problem, load, arrivals);
  std::vector<double> heights;
  heights.reserve(s.size());
  for (const Complex place : s) {
    const WaveState state = wave_state(problem, modes, modes.at(place, choice.cut));
    const double size = integrand.at({0.0, place, std::abs(place), state, std::nullopt}).size;
    heights.push_back(std::isfinite(size) ? std::log10(std::max(size, 1e-300)) : 300.0);
  }
  return heights;
}

std::vector<ExplainedGroup> explain(const ColumnSolution& solution, double x, double t) {
  TimeSlice(solution, t).at(x);  // refuses what is outside
  const Problem& problem = solution.problem();
  const LoadTransform load(problem.load);
  std::vector<ExplainedGroup> groups;
  if (!(t > 0.0)) return groups;
  const auto rays = rays_until(problem, solution.modes(), x, t * (1.0 + uncertainty));
  const ArrivalGroups arrived =
      arrivals_of(problem, solution.modes(), load, rays, t, t * uncertainty);
  for (const ArrivalGroup& group : arrived.groups) {
    const auto choices = contours_for(problem, solution.modes(), load, group);
    if (choices.empty()) continue;
    ExplainedGroup explained{
        group.arrivals.size(), group.arrivals.front().since, choices.front(), 0.0, {}, {}, {},
        group.arrivals};
    Integrand integrand(problem, load, group.arrivals);
    NodeTable table(problem, solution.modes(), choices.front().contour, choices.front().cut);
    explained.bound = invert(integrand, table, t * uncertainty).worst;
    sum_levels(integrand, table, explained);
    groups.push_back(std::move(explained));
  }
  return groups;
}

}  // namespace porowave::reference
