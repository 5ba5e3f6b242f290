#pragma once

#include <limits>
#include <numbers>

namespace porowave::reference {

inline constexpr double pi = std::numbers::pi;

/// The distance of 1 from the next double.
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

}  // namespace porowave::reference
