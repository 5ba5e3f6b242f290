#pragma once

// What lifts the staggered time step from second to fourth order (time_order = 4), by the modified
// equation: over a step the forces f and velocities v are not constant but, with derivatives in
// time,
//
//   f(t + τ) = f + τ f′ + τ²/2 f″     over t ± dt/2,  f″ = the force of the stress rates of a,
//                                     a = Δv/dt of the plain step
//   mean of v = v + dt²/24 v″         over a step of the stress, v″ = f′/ρ − drag of v′
//
// where f′ is the force of the stress rates of v. The τ² term is a constant force f″ dt²/24. The
// τ term cancels but for drag, which forgets what came first: it acts on the relative velocity by
// χ(θ) dt² (f′_f/ρ_f − f′_s/ρ_s). For stiff drag (θ = relaxation rate · dt > 1) the terms of drag
// are bounded so that they do not limit the time step; the order then falls back to two. Sources:
// Dablain (1986), doi:10.1190/1.1442040, for the wave equation; drag as derived here.

#include <cstddef>

#include "reference/problem/problem.hpp"
#include "solver/staggered/velocity_update.hpp"

namespace porowave::solver {

// Which part of the time step forces act over: all of t ± dt/2, or t − dt/2 to t.
enum class StepPart { whole, first_half };

class TimeCorrection {
 public:
  // dt > 0: the whole step, s.
  TimeCorrection(const Problem& problem, double dt, std::size_t nodes);

  // f of now becomes the constant force with the effect of f(t + τ), for the nodes before `end`.
  // `second` is f″ dt.
  void correct(BothPhases& forces, const BothPhases& second, StepPart part, std::size_t end) const;

  // The mean velocities over dt around the time of `solid` and `fluid` (the new half step), from
  // force_rates there and the increments of the last step. `load_mean` is that of the load.
  void find_mean_velocities(const std::vector<double>& solid, const std::vector<double>& fluid,
                            const BothPhases& increments, double load_mean, std::size_t end,
                            BothPhases& mean) const;

  BothPhases force_rates;  // f′ at the last half step

 private:
  void prescribe_mean_at_ends(double load_mean, BothPhases& mean) const;

  Problem problem_;
  double dt_;
  double theta_;
};

}  // namespace porowave::solver
