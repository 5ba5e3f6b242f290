#pragma once

// The paper's column under the smooth load, for the studies of transfers.

#include "reference/problem/problem_fixtures.hpp"
#include "verification/run.hpp"

namespace porowave::verification::studies {

/// Four uniform points per cell and phase, courant 0.5, FLIP, t = 4e-5 s; mls, bspline2, order 1.
inline solver::Case papers_case(int elements) {
  solver::Case scene;
  scene.problem = fixtures::paper_problem(Load(LoadShape::smooth_ramp, 1.0, 1e-5));
  scene.discretization.elements = elements;
  scene.time.end = 4e-5;
  return scene;
}

/// Moving least squares of order 1 with the kernel's natural radius.
template <class Kernel>
solver::Case mls_case(int elements) {
  solver::Case scene = papers_case(elements);
  scene.discretization.kernel = solver::kernel_name<Kernel>;
  scene.discretization.support_radius = Kernel::natural_radius;
  return scene;
}

}  // namespace porowave::verification::studies
