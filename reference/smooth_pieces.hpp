#pragma once

#include <vector>

#include "reference/column_solution.hpp"

namespace porowave::reference {

/// Ends of the pieces of 0 <= x <= `end` on which the fields at time t are analytic and vary on the
/// scale of the piece, ascending: 0, all fronts (of every break of the load), both sides of
/// undrained fronts and of consolidation layers at the ends where drag makes those thin, and `end`.
std::vector<double> smooth_pieces(const ColumnSolution& solution, double t, double end);

/// The same at x = 0 over time: ends of the pieces of 0 <= t <= `end` between which the fields
/// there are analytic, ascending. All arrivals that drag has not used up (of every break of the
/// load), and both sides of undrained waves that come back.
std::vector<double> smooth_times(const ColumnSolution& solution, double end);

}  // namespace porowave::reference
