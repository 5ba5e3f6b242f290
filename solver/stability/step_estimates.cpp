#include "solver/stability/step_estimates.hpp"

#include <cmath>

#include "solver/column_solver.hpp"
#include "solver/time_step.hpp"

namespace porowave::solver {

StepEstimates step_estimates(const Case& scene) {
  const Material& m = scene.problem.material;
  const Discretization& d = scene.discretization;
  const double h = ColumnSolver::grid_length(scene) / d.elements;
  const double c1 = wave_speeds(m).p1;
  const double theta = m.relaxation_rate();
  const double omega = 2.0 * c1 / h;
  StepEstimates estimates{h / c1, h / m.undrained_speed(), std::nullopt,
                          4.0 / (theta + std::hypot(theta, 2.0 * omega))};
  const bool linear = d.scheme == Scheme::galerkin && d.transfer == TransferName::shape &&
                      d.shape == shape_name<LinearSpline>;
  if (linear) estimates.linear_shape = linear_shape_limit(scene) * estimates.fast_wave;
  return estimates;
}

}  // namespace porowave::solver
