#pragma once

#include <span>

#include "reports/gnuplot.hpp"
#include "verification/work_precision.hpp"

namespace porowave::reports {

/// Error of every method against its CPU time: one panel for shape and apic, one for moving least
/// squares (dashed: recovered strains), one for staggered4; in all of them, in grey, the best of
/// all. Measurements of one method stand next to each other.
Figure solver_work_precision(std::span<const verification::WorkPrecision> measured);

}  // namespace porowave::reports
