#pragma once

#include "solver/case.hpp"

namespace porowave::verification {

/// How fast noise grows in real runs of the solver, for comparison with what the step operator
/// (solver/stability/) says. Nothing of solver/stability is used.
struct ObservedGrowth {
  double per_step;  ///< factor by which the largest value grows in a step, late in the run
  long steps;       ///< of the run
};

/// A run of the case at a Courant number, its load left out, from noise of the points' velocities
/// and stresses, far too small to move them; with apic and staggered4, whose points start at rest,
/// from a jump of the load of that size. Sizes are judged over the second half of `steps` steps,
/// from the largest values in windows of an eighth; a run that comes within 3/steps of `limit`, or
/// whose growth is below and still rises, goes on, up to 16 times as long. Ends early where values
/// have grown by 1e40.
ObservedGrowth observed_growth(const solver::Case& scene, double courant, long steps, double limit);

}  // namespace porowave::verification
