#pragma once

// Why a run has broken down, as far as evidence goes. Looked for only after a breakdown: what the
// scene carries is stepped by its step operator (stability/), at the step of the run, at shorter
// steps, and with other choices. Nothing is claimed that one of these did not show.
//
//   long_step        fields grow enough at this step to explain the breakdown; at a shorter one,
//                    which is named, they do not
//   unstable_points  they grow at this step and at every shorter one; named is the first of some
//                    other choices of the method with which they do not, if there is one
//   moved_points     where points started the step is stable, but they have moved by more than
//                    `far_moved` elements, under a load that moves its end by more than
//                    `far_at_rest` at rest: strains are not small, or the loaded end has left its
//                    node
//   none             neither of them, or the scene has more than `most_elements` elements
//
// "Enough" is a factor of 1e4 over the steps done. "Stable" is less than tenfold over the run, or
// where that would take seconds to tell, less than 1.4e-6 per element and step.

#include <string>

#include "solver/case.hpp"
#include "solver/column_solver.hpp"

namespace porowave::solver {

enum class CauseKind { none, long_step, unstable_points, moved_points };

inline constexpr int most_elements_analysed = 1000;
inline constexpr double far_moved = 0.5;     // elements
inline constexpr double far_at_rest = 0.25;  // elements; load/E_oed times the length of the column

// What is known of the run.
struct BrokenRun {
  long steps = 0;          // done; > 0
  double time_step = 0.0;  // s
  double moved = 0.0;      // how far a point has moved at most, m
};

struct BreakdownCause {
  CauseKind kind = CauseKind::none;
  double growth = 0.0;   // a step, at the step of the run; 0 if that was not analysed
  double x = 0.0;        // m, where what grows is largest; for long_step and unstable_points
  double courant = 0.0;  // for long_step: a stable one
  std::string text;      // what was found, and at its end what to change
};

// Takes up to some seconds, for scenes of 100 elements tenths of one. Throws nothing that the
// analysis throws: then no cause is claimed.
BreakdownCause breakdown_cause(const Case& scene, const BrokenRun& run);

// The reason of a breakdown of the scene, with its cause as far as evidence goes.
std::string reason_and_cause(const Case& scene, const Breakdown& breakdown);

}  // namespace porowave::solver
