#pragma once

#include "verification/faults/fault.hpp"
#include "verification/gate/gate.hpp"
#include "verification/sweep/sweep.hpp"

namespace porowave::verification::faults {

/// The two coarsest levels of one group of the study pull_request: smooth_ramp, bspline2, recovered
/// strain, until 4e-5 s or, as the wave has come back from the far end, 8e-5 s. An error of a level
/// that is red here is red there.
enum class Until { first_passage, return_of_the_wave };

/// Runs it by `run` and judges it against the committed baseline.
std::vector<Verdict> verdicts_of_slice(const RunFunction& run, Until until = Until::first_passage);
/// The same as a catch: the first verdict that is not a pass.
Catch caught_by_study(const RunFunction& run, Until until = Until::first_passage);

}  // namespace porowave::verification::faults
