#pragma once

#include <vector>

#include "reference/digits/column_waves.hpp"
#include "reference/digits/load_events.hpp"

namespace porowave::fixtures::digits {

/// One event of the load in one image: a wave that has crossed the column `crossings` times, `slow`
/// of them as the slow mode, and runs its last leg as `mode`. Without conversion at the ends, it
/// is the same mode all the way.
struct Arrival {
  int crossings = 0;
  int slow = 0;
  std::size_t mode = 0;
  std::size_t event = 0;
  Labels labels = Labels::outer;
  std::array<double, 2> path = {};  ///< m as fast mode, as slow mode
  Real50 late = 0;                  ///< s that it arrives after t; then it counts as arriving at t
};

/// All that is known of (x, t) before any contour is chosen.
struct Point {
  const Problem& problem;
  const Medium<Real50>& medium;
  double x;
  double t;
};

/// Arrivals at most this much of t late count as arrived.
inline constexpr double arrival_tolerance = 8.0 * 2.220446049250313e-16;

/// True if the branch points lie so far right (within 130 degrees of the real axis) that a contour
/// around them may meet too large numbers.
bool has_inner_labels(const Medium<Real50>& medium);

/// What contributes to the fields: waves that have arrived and are not negligible (1e-37 of the
/// load by the bound |f(t)| <= |transform| e^(s t) at the best real s). Where both modes of all
/// images are to be summed (Labels::inner), those that have not arrived as well. An event has inner
/// labels if the medium has them and the event's age times the distance of the branch points from 0
/// is more than `reach`: then the integrand has become negligible before it comes to them.
std::vector<Arrival> arrivals_of(const Point& point, double reach);

}  // namespace porowave::fixtures::digits
