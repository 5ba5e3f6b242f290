#pragma once

#include <limits>

namespace porowave::verification {

/// What a measure is that does not exist.
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace porowave::verification
