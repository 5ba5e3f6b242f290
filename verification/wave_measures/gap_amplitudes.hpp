#pragma once

#include "solver/case.hpp"
#include "verification/wave_measures/mode_amplitudes.hpp"

namespace porowave::verification {

/// What an empty element makes of the fast wave, as shares of the velocity that arrives. A medium
/// without a gap (an empty element is one to the solver alone) has 0 and 1; a crack 1 and 0; a
/// rigid obstacle would reflect -1.
struct GapAmplitudes {
  double reflected = 0.0;
  double transmitted = 1.0;
};

/// With the amplitudes of mode_amplitudes.hpp, w for the fast wave: transmitted is the factor a of
/// the least squares of w_up - a w_up,reference behind the last empty element, reflected that of
/// (w_down - w_down,reference) - r m before the first one, where m(x) is the reference's w_up as
/// far behind the load side of the gap as x is before it: what a mirror there sends back. Least
/// squares over all the wave, not a largest value: ringing of short waves is nearly orthogonal to
/// the wave and hardly counts. A shift by d takes off a share of (d/length of the rise)^2.
///
/// NaN without empty elements; until the rise has passed them all; as soon as a wave comes back to
/// them, from the far end to the last or, reflected, from x = 0 to the first one. The slow wave,
/// into which a gap may convert a part, is not counted: squares need not add up to 1.
GapAmplitudes gap_amplitudes(const solver::Case& scene, const solver::Snapshot& snapshot,
                             const ReferenceValues& reference);

}  // namespace porowave::verification
