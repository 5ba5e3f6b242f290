#pragma once

#include <string>

#include "reports/gnuplot.hpp"
#include "verification/stability/scene_stability.hpp"

namespace porowave::reports {

/// Growth a step against the Courant number, with the limit, the step of the run and the critical
/// one; below, the velocities and stresses of the fastest-growing mode against x, if there is one.
Figure stability_figure(const verification::SceneStability& found, const std::string& caption,
                        double limit);

}  // namespace porowave::reports
