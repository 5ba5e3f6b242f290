#pragma once

#include <string>
#include <vector>

#include "solver/case.hpp"

namespace porowave::verification {

/// A method to be measured: everything of a case but its resolution.
struct Method {
  std::string name;  ///< for people: transfer, kernel, what else distinguishes it
  solver::Case scene;
};

/// Every transfer with every kernel, moving least squares of order 1 with both strains, and
/// staggered4 with both orders of its basis and of its time step, on the column of the case given
/// (its problem, placement, points and end stay).
std::vector<Method> every_method(const solver::Case& column);

}  // namespace porowave::verification
