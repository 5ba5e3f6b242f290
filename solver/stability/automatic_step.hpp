#pragma once

// The time step of a case that leaves it to the program (courant = "auto"): a share of the critical
// step of this scene, or a reason why it has none.
//
// Unstable is what multiplies noise by more than `tolerated_growth` in the run: a long run needs a
// steadier step than a short one. Analysed (step_operator.hpp, all eigenvalues) are
//
//   up to 48 elements     the scene itself: StepRule::critical_step
//   more, mls and staggered4
//                         a window of 48 elements, of the same size: those next to x = 0 and what
//                         follows, with the far end behind them; points of the same placement and
//                         seed, but for placement = "random" the very points of the scene; the gaps
//                         of these elements, or the first gap of the column, moved into its middle.
//                         StepRule::window. What irregular points do elsewhere is not seen, so the
//                         estimate of time_step.hpp is not exceeded with them
//   more, shape and apic, and supports of more than 12 elements
//                         nothing: the estimate of time_step.hpp, proven for linear functions of
//                         shape. StepRule::formula
//
// Regular points next to empty elements must be stable a little moved as well, in eight ways.
// So its cost does not grow with the column: README.md has it.

#include <stdexcept>

#include "solver/case.hpp"

namespace porowave::solver {

inline constexpr double share_of_critical = 0.9;
inline constexpr double tolerated_growth = 10.0;  // of noise in a run
inline constexpr int most_analysed_elements = 48;

// The message reads on from "expected": where noise grows, how fast, and what would help.
struct NoStableStep : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// 0.9 of the critical Courant number, or less where that is less stable; of shape and apic at least
// the estimate of time_step.hpp. Its courant is > 0 and <= 0.9. Depends on the run by time.end
// only. Throws NoStableStep, and BreakdownError where the solver would.
AutomaticStep automatic_step(const Case& scene);

// automatic_step(scene).courant.
double automatic_courant(const Case& scene);

}  // namespace porowave::solver
