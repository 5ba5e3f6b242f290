#pragma once

// Time steps by formulas, to be read beside the critical one.

#include <optional>

#include "solver/case.hpp"

namespace porowave::solver {

// Time steps, s.
struct StepEstimates {
  // h/c_1: the fast wave, without drag, crosses a cell (Courant, Friedrichs & Lewy 1928). The limit
  // of lumped linear elements.
  double fast_wave;
  // h/c with c = undrained_speed: the wave that is left when drag ties both phases together.
  double undrained_wave;
  // time_step.hpp: linear shape functions; absent for other transfers.
  std::optional<double> linear_shape;
  // The limit if drag were explicit, 4/(θ + √(θ² + 4 ω²)), θ the rate at which drag levels both
  // velocities and ω = 2 c_1/h: the step at which 4 − 2 Δt θ − Δt² ω² = 0. Of the kind that
  // Mieremet, Stolle, Ceccato & Vuik give for the Euler–Cromer scheme with explicit drag
  // (Numerical stability for modelling of dynamic two-phase interaction, Int. J. Numer. Anal.
  // Meth. Geomech. 40, 2016): sufficient for lumped linear elements of both phases, and h/c_1
  // without drag, 2/θ with very much. It does not limit this solver, which integrates drag exactly.
  double explicit_drag;
};

StepEstimates step_estimates(const Case& scene);

}  // namespace porowave::solver
