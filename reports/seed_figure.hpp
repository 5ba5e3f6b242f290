#pragma once

#include <vector>

#include "reports/gnuplot.hpp"
#include "verification/stability/seed_distribution.hpp"

namespace porowave::reports {

inline constexpr std::size_t most_seed_curves = 16;  ///< that can be told apart

/// Share of the seeds with at most a critical Courant number, against it: a curve a combination of
/// the other axes, 1 to most_seed_curves of them (throws std::invalid_argument otherwise). Its
/// legend names the values of the axes that have several. `highest` is that of the scan.
Figure seed_figure(const verification::Study& study,
                   const std::vector<verification::SeedDistribution>& distributions,
                   double highest);

}  // namespace porowave::reports
