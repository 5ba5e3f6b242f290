#pragma once

#include <vector>

#include "reference/integrand.hpp"
#include "reference/node_table.hpp"

namespace porowave::reference {

struct ContourChoice {
  Hyperbola contour;
  WaveModes::Cut cut;
  double height;  ///< largest integrand on it, as a share of the load: rounding grows with it
};

/// Contours for a group of arrivals, best first: the one with the widest opening on which the
/// integrand stays bearable, then others by their height. Every one is a closed form of the
/// Bromwich line: it encloses all singularities, or passes between 0 and branch points at which
/// the integrand is negligible (or, where `complete`, absent).
///
/// Waves behind the undrained front want an open hyperbola, which needs the fewest nodes. Near that
/// front the integrand falls along the imaginary axis like a Gaussian but grows to both sides, and
/// only a nearly vertical one stays low.
std::vector<ContourChoice> contours_for(const Problem& problem, const WaveModes& modes,
                                        const LoadTransform& load, const ArrivalGroup& group);

}  // namespace porowave::reference
