#pragma once

#include <vector>

#include "reference/modes.hpp"
#include "reference/problem/problem.hpp"

namespace porowave::reference {

/// A place where the fields jump, or where the first disturbance arrives.
struct Front {
  double x;        ///< m
  int mode;        ///< 0: P1, 1: P2, on the leg that it is running
  bool upwards;    ///< to larger x
  int crossings;   ///< of the whole column before this leg
  int slow;        ///< of these, how many as P2
  double started;  ///< s, when the load sent it off
  /// The load jumped at `started`. If not, this is the onset of a load that begins continuously.
  bool of_jump;
  /// Value just behind the front less the value just ahead of it: what it adds in passing. Zero for
  /// an onset. Pa, Pa, m/s, m/s.
  Fields jump;
};

/// Every front inside the column at time t: one for each jump of the load and each image (mode of
/// this leg, number of crossings made as P1 and as P2), ascending in x; and likewise the onset, if
/// the load begins without a jump. Kinks and later changes of the load are not listed.
///
/// Jumps are exact: frozen amplitudes times e^(-frozen excess . path) times the load's jump, for at
/// a front only s -> infinity counts. All orders in which a wave may have been P1 and P2 in its
/// crossings share one front and are summed; fronts that share a position otherwise (meeting there,
/// or arriving at an end and leaving it) are listed separately, and the jumps across that position
/// are those of the ones going up less those of the ones going down.
///
/// Throws InputError if t is not finite, or if there are more fronts than most_rays (rays.hpp) for
/// one jump. Source: physics of `README.md`, step 2; Achenbach, Wave Propagation in Elastic Solids
/// (1973), section 4.4 (jumps at wavefronts).
std::vector<Front> fronts_at(const Problem& problem, const WaveModes& modes, double t);

}  // namespace porowave::reference
