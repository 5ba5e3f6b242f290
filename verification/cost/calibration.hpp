#pragma once

namespace porowave::verification {

/// Speed of this machine right now, as CPU nanoseconds of the calling thread for one point of a
/// fixed stencil (five points, 16 KiB, all in the first cache): the best of three measurements,
/// some 0.2 ms in all. Costs divided by it are comparable between machines of one kind and between
/// a busy and an idle one, as a share of the clock is taken off both. They are not comparable
/// between compilers, or processors with other vector units.
double calibration_nanoseconds();

/// The same, measured anew in a thread when its last measurement is older than half a second.
double recent_calibration_nanoseconds();

}  // namespace porowave::verification
