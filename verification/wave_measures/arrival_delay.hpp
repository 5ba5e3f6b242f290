#pragma once

#include <array>

#include "reference/profile.hpp"
#include "verification/wave_measures/mode_amplitudes.hpp"

namespace porowave::verification {

/// Time in which a load rises to its largest |q|, s: 0 for step and block, T for smooth_ramp, T/2
/// for the pulses; from the table otherwise.
double rise_time(const Load& load);

/// By how much the first front of the fast (index 0) and of the slow wave (1) is late, s: its place
/// in the reference less its place in the solution, over its speed. Negative: early.
///
/// The front is that of the wave's own amplitude (mode_amplitudes.hpp), for in the four fields the
/// slow wave stands on the plateau of the fast one. Its place is where the amplitude, coming from
/// ahead, first reaches the middle between the reference's values ahead of the wave and behind its
/// rise:
///   - coming from ahead, ringing (behind the front) is met only after the front has been found,
///     and what a step does to the plateau does not matter, as it would for areas or correlations;
///   - one level for both says when a threshold is reached, and needs no derivative of noisy data;
///   - areas between the profiles are blind here: schemes that conserve momentum keep them.
/// Between two cell middles it is not the values that are interpolated but their distance from the
/// place where the reference has the same value: a reference that is shifted gives its shift, to
/// rounding. Where the reference jumps within a cell, a jump in the solution gives the middle
/// between its cells (up to half a cell off). A smeared step reaches its middle late by the order
/// h^(2/3): that is an error of arrival, as the profile tells it. Tables must rise monotonically.
///
/// The speed is the frozen one. Where drag has halved the fast front and the fast wave is the one
/// that becomes the undrained wave, its rise is looked for, and runs, at the undrained speed.
///
/// NaN where there is no such front:
///   - the rise has not entered the column by two cells, or has come to within a cell of its end;
///   - drag has left less than 5 % of the largest amplitude at the front (slow wave);
///   - the solution does not pass the level within 4 (x h^2)^(1/3) of the reference's rise (eight
///     cells at least), several times what dispersion does to a step that has run for x: it was
///     reflected at an empty element, say; or a value there is not finite.
std::array<double, 2> arrival_delays(const Problem& problem, const reference::Profile& profile,
                                     const solver::Snapshot& snapshot,
                                     const ReferenceValues& reference);

}  // namespace porowave::verification
