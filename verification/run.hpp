#pragma once

#include <memory>
#include <optional>
#include <string>

#include "solver/column_solver.hpp"
#include "verification/field_errors.hpp"
#include "verification/wave_measures/wave_measures.hpp"

namespace porowave::verification {

/// What a run cost, without the reference. CPU time is of the calling thread, or of the whole
/// process where the solver used several.
struct Cost {
  double wall_seconds = 0.0;
  double cpu_seconds = 0.0;
  double ns_per_point_step = 0.0;  ///< CPU nanoseconds
  long peak_rss_bytes = 0;         ///< of the process so far
};

/// One run of the solver, and its errors against the reference.
struct RunResult {
  solver::Snapshot snapshot;
  FieldErrors errors;
  WaveMeasures measures;                       ///< of a run that has not broken down
  std::optional<solver::Breakdown> breakdown;  ///< then the snapshot is that of the broken run
  long steps = 0;
  solver::StepPath path = solver::StepPath::points;  ///< frozen if all steps were
  long frozen_steps = 0;
  double time_step = 0.0;  ///< s
  double courant = 0.0;    ///< c_1 Δt/h of that step; the case's, or less to end at time.end
  std::optional<solver::AutomaticStep> automatic;  ///< of courant = "auto"
  std::size_t points = 0;                          ///< of both phases
  std::size_t reduced_rows = 0;
  std::size_t empty_rows = 0;
  double reference_error = 0.0;  ///< bound of the reference, relative to the load
  double largest_strain = 0.0;   ///< of the solid; the reference is that of small strains
  Cost cost;
};

/// The reference profile of a problem at a time (s), for 0 <= x <= end (m); that which judges a
/// case is of its problem at its end time, over its grid. Throws InputError if the reference cannot
/// resolve the problem to 1e-6 of the load.
std::shared_ptr<const reference::Profile> reference_profile(const Problem& problem, double time,
                                                            double end);
std::shared_ptr<const reference::Profile> reference_profile(const solver::Case& scene);

/// Runs a case. A numerical breakdown is a result (errors then are those of the broken fields, not
/// finite where these are not); other failures are exceptions.
RunResult run_case(const solver::Case& scene, const reference::Profile& profile);

/// The same, and of a breakdown the likely cause, at the end of its reason. That may take a hundred
/// times as long as the run (solver/breakdown_cause.hpp), and is not part of its cost.
RunResult run_and_explain(const solver::Case& scene, const reference::Profile& profile);

}  // namespace porowave::verification
