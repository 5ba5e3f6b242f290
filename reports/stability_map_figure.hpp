#pragma once

#include <vector>

#include "reports/gnuplot.hpp"
#include "verification/stability/stability_map.hpp"

namespace porowave::reports {

/// Critical Courant numbers of a study as colours: the first axes down, the others across, so that
/// the picture is not much wider than high. A dot marks cases with unstable steps below the
/// critical one; grey ones cannot be run.
Figure stability_map_figure(const verification::Study& study,
                            const std::vector<verification::MappedStability>& map);

}  // namespace porowave::reports
