#pragma once

// The step of StaggeredSolver as a linear map (step_operator.hpp): the solver itself, without load,
// started from a state.

#include "solver/stability/step_operator.hpp"

namespace porowave::solver {

class StaggeredStep : public StepOperator {
 public:
  // Throws as StaggeredSolver.
  explicit StaggeredStep(const Case& scene);

  std::size_t size() const override { return scale_.size(); }
  LinearMap at(double time_step) const override;
  CarriedFields fields(std::span<const double> state) const override;

 private:
  std::vector<double> physical(std::span<const double> state) const;

  Case scene_;  // without load, its length settled
  std::size_t cells_;
  double spacing_;
  std::vector<double> scale_;  // of every number of a state
};

}  // namespace porowave::solver
