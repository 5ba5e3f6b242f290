#pragma once

#include <optional>
#include <string>

#include "solver/case.hpp"
#include "verification/adapters/adapter.hpp"
#include "verification/grade/grade.hpp"
#include "verification/run.hpp"

namespace porowave::verification {

/// What came of one case that an adapter has run.
struct AdapterRun {
  PointErrors errors;
  std::size_t points = 0;  ///< rows of its output
  Cost cost;               ///< of the program; no ns_per_point_step, since its steps are not known
  double reference_error = 0.0;
  std::optional<std::string> failure;  ///< why there are no errors, in one line
};

/// Runs `command CASE.toml OUTPUT.csv` on a case and compares what it writes with the reference.
///
/// CASE.toml is the specification (a load table stands beside it), OUTPUT.csv is read by
/// read_points: at t = time.end (a column t may say so, to a millionth), 0 <= x <= grid length.
/// Both lie in a new directory that is removed afterwards. An exit code other than 0, a time limit
/// reached and an output that is missing or wrong are failures. Throws EnvironmentError if the
/// program cannot be started or its case not be written.
AdapterRun run_adapter(const Adapter& adapter, const std::string& specification,
                       const solver::Case& scene, const reference::Profile& reference);

}  // namespace porowave::verification
