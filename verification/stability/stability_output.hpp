#pragma once

#include <ostream>
#include <string>

#include "verification/stability/scene_stability.hpp"

namespace porowave::verification {

/// What was found in a few lines, for people; `limit` is the growth from which on a step counts as
/// unstable.
std::string stability_summary(const SceneStability& found, double limit);

/// courant,time_step,growth,stable: the scan, ascending; growth is the factor a step less 1.
void write_growth_csv(const SceneStability& found, std::ostream& out);

/// x,effective_stress,pore_pressure,solid_velocity,fluid_velocity, then the same four with
/// `_amplitude`: the mode at nodes (velocities) and cell middles (stresses), by ascending x; what a
/// row has not is empty. Velocities in m/s and stresses in Pa of a mode whose size is arbitrary.
void write_mode_csv(const GrowingMode& mode, std::ostream& out);

}  // namespace porowave::verification
