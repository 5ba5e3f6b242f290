#include "solver/staggered/velocity_update.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace porowave::solver {

double phi_1(double z) {
  return z > 1e-8 ? -std::expm1(-z) / z : 1.0 - 0.5 * z;
}

VelocityUpdate::VelocityUpdate(const Problem& problem, double dt) : problem_(problem), dt_(dt) {
  const Material& m = problem.material;
  const double solid = m.solid_partial_density();
  const double fluid = m.fluid_partial_density();
  const double theta = m.relaxation_rate() * dt;
  const double common = dt / (solid + fluid);
  const double gain = dt * phi_1(theta);
  const double fluid_share = fluid / (solid + fluid);
  const double solid_share = solid / (solid + fluid);
  solid_ = {common + fluid_share * gain / solid, common - fluid_share * gain / fluid,
            -fluid_share * std::expm1(-theta)};
  fluid_ = {common - solid_share * gain / solid, common + solid_share * gain / fluid,
            solid_share * std::expm1(-theta)};
}

void VelocityUpdate::find_increments(const BothPhases& forces, const StepLoad& load,
                                     std::size_t end, std::vector<double>& solid,
                                     std::vector<double>& fluid, BothPhases& increments) const {
  const double* __restrict fs = forces.solid.data();
  const double* __restrict ff = forces.fluid.data();
  const double* __restrict vs = solid.data();
  const double* __restrict vf = fluid.data();
  double* __restrict ds = increments.solid.data();
  double* __restrict df = increments.fluid.data();
  const std::size_t inner_end = std::min(end, solid.size() - 1);
  const Coefficients s = solid_;
  const Coefficients f = fluid_;
  for (std::size_t i = 1; i < inner_end; ++i) {
    const double w = vf[i] - vs[i];
    ds[i] = s.by_solid * fs[i] + s.by_fluid * ff[i] + s.by_relative * w;
    df[i] = f.by_solid * fs[i] + f.by_fluid * ff[i] + f.by_relative * w;
  }
  find_increments_at_ends(forces, load, solid, fluid, increments);
}

// The two ends as a grid of two nodes of unit volume.
void VelocityUpdate::find_increments_at_ends(const BothPhases& forces, const StepLoad& load,
                                             std::vector<double>& solid, std::vector<double>& fluid,
                                             BothPhases& increments) const {
  const std::array<std::size_t, 2> nodes{0, solid.size() - 1};
  PhaseNodes s;
  PhaseNodes f;
  s.resize(2);
  f.resize(2);
  for (std::size_t e = 0; e < 2; ++e) {
    s.mass[e] = problem_.material.solid_partial_density();
    f.mass[e] = problem_.material.fluid_partial_density();
    s.volume[e] = f.volume[e] = 1.0;
    s.velocity[e] = solid[nodes[e]];
    f.velocity[e] = fluid[nodes[e]];
    s.force[e] = forces.solid[nodes[e]];
    f.force[e] = forces.fluid[nodes[e]];
  }
  // A traction already is in the forces.
  update_nodes(problem_, {0.0, load.before, load.after}, dt_, s, f);
  for (std::size_t e = 0; e < 2; ++e) {
    solid[nodes[e]] = s.velocity[e];
    fluid[nodes[e]] = f.velocity[e];
    increments.solid[nodes[e]] = s.new_velocity[e] - s.velocity[e];
    increments.fluid[nodes[e]] = f.new_velocity[e] - f.velocity[e];
  }
}

}  // namespace porowave::solver
