#pragma once

#include <vector>

#include "reference/column_solution.hpp"

namespace porowave::reference {

/// Ends of the pieces of 0 <= x <= `end` on which the fields at time t are analytic and vary on the
/// scale of the piece, ascending: 0, all fronts (of every break of the load), both sides of
/// undrained fronts and of consolidation layers at the ends where drag makes those thin, and `end`.
std::vector<double> smooth_pieces(const ColumnSolution& solution, double t, double end);

}  // namespace porowave::reference
