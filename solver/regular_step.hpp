#pragma once

// The step of nodes that are all alike (regular_nodes.hpp): no weights are read, only what nodes
// and cells hold. One pass does what the general form does in five.

#include <cstddef>
#include <vector>

namespace porowave::solver {

// How one node goes through a step, both phases with the same W and B (frozen_column.hpp).
struct RegularStencil {
  // Of the relative velocity v_f − v_s, the effective stress force and the pore pressure force.
  struct Change {
    double relative;
    double effective;
    double pressure;
  };
  std::vector<double> velocity;  // W: of q at the node, at its neighbours on either side, the next
  std::vector<double> force;  // S_i − S_(i−1): of e_i − e_(i−1), of e_(i+1) − e_(i−2), the next
  Change solid{};             // v_s' − v_s
  Change lag{};               // (v_f' − v_s') − (v_f − v_s)
};

// q ← flip (q − v) + v', and by how much e rises with the differences of v' across a cell: of σ′ by
// the solid's, of p by both.
struct RegularFactors {
  double flip;
  double effective;
  double pressure_solid;
  double pressure_fluid;
};

// q and e before the step and after it, from the first of the nodes on. Those before are read as
// far as the stencil reaches to either side.
struct RegularFields {
  const double* solid_q;
  const double* fluid_q;
  const double* solid_e;
  const double* fluid_e;
  double* new_solid_q;
  double* new_fluid_q;
  double* new_solid_e;
  double* new_fluid_e;
};

// Of one phase: v' at the first and at the last node, and Σ v'² of all.
struct RegularVelocities {
  double first = 0.0;
  double last = 0.0;
  double squares = 0.0;
};

struct RegularResult {
  RegularVelocities solid;
  RegularVelocities fluid;
};

// A step of 8 `eights` nodes (one at least) and of the cells behind them. The last of these ends at
// a node with the new velocities solid_beyond and fluid_beyond.
RegularResult step_regular(const RegularStencil& stencil, const RegularFactors& factors,
                           const RegularFields& fields, std::size_t eights, double solid_beyond,
                           double fluid_beyond);

}  // namespace porowave::solver
