#pragma once

#include "reference/problem/problem.hpp"

/// Problems that tests of several rooms use.
namespace porowave::fixtures {

/// The material of the paper's column (typical of the published benchmark).
inline Material paper_material() {
  return {0.4, 2650.0, 1000.0, 5.0e9, 2.2e9, 1.0e-11, 1.0e-3};
}

/// The paper's column: 0.1 m, drained traction at x = 0, rigid and sealed at the far end.
inline Problem paper_problem(const Load& load = Load(LoadShape::step, 1.0)) {
  return {paper_material(), {0.1, NearEnd::drained_traction, FarEnd::rigid_sealed}, load};
}

}  // namespace porowave::fixtures
