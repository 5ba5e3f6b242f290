#pragma once

// update_nodes (nodal_update.hpp) for masses and a time step that stay: everything that does not
// depend on velocities and forces is computed once, so that a node costs ten multiplications
// instead of two exponentials and eight divisions.

#include <span>
#include <vector>

#include "solver/free_node.hpp"
#include "solver/nodal_update.hpp"
#include "solver/range_rows.hpp"

namespace porowave::solver {

// −∫ ∂N_i s dx of the effective stress and of the pore pressure, N, from the first node of a range.
struct StressForces {
  const double* effective;
  const double* pressure;
};

class PreparedUpdate {
 public:
  PreparedUpdate() = default;
  // Masses and volumes of the nodes, and the step in s.
  PreparedUpdate(const Problem& problem, double dt, const PhaseNodes& solid,
                 const PhaseNodes& fluid);

  // nodes.first must be a multiple of eight.
  // New velocities of the nodes [nodes.first, nodes.last) from velocities and forces, as
  // update_nodes gives them to rounding. `force` is only set where an end acts or a phase is
  // missing.
  void apply(const Problem& problem, const StepLoad& load, IndexRange nodes,
             const StressForces& forces, PhaseNodes& solid, PhaseNodes& fluid) const;

  // The ends, and nodes without one of the phases, in the range: where update_node must be asked.
  std::span<const std::size_t> special(IndexRange nodes) const;
  // Of the eight nodes from 8 * eight on.
  const NodeCoefficients& coefficients(std::size_t eight) const { return coefficients_[eight]; }
  double time_step() const { return dt_; }

 private:
  double dt_ = 0.0;
  std::vector<NodeCoefficients> coefficients_;
  std::vector<std::size_t> special_;  // ends and nodes without one of the phases, ascending
};

}  // namespace porowave::solver
