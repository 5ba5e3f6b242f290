#include "solver/time_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reference/problem/errors.hpp"
#include "solver/column_solver.hpp"
#include "solver/placement.hpp"

namespace porowave::solver {

namespace {

constexpr double share_of_limit = 0.9;

// Volumes of the points of one phase, by cell and by linear functions at the nodes.
struct Volumes {
  std::vector<double> of_cells;
  std::vector<double> of_nodes;
};

Volumes linear_volumes(const Case& scene, Phase phase) {
  const auto cells = static_cast<std::size_t>(scene.discretization.elements);
  const double h = ColumnSolver::grid_length(scene) / scene.discretization.elements;
  const PlacedPoints points = place_points(scene.discretization, h, phase);
  Volumes volumes{std::vector<double>(cells, 0.0), std::vector<double>(cells + 1, 0.0)};
  for (std::size_t p = 0; p < points.x.size(); ++p) {
    const double place = std::max(points.x[p] / h, 0.0);
    const std::size_t cell = std::min(static_cast<std::size_t>(place), cells - 1);
    const double right = place - static_cast<double>(cell);
    volumes.of_cells[cell] += points.volume[p];
    volumes.of_nodes[cell] += (1.0 - right) * points.volume[p];
    volumes.of_nodes[cell + 1] += right * points.volume[p];
  }
  return volumes;
}

}  // namespace

double linear_shape_limit(const Case& scene) {
  const std::array<Volumes, 2> phases = {linear_volumes(scene, Phase::solid),
                                         linear_volumes(scene, Phase::fluid)};
  const std::size_t cells = phases[0].of_cells.size();
  const auto cell_volume = [&](std::size_t c) {
    return std::max(phases[0].of_cells[c], phases[1].of_cells[c]);
  };
  double smallest = 1.0;
  for (std::size_t i = 0; i <= cells; ++i) {
    const double around = (i > 0 ? cell_volume(i - 1) : 0.0) + (i < cells ? cell_volume(i) : 0.0);
    for (const Volumes& phase : phases) {
      // A node that a phase does not reach moves with the other phase.
      if (phase.of_nodes[i] > 0.0) smallest = std::min(smallest, phase.of_nodes[i] / around);
    }
  }
  return std::sqrt(smallest);
}

long step_count(const Case& scene, double spacing) {
  constexpr double most = 1e12;
  const double stable = scene.time.courant * spacing / wave_speeds(scene.problem.material).p1;
  const double steps = std::ceil(scene.time.end / stable * (1.0 - 1e-12));
  if (!(steps <= most)) {
    throw InputError(
        fmt::format("[time] courant = {:g}: a run of {:g} steps: expected at most {:g}",
                    scene.time.courant, steps, most));
  }
  return std::max(1L, std::lround(steps));
}

double estimated_courant(const Case& scene) {
  const Discretization& d = scene.discretization;
  if (d.scheme == Scheme::staggered4) {
    return d.placement == Placement::uniform || scene.time.order == 4 ? 0.8 : 0.5;
  }
  if (d.transfer == TransferName::mls) return d.placement == Placement::random ? 0.4 : 0.7;
  return share_of_limit * linear_shape_limit(scene);
}

}  // namespace porowave::solver
