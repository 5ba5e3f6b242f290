#include "solver/poor_place.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "solver/column_solver.hpp"
#include "solver/weights.hpp"

namespace porowave::solver {

namespace {

constexpr double light_share = 0.45;

const char* phase_word(Phase phase) {
  return phase == Phase::solid ? "solid" : "fluid";
}

std::string of_moment_matrices(const Case& scene, double x, double reach) {
  const Discretization& d = scene.discretization;
  const double h = ColumnSolver::grid_length(scene) / d.elements;
  std::vector<Vector<1>> places;
  for (int k = 0; k <= 2 * d.elements; ++k) {
    if (std::abs(0.5 * k * h - x) <= reach) places.emplace_back(0.5 * k * h);
  }
  const double radius = d.support_radius * h;
  const Support support = d.adaptive_support
                              ? Support(radius, std::max(radius, largest_adaptive_radius * h),
                                        well_conditioned_limit(d.basis_order))
                              : Support(radius);
  int lowest = d.basis_order;
  std::string words;
  for (const Phase phase : {Phase::solid, Phase::fluid}) {
    std::vector<Vector<1>> points;
    for (const double p : place_points(d, h, phase).x) points.emplace_back(p);
    MlsReport report;
    mls_rows<1>(places, points, d.kernel, support, d.basis_order, report);
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (report.order_used[k] >= lowest) continue;
      lowest = report.order_used[k];
      words = lowest < 0 ? fmt::format(" (no {} point is within reach of x = {:.6g} m)",
                                       phase_word(phase), places[k][0])
                         : fmt::format(" (the {} points around x = {:.6g} m carry order {} of {})",
                                       phase_word(phase), places[k][0], lowest, d.basis_order);
    }
  }
  return words;
}

std::string of_masses(const Case& scene, double x, double reach) {
  Case visiting = scene;
  visiting.time.path = StepPath::points;
  const ColumnSolver solver(visiting);
  const int nodes = scene.discretization.elements;
  const double h = ColumnSolver::grid_length(scene) / nodes;
  const Material& m = scene.problem.material;
  double smallest = light_share;
  std::string words;
  for (const Phase phase : {Phase::solid, Phase::fluid}) {
    const double density =
        phase == Phase::solid ? m.solid_partial_density() : m.fluid_partial_density();
    for (int i = 0; i <= nodes; ++i) {
      const double full = density * h * (i == 0 || i == nodes ? 0.5 : 1.0);
      const double share = solver.nodes(phase).mass[static_cast<std::size_t>(i)] / full;
      // A node without any mass moves with the other phase, or not at all.
      if (std::abs(i * h - x) > reach || share >= smallest || share <= 0.0) continue;
      smallest = share;
      words = fmt::format(" (the {} has {:.2g} of its mass at the node at x = {:.6g} m)",
                          phase_word(phase), share, i * h);
    }
  }
  return words;
}

}  // namespace

std::string poor_place(const Case& scene, double x, double reach) {
  const Discretization& d = scene.discretization;
  if (d.scheme != Scheme::galerkin) return "";
  return d.transfer == TransferName::mls ? of_moment_matrices(scene, x, reach)
                                         : of_masses(scene, x, reach);
}

}  // namespace porowave::solver
