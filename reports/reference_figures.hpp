#pragma once

#include "reports/gnuplot.hpp"

namespace porowave::reports {

/// Contours and singularities of three values of the reference: little drag, stiff drag behind the
/// undrained front, and near it.
Figure reference_contours();

/// Work against precision of the routes of the reference in three regimes of drag, measured now:
/// CPU time a value, and error relative to the contour route at full accuracy (which the tests
/// compare with fifty digits).
Figure reference_work_precision();

}  // namespace porowave::reports
