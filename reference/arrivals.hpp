#pragma once

#include <span>
#include <vector>

#include "reference/load_transform.hpp"
#include "reference/rays.hpp"

namespace porowave::reference {

/// A part of the load that has arrived with a ray: one event of a load that is still passing, or
/// the whole load once it has settled.
struct Arrival {
  enum class Part { event, settled };
  Ray ray;
  Part part;
  std::size_t event;  ///< for Part::event
  double since;       ///< s: the ray's part is the inverse of e^(s since) times the transform
  double age;         ///< s, > 0: the longest time scale of this part, which sets its contour
  bool complete;      ///< one of a complete set of mode combinations (ArrivalGroup)
};

/// Arrivals that are inverted together, oldest first.
struct ArrivalGroup {
  std::vector<Arrival> arrivals;
  /// All mode combinations of every number of crossings are there: the sum is symmetric in the two
  /// modes and has no branch points other than those on the real axis.
  bool complete;
};

struct ArrivalGroups {
  std::vector<ArrivalGroup> groups;
  double neglected = 0.0;  ///< bound for what was left out, as a share of the load
};

/// What has arrived at time t with the rays, in groups of similar age. Parts that are below e^-45
/// of the load (the Bromwich integrand at some real s says so) are left out.
/// Rays that arrive within `uncertainty` after t count as arrived.
ArrivalGroups arrivals_of(const Problem& problem, const WaveModes& modes, const LoadTransform& load,
                          std::span<const Ray> rays, double t, double uncertainty);

}  // namespace porowave::reference
