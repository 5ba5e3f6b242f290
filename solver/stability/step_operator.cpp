#include "solver/stability/step_operator.hpp"

#include "solver/stability/galerkin_step.hpp"
#include "solver/stability/staggered_step.hpp"

namespace porowave::solver {

std::unique_ptr<const StepOperator> step_operator(const Case& scene) {
  if (scene.discretization.scheme == Scheme::staggered4) {
    return std::make_unique<StaggeredStep>(scene);
  }
  return std::make_unique<GalerkinStep>(scene);
}

}  // namespace porowave::solver
