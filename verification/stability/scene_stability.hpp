#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "solver/case.hpp"
#include "solver/stability/critical_step.hpp"
#include "solver/stability/step_estimates.hpp"

namespace porowave::verification {

/// A mode of the step: what the points hold, as nodal and cell values, where its largest velocity
/// or stress (over the impedance of the mixture) is 1, at that moment and in amplitude.
struct GrowingMode {
  double courant;
  double growth;                        ///< a step
  double angle;                         ///< it turns by this in a step, rad, in [0, pi]
  solver::CarriedFields fields;         ///< real part
  solver::CarriedFields quarter_later;  ///< a quarter of a turn later
};

/// What a case can be told about its time step before it is run.
struct SceneStability {
  double time_step;               ///< s; that of the run
  double courant;                 ///< c_1 Δt/h of it
  long steps;                     ///< of the run
  solver::Growth at_requested;    ///< at that step
  solver::CriticalStep critical;  ///< by Courant numbers
  double fast_crossing;           ///< h/c_1, s: Courant numbers times it are time steps
  solver::StepEstimates estimates;
  /// The fastest-growing mode at the time step of the run; if nothing grows there, that a little
  /// above the critical step; empty if that is the highest of the search.
  std::optional<GrowingMode> mode;
  bool stable(double limit) const { return at_requested.per_step <= 1.0 + limit; }
};

/// `progress` (may be empty) is called after every time step that was looked at. Throws
/// BreakdownError where the solver would, std::invalid_argument for settings out of order.
SceneStability scene_stability(const solver::Case& scene,
                               const solver::CriticalSettings& settings = {},
                               const std::function<void()>& progress = {});

}  // namespace porowave::verification
