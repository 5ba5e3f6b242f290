#pragma once

#include <functional>

#include "solver/placement.hpp"
#include "verification/faults/fault.hpp"

namespace porowave::verification::faults {

using PlaceFunction = std::function<solver::PlacedPoints(const solver::Discretization&,
                                                         double spacing, solver::Phase)>;

/// What placed points must fulfil: as many in every cell as asked for, inside of it, their volumes
/// those of the cells that are not empty; both phases and all seeds different where points are
/// random. The first that does not hold.
Catch caught_by_point_facts(const PlaceFunction& place);

}  // namespace porowave::verification::faults
