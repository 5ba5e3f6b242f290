#pragma once

// Both phases at a node where both are free, over one step, with what does not depend on velocities
// and forces computed before (prepared_update.hpp). Stresses act by -∫ ∂N_i s dx, N.

#include <array>

#include "solver/simd.hpp"

namespace porowave::solver {

// Of eight neighbouring nodes; m is the mass of both phases. All zero where a node is not free.
struct alignas(64) NodeCoefficients {
  std::array<double, 8> fluid_share{};  // m_f/m
  std::array<double, 8> push{};         // Δt/m
  std::array<double, 8> decay{};        // e^(−θΔt)
  std::array<double, 8> solid_drive{};  // Δt φ_1(θΔt)/m_s
  std::array<double, 8> fluid_drive{};  // Δt φ_1(θΔt)/m_f
};

// One node (Number = double, `lane` its place among the eight) or all eight. `effective` and
// `pressure` are the forces of the two stresses; ns, nf the volume fractions.
template <class Number>
POROWAVE_INLINE void move_free(const NodeCoefficients& at, std::size_t lane, double ns, double nf,
                               const Number& effective, const Number& pressure, const Number& vs,
                               const Number& vf, Number& new_vs, Number& new_vf) {
  Number fluid_share, push, decay, solid_drive, fluid_drive;
  read(at.fluid_share.data() + lane, fluid_share);
  read(at.push.data() + lane, push);
  read(at.decay.data() + lane, decay);
  read(at.solid_drive.data() + lane, solid_drive);
  read(at.fluid_drive.data() + lane, fluid_drive);
  const Number solid_force = effective - ns * pressure;
  const Number fluid_force = -nf * pressure;
  const Number relative = vf - vs;
  const Number new_mean = vs + fluid_share * relative + push * (solid_force + fluid_force);
  const Number new_relative =
      relative * decay + (fluid_force * fluid_drive - solid_force * solid_drive);
  new_vs = new_mean - fluid_share * new_relative;
  new_vf = new_vs + new_relative;
}

}  // namespace porowave::solver
