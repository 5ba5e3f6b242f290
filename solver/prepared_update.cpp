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

// One node (Number = double) or eight at once.
template <class Number>
POROWAVE_INLINE void move_free(const double* k, double ns, double nf, const NodeArrays& at,
                               std::size_t i) {
  Number effective, pressure, vs, vf, fluid_share, push, decay, solid_drive, fluid_drive;
  read(at.effective + i, effective);
  read(at.pressure + i, pressure);
  read(at.solid_velocity + i, vs);
  read(at.fluid_velocity + i, vf);
  read(k, fluid_share);
  read(k + 8, push);
  read(k + 16, decay);
  read(k + 24, solid_drive);
  read(k + 32, fluid_drive);
  const Number solid_force = effective - ns * pressure;
  const Number fluid_force = -nf * pressure;
  const Number relative = vf - vs;
  const Number new_mean = vs + fluid_share * relative + push * (solid_force + fluid_force);
  const Number new_relative =
      relative * decay + (fluid_force * fluid_drive - solid_force * solid_drive);
  const Number moved = new_mean - fluid_share * new_relative;
  write(moved, at.new_solid_velocity + i);
  write(moved + new_relative, at.new_fluid_velocity + i);
}

POROWAVE_VECTORISED void move_free_nodes(const double* coefficients, double ns, double nf,
                                         const NodeArrays& at, std::size_t count) {
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8) move_free<Eight>(coefficients + 5 * i, ns, nf, at, i);
  for (; i < count; ++i) {
    move_free<double>(coefficients + 5 * (i / 8 * 8) + i % 8, ns, nf, at, i);
  }
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
    Coefficients& eight = coefficients_[i / 8];
    const Drag drag = drag_over(problem.material.drag(), dt, solid, fluid, i);
    eight.fluid_share[i % 8] = mf / (ms + mf);
    eight.push[i % 8] = dt / (ms + mf);
    eight.decay[i % 8] = drag.decay;
    eight.solid_drive[i % 8] = drag.effective_time / ms;
    eight.fluid_drive[i % 8] = drag.effective_time / mf;
  }
}

void PreparedUpdate::apply(const Problem& problem, const StepLoad& load, Range nodes,
                           const StressForces& forces, PhaseNodes& solid, PhaseNodes& fluid) const {
  const std::size_t first = nodes.first;
  const double ns = problem.material.solid_fraction();
  const double nf = problem.material.porosity;
  move_free_nodes(coefficients_[first / 8].fluid_share.data(), ns, nf,
                  {forces.effective, forces.pressure, solid.velocity.data() + first,
                   fluid.velocity.data() + first, solid.new_velocity.data() + first,
                   fluid.new_velocity.data() + first},
                  nodes.size());
  auto special = std::lower_bound(special_.begin(), special_.end(), first);
  for (; special != special_.end() && *special < nodes.last; ++special) {
    const std::size_t k = *special - first;
    solid.force[*special] = forces.effective[k] - ns * forces.pressure[k];
    fluid.force[*special] = -nf * forces.pressure[k];
    update_node(problem, load, dt_, *special, solid, fluid);
  }
}

}  // namespace porowave::solver
