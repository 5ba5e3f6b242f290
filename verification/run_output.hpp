#pragma once

#include <ostream>
#include <string>

#include "verification/run.hpp"

namespace porowave::verification {

/// The points of a snapshot as CSV: phase,x,volume,velocity,effective_stress,pore_pressure; one row
/// a point, the field that a phase has not is empty; 17 digits, all at the snapshot's time.
void write_points_csv(const solver::Snapshot& snapshot, std::ostream& out);

/// {"errors": {field: {"points": {"l1","l2","linf"}, "field": {...}}},
///  "measures": {"arrival_delay": {"fast","slow"},
///               field: {"overshoot","total_variation","ringing","ringing_share"},
///               "gap": {"reflected","transmitted"}, "energy_drift": {"points","field"}},
///  "path", "steps", ...};
/// "time_step" and "arrival_delay" in s, "courant" is c_1 Δt/h; measures: wave_measures.hpp.
/// A number that is not finite, or not defined, becomes null. After a breakdown "diverged" is true,
/// "reason" says where, and "errors" and "measures" are null.
std::string run_json(const RunResult& result);

/// The four fields' L2 errors and the cost in a few lines, for people.
std::string run_summary(const RunResult& result);

}  // namespace porowave::verification
