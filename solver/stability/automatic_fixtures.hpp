#pragma once

// Columns for the tests of courant = "auto".

#include <algorithm>
#include <cmath>

#include "reference/problem/problem_fixtures.hpp"
#include "solver/column_solver.hpp"
#include "solver/staggered/staggered_solver.hpp"

namespace porowave::solver::test {

// Without drag, of the paper's material, through so many crossings by the fast wave.
inline Case undamped_column(int elements, Placement placement, int points, double crossings) {
  Case scene;
  scene.problem = fixtures::paper_problem(Load(LoadShape::step, 1e-3));
  scene.problem.material.intrinsic_permeability = 1.0;
  scene.discretization.elements = elements;
  scene.discretization.placement = placement;
  scene.discretization.points_per_element = points;
  scene.time.end = crossings * 0.1 / wave_speeds(scene.problem.material).p1;
  return scene;
}

inline void use_linear_shape(Discretization& d) {
  d.transfer = TransferName::shape;
  d.shape = shape_name<LinearSpline>;
  d.basis_order = 0;
}

// The largest stress at the end, in multiples of the load's, and where it is.
struct StressPeak {
  double share = 0.0;
  double x = 0.0;
};

template <class Solver>
StressPeak peak_at_end(Solver solver, double load) {
  solver.run();
  const Snapshot now = solver.snapshot();
  StressPeak peak;
  for (const PhasePoints* points : {&now.solid, &now.fluid}) {
    for (std::size_t p = 0; p < points->x.size(); ++p) {
      const double share = std::abs(points->stress[p]) / load;
      if (share <= peak.share) continue;  // false for NaN
      peak = {share, points->x[p]};
    }
  }
  return peak;
}

inline StressPeak peak_at_end(const Case& scene) {
  const double load = scene.problem.stress_scale();
  return scene.discretization.scheme == Scheme::staggered4
             ? peak_at_end(StaggeredSolver(scene), load)
             : peak_at_end(ColumnSolver(scene), load);
}

}  // namespace porowave::solver::test
