#pragma once

#include <algorithm>
#include <ctime>
#include <vector>

#include "solver/column_solver.hpp"

// Scenes whose cost is measured, and the measuring of it.
namespace porowave::bench {

using solver::Case;
using solver::ColumnSolver;
using solver::Placement;
using solver::StepPath;

struct Scene {
  int elements = 4000;
  int points_per_element = 4;
  double support_radius = solver::natural_radius(solver::kernel_name<solver::BSpline2>);
  Placement placement = Placement::uniform;  // both phases then have the same points
};

/// The paper's column under a smooth load, bspline2, basis order 1.
inline Case case_of(const Scene& scene, StepPath path) {
  Case result;
  result.problem.material = {.porosity = 0.4,
                             .grain_density = 2650.0,
                             .fluid_density = 1000.0,
                             .constrained_modulus = 5.0e9,
                             .fluid_bulk_modulus = 2.2e9,
                             .intrinsic_permeability = 1.0e-11,
                             .fluid_viscosity = 1.0e-3};
  result.problem.column = {0.1, NearEnd::drained_traction, FarEnd::rigid_sealed};
  result.problem.load = Load(LoadShape::smooth_ramp, 1.0, 1.0e-5);
  result.discretization.elements = scene.elements;
  result.discretization.points_per_element = scene.points_per_element;
  result.discretization.support_radius = scene.support_radius;
  result.discretization.placement = scene.placement;
  result.time.end = 4.0e-5;
  result.time.path = path;
  return result;
}

inline double cpu_now() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

inline double wall_now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Not so many that values ahead of the wave become too small for normal numbers; frozen, three
/// times as many as are made at once.
inline int steps_at_a_time(const ColumnSolver& solver) {
  const auto least = solver.path() == StepPath::frozen ? 48ul : 4ul;
  return static_cast<int>(std::clamp(4'000'000 / solver.point_count(), least, 150ul));
}

/// Seconds per step from rest on; the copy is not timed.
inline double time_steps(const ColumnSolver& at_rest, double (*now)()) {
  ColumnSolver solver(at_rest);
  const int steps = steps_at_a_time(solver);
  const double start = now();
  solver.advance(steps);
  return (now() - start) / steps;
}

inline ColumnSolver whole_column(const Scene& scene, StepPath path, std::size_t threads = 1) {
  ColumnSolver solver(case_of(scene, path));
  solver.disregard_causality();
  solver.use_threads(threads);
  return solver;
}

inline double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

}  // namespace porowave::bench
