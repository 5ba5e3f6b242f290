#include "verification/run.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "reference/problem/errors.hpp"
#include "solver/breakdown_cause.hpp"
#include "solver/staggered/staggered_solver.hpp"

namespace porowave::verification {

namespace {

/// A reference worse than this could decide a comparison.
constexpr double sufficient_reference = 1e-6;

double cpu_seconds(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

long peak_rss_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024;  // Linux counts in KiB
}

}  // namespace

std::shared_ptr<const reference::Profile> reference_profile(const Problem& problem, double time,
                                                            double end) {
  const reference::ColumnSolution solution(problem);
  auto profile = std::make_shared<const reference::Profile>(solution, time, end);
  if (!(profile->error() <= sufficient_reference)) {
    throw InputError(fmt::format(
        "the reference cannot resolve this problem at t = {:g} s (bound {:g} of the load), so no "
        "error can be given: expected an end before some hundred crossings of the fast wave",
        time, profile->error()));
  }
  return profile;
}

std::shared_ptr<const reference::Profile> reference_profile(const solver::Case& scene) {
  return reference_profile(scene.problem, scene.time.end, solver::ColumnSolver::grid_length(scene));
}

namespace {

/// Everything but the errors.
template <class Solver>
RunResult run_with(const solver::Case& scene) {
  const auto wall = std::chrono::steady_clock::now();
  const double thread_cpu = cpu_seconds(CLOCK_THREAD_CPUTIME_ID);
  const double process_cpu = cpu_seconds(CLOCK_PROCESS_CPUTIME_ID);
  Solver solver(scene);
  RunResult result;
  result.breakdown = solver.run();
  result.cost.cpu_seconds = solver.threads() == 1
                                ? cpu_seconds(CLOCK_THREAD_CPUTIME_ID) - thread_cpu
                                : cpu_seconds(CLOCK_PROCESS_CPUTIME_ID) - process_cpu;
  result.cost.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
  result.snapshot = solver.snapshot();
  result.steps = solver.steps_done();
  result.path = solver.path();
  result.frozen_steps = solver.frozen_steps();
  result.time_step = solver.time_step();
  const double spacing = solver::ColumnSolver::grid_length(scene) / scene.discretization.elements;
  result.courant = wave_speeds(scene.problem.material).p1 * result.time_step / spacing;
  result.automatic = scene.time.automatic;
  result.points = solver.point_count();
  result.reduced_rows = solver.reduced_rows();
  result.empty_rows = solver.empty_rows();
  return result;
}

}  // namespace

RunResult run_case(const solver::Case& scene, const reference::Profile& profile) {
  RunResult result = scene.discretization.scheme == solver::Scheme::staggered4
                         ? run_with<solver::StaggeredSolver>(scene)
                         : run_with<solver::ColumnSolver>(scene);
  result.reference_error = profile.error();
  for (const double stress : result.snapshot.solid.stress) {
    const double strain = std::abs(stress) / scene.problem.material.constrained_modulus;
    result.largest_strain = std::max(result.largest_strain, strain);
  }
  result.cost.ns_per_point_step = 1e9 * result.cost.cpu_seconds /
                                  static_cast<double>(result.points) /
                                  static_cast<double>(result.steps);
  result.cost.peak_rss_bytes = peak_rss_bytes();
  if (!result.breakdown) {
    const ReferenceValues reference = reference_values(result.snapshot, profile);
    result.errors = field_errors(result.snapshot, reference);
    result.measures = wave_measures(scene, profile, result.snapshot, reference);
  }
  return result;
}

RunResult run_and_explain(const solver::Case& scene, const reference::Profile& profile) {
  RunResult result = run_case(scene, profile);
  if (result.breakdown) {
    result.breakdown->reason = solver::reason_and_cause(scene, *result.breakdown);
  }
  return result;
}

}  // namespace porowave::verification
