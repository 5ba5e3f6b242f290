#pragma once

#include <string>

#include "reports/gnuplot.hpp"
#include "reports/run_history.hpp"

namespace porowave::reports {

/// Effective stress and pore pressure as colours over x and t, above the size of their errors, with
/// the ways of both waves drawn over them and empty elements shaded. For a history of 2 frames or
/// more. Of more than 250 cells every second, third, ... is drawn.
Figure space_time_figure(const std::string& name, const std::string& caption,
                         const RunHistory& history);

/// The run over the reference, frame by frame, as an animated GIF (<name>.gif); SVG and PNG show
/// the last frame.
Figure animation_figure(const std::string& name, const std::string& caption,
                        const RunHistory& history);

}  // namespace porowave::reports
