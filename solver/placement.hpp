#pragma once

// Where the material points of one phase start.

#include <vector>

#include "solver/case.hpp"

namespace porowave::solver {

enum class Phase { solid = 0, fluid = 1 };

struct PlacedPoints {
  std::vector<double> x;       // m, ascending within a cell for regular placements only
  std::vector<double> volume;  // m (length times unit area) of mixture that each point stands for
};

// Points of a column [0, elements * spacing]. The same case gives the same points on every machine;
// both phases and different seeds give independent ones (Placement::uniform needs no chance).
// Points in an empty element are left out, the others keep their volume: h/n each.
PlacedPoints place_points(const Discretization& discretization, double spacing, Phase phase);

}  // namespace porowave::solver
