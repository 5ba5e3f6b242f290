#pragma once

// Velocities of both phases at the nodes of a staggered column over a time step.

#include <cstddef>
#include <vector>

#include "reference/problem/problem.hpp"
#include "solver/nodal_update.hpp"

namespace porowave::solver {

// One quantity of both phases, at nodes or at cells.
struct BothPhases {
  std::vector<double> solid;
  std::vector<double> fluid;

  void assign(std::size_t count) {
    solid.assign(count, 0.0);
    fluid.assign(count, 0.0);
  }
};

class VelocityUpdate {
 public:
  // dt > 0, s.
  VelocityUpdate(const Problem& problem, double dt);

  // What the nodes before `end` get over dt from constant forces (N/m³, tractions included) and
  // from drag, exact in the relative velocity. At both ends of the column as update_nodes: where a
  // velocity is prescribed (`load` at both ends of the step), `solid` and `fluid` are overwritten
  // by what they should have been before.
  void find_increments(const BothPhases& forces, const StepLoad& load, std::size_t end,
                       std::vector<double>& solid, std::vector<double>& fluid,
                       BothPhases& increments) const;

 private:
  // Both increments are linear in the forces and in the relative velocity w = v_f − v_s: the sum of
  // momenta gets dt (f_s + f_f), and w gets w (e^−θ − 1) + dt φ_1(θ) (f_f/ρ_f − f_s/ρ_s).
  struct Coefficients {
    double by_solid;
    double by_fluid;
    double by_relative;
  };

  void find_increments_at_ends(const BothPhases& forces, const StepLoad& load,
                               std::vector<double>& solid, std::vector<double>& fluid,
                               BothPhases& increments) const;

  Problem problem_;
  double dt_;
  Coefficients solid_;
  Coefficients fluid_;
};

// (1 − e^−z)/z for z >= 0
double phi_1(double z);

}  // namespace porowave::solver
