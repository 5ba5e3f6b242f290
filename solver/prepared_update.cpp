#include "solver/prepared_update.hpp"

#include <algorithm>

#include "solver/simd.hpp"

namespace porowave::solver {

namespace {

// Arrays of a range of nodes.
struct NodeArrays {
  const double* effective;  // forces of the two stresses
  const double* pressure;
  const double* solid_velocity;
  const double* fluid_velocity;
  double* new_solid_velocity;
  double* new_fluid_velocity;
};

template <class Number>
POROWAVE_INLINE void move_free_there(const NodeCoefficients& eight, std::size_t lane, double ns,
                                     double nf, const NodeArrays& at, std::size_t i) {
  Number effective, pressure, vs, vf, new_vs, new_vf;
  read(at.effective + i, effective);
  read(at.pressure + i, pressure);
  read(at.solid_velocity + i, vs);
  read(at.fluid_velocity + i, vf);
  move_free(eight, lane, ns, nf, effective, pressure, vs, vf, new_vs, new_vf);
  write(new_vs, at.new_solid_velocity + i);
  write(new_vf, at.new_fluid_velocity + i);
}

POROWAVE_VECTORISED void move_free_nodes(const NodeCoefficients* coefficients, double ns, double nf,
                                         const NodeArrays& at, std::size_t count) {
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8) move_free_there<Eight>(coefficients[i / 8], 0, ns, nf, at, i);
  for (; i < count; ++i) move_free_there<double>(coefficients[i / 8], i % 8, ns, nf, at, i);
}

}  // namespace

PreparedUpdate::PreparedUpdate(const Problem& problem, double dt, const PhaseNodes& solid,
                               const PhaseNodes& fluid)
    : dt_(dt) {
  const std::size_t nodes = solid.mass.size();
  coefficients_.resize((nodes + 7) / 8);
  for (std::size_t i = 0; i < nodes; ++i) {
    const double ms = solid.mass[i];
    const double mf = fluid.mass[i];
    if (i == 0 || i + 1 == nodes || !(ms > 0.0 && mf > 0.0)) {
      special_.push_back(i);
      continue;
    }
    NodeCoefficients& eight = coefficients_[i / 8];
    const Drag drag = drag_over(problem.material.drag(), dt, solid, fluid, i);
    eight.fluid_share[i % 8] = mf / (ms + mf);
    eight.push[i % 8] = dt / (ms + mf);
    eight.decay[i % 8] = drag.decay;
    eight.solid_drive[i % 8] = drag.effective_time / ms;
    eight.fluid_drive[i % 8] = drag.effective_time / mf;
  }
}

void PreparedUpdate::apply(const Problem& problem, const StepLoad& load, IndexRange nodes,
                           const StressForces& forces, PhaseNodes& solid, PhaseNodes& fluid) const {
  const std::size_t first = nodes.first;
  const double ns = problem.material.solid_fraction();
  const double nf = problem.material.porosity;
  move_free_nodes(&coefficients_[first / 8], ns, nf,
                  {forces.effective, forces.pressure, solid.velocity.data() + first,
                   fluid.velocity.data() + first, solid.new_velocity.data() + first,
                   fluid.new_velocity.data() + first},
                  nodes.size());
  for (const std::size_t i : special(nodes)) {
    solid.force[i] = forces.effective[i - first] - ns * forces.pressure[i - first];
    fluid.force[i] = -nf * forces.pressure[i - first];
    update_node(problem, load, dt_, i, solid, fluid);
  }
}

std::span<const std::size_t> PreparedUpdate::special(IndexRange nodes) const {
  const auto first = std::lower_bound(special_.begin(), special_.end(), nodes.first);
  return {first, std::lower_bound(first, special_.end(), nodes.last)};
}

}  // namespace porowave::solver
