#pragma once

// Momentum of both phases at the nodes over one step: forces, drag, and what the ends prescribe.

#include <cstddef>
#include <vector>

#include "reference/problem/problem.hpp"

namespace porowave::solver {

// Nodal quantities of one phase in 1D (per unit area).
struct PhaseNodes {
  std::vector<double> mass;          // kg; zero where no point reaches the node
  std::vector<double> volume;        // m, the part of the node's volume that the phase fills
  std::vector<double> velocity;      // m/s, before the step
  std::vector<double> force;         // N, internal
  std::vector<double> new_velocity;  // m/s, after the step

  void resize(std::size_t nodes);
};

// The load over a step: its mean for tractions, its values at both ends for a prescribed velocity.
struct StepLoad {
  double mean;
  double before;
  double after;
};

// Drag over a step of dt at a node that both phases reach: the relative velocity is multiplied by
// `decay` and gains its driving acceleration times `effective_time`, s.
struct Drag {
  double decay;
  double effective_time;
};
Drag drag_over(double drag, double dt, const PhaseNodes& solid, const PhaseNodes& fluid,
               std::size_t node);

// From velocities before the step and internal forces, the velocities after a step of dt.
//
// Drag is integrated exactly in the relative velocity w = v_f − v_s for forces constant over the
// step: w' = w e^(−θ dt) + g dt φ_1(−θ dt), θ = d V (1/m_s + 1/m_f). Like the centred implicit rule
// it is of second order and never limits the time step; unlike it, w does not change its sign from
// step to step when θ dt is large.
//
// Where an end prescribes a velocity, `velocity` is overwritten as well, so that the increment that
// the points get (new_velocity − velocity) is that of the end. At a node that one phase does not
// reach, that phase moves with the other one.
void update_nodes(const Problem& problem, const StepLoad& load, double dt, PhaseNodes& solid,
                  PhaseNodes& fluid);
// The same for one node.
void update_node(const Problem& problem, const StepLoad& load, double dt, std::size_t node,
                 PhaseNodes& solid, PhaseNodes& fluid);

}  // namespace porowave::solver
