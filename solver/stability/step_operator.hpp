#pragma once

// One step of a case as a linear map of what it carries to the next one: these points, this
// transfer, these ends and drag, without load, while no point moves far enough for new weights.
//
// Points that started at rest hold nothing but interpolations of nodal velocities q and strains of
// the cells (frozen_column.hpp), whatever the transfer. So these are the state: velocities at the
// nodes and stresses in the cells, of either phase. What else points could hold is multiplied by
// flip in every step (velocities) or stays as it is (stresses) and drives the rest: it adds no
// eigenvalue above 1.
//
//   galerkin     rows measured on the operators of ColumnSolver, nodal update by PreparedUpdate
//   staggered4   StaggeredSolver itself, a step at a time; with time_order = 4 rates of forces are
//                part of the state as well
//
// States are scaled: √ρ v and σ/√E, so that the sum of squares is twice the energy per volume.

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "solver/case.hpp"

namespace porowave::solver {

// out = A in; both are as long as `size` and do not overlap. Not for several threads at a time.
struct LinearMap {
  std::size_t size = 0;
  std::function<void(std::span<const double> in, std::span<double> out)> apply;
};

// What the points of a state hold, as the nodal and cell values that they interpolate.
struct CarriedFields {
  std::vector<double> node_x;            // m
  std::vector<double> solid_velocity;    // m/s
  std::vector<double> fluid_velocity;    // m/s
  std::vector<double> cell_x;            // m
  std::vector<double> effective_stress;  // Pa
  std::vector<double> pore_pressure;     // Pa
};

class StepOperator {
 public:
  virtual ~StepOperator() = default;

  virtual std::size_t size() const = 0;  // of a state: four to six numbers a cell
  // The step over time_step > 0, s. The map keeps what it needs of this object.
  virtual LinearMap at(double time_step) const = 0;
  virtual CarriedFields fields(std::span<const double> state) const = 0;
};

// The operator of a case. Its time step, end and load have no part in it, but for the length of a
// half-space (ColumnSolver::grid_length). Throws BreakdownError where the solver would.
std::unique_ptr<const StepOperator> step_operator(const Case& scene);

}  // namespace porowave::solver
