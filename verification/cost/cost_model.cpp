#include "verification/cost/cost_model.hpp"

#include <numeric>

#include "reference/problem/material.hpp"
#include "solver/column_solver.hpp"

namespace porowave::verification {

namespace {

/// Half the width of a shape function, in elements.
double reach(solver::ShapeName shape) {
  const std::string_view name = solver::to_string(shape);
  if (name == "bspline1") return 1.0;
  if (name == "bspline2") return 1.5;
  if (name == "bspline3") return 2.0;
  return 1.25;  // GIMP with four points an element
}

CostFamily family_of(const solver::Case& scene) {
  const solver::Discretization& d = scene.discretization;
  if (d.scheme == solver::Scheme::staggered4) return CostFamily::staggered;
  if (solver::compact_form_available(d, scene.time)) {
    return scene.time.path == solver::StepPath::points ? CostFamily::points : CostFamily::frozen;
  }
  return d.transfer == solver::TransferName::apic ? CostFamily::affine : CostFamily::general;
}

/// Mean over the run of the share of the column that the fast wave has reached, which has gone
/// `travel` lengths of it in the end.
double reached(double travel) {
  return travel <= 1.0 ? travel / 2.0 : 1.0 - 1.0 / (2.0 * travel);
}

}  // namespace

CaseCost case_cost(const solver::Case& scene) {
  const solver::Discretization& d = scene.discretization;
  const CostFamily family = family_of(scene);
  const double elements = d.elements;
  const double travel = wave_speeds(scene.problem.material).p1 * scene.time.end /
                        solver::ColumnSolver::grid_length(scene);
  const double steps = travel * elements / scene.time.courant;
  const double points = 2.0 * elements * d.points_per_element;
  const bool at_nodes = family == CostFamily::frozen || family == CostFamily::staggered;
  const bool window = family == CostFamily::frozen || family == CostFamily::points;
  const double visits = (at_nodes ? elements : points) * steps * (window ? reached(travel) : 1.0);
  const double width = d.transfer == solver::TransferName::mls ? d.support_radius : reach(d.shape);
  return {family,
          {1.0, points, points * width, visits, visits * width, visits * scene.time.xpic_order},
          points};
}

const CostConstants& cost_constants() {
  static constexpr CostConstants constants{{{{4.52e-5, 2.85e-7, 1.68e-7, 1.96e-9, 2.62e-9, 0.0},
                                             {2.89e-5, 8.41e-7, 8.17e-8, 2.31e-9, 1.01e-9, 0.0},
                                             {1.07e-4, 0.0, 2.17e-8, 5.86e-9, 4.77e-9, 3.46e-9},
                                             {0.0, 6.76e-8, 0.0, 2.2e-8, 0.0, 0.0},
                                             {1.59e-4, 5.75e-7, 0.0, 1.39e-8, 0.0, 0.0}}},
                                           {2.64e-5, 1.23e-7}};
  return constants;
}

double solver_seconds(const CaseCost& cost, const CostConstants& constants) {
  const CostTerms& of_family = constants.solver[static_cast<std::size_t>(cost.family)];
  return std::inner_product(cost.terms.begin(), cost.terms.end(), of_family.begin(), 0.0);
}

double judging_seconds(const CaseCost& cost, const CostConstants& constants) {
  return constants.judging[0] + constants.judging[1] * cost.points;
}

double predicted_solver_seconds(const solver::Case& scene) {
  return solver_seconds(case_cost(scene), cost_constants());
}

double predicted_seconds(const solver::Case& scene) {
  const CaseCost cost = case_cost(scene);
  return solver_seconds(cost, cost_constants()) + judging_seconds(cost, cost_constants());
}

}  // namespace porowave::verification
