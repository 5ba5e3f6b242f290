#pragma once

// update_nodes (nodal_update.hpp) for masses and a time step that stay: everything that does not
// depend on velocities and forces is computed once, so that a node costs ten multiplications
// instead of two exponentials and eight divisions.

#include <array>
#include <vector>

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
  void apply(const Problem& problem, const StepLoad& load, Range nodes, const StressForces& forces,
             PhaseNodes& solid, PhaseNodes& fluid) const;

 private:
  double dt_ = 0.0;
  // Of eight neighbouring nodes; m is the mass of both phases.
  struct Coefficients {
    std::array<double, 8> fluid_share{};  // m_f/m
    std::array<double, 8> push{};         // Δt/m
    std::array<double, 8> decay{};        // e^(−θΔt)
    std::array<double, 8> solid_drive{};  // Δt φ_1(θΔt)/m_s
    std::array<double, 8> fluid_drive{};  // Δt φ_1(θΔt)/m_f
  };

  std::vector<Coefficients> coefficients_;
  std::vector<std::size_t> special_;  // ends and nodes without one of the phases, ascending
};

}  // namespace porowave::solver
