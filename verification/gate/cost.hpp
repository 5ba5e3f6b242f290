#pragma once

#include <optional>
#include <string_view>

#include "verification/gate/baseline.hpp"
#include "verification/gate/observation.hpp"

namespace porowave::verification {

/// Name under which costs stand in a baseline and among verdicts.
inline constexpr std::string_view cost_name = "relative_cost";

/// Mean and scatter of the logarithm of Record::relative_cost over the cases of the finest level;
/// none if a case lacks it. Measured costs scatter, and some measurements are far too large: the
/// larger half of them is left out.
std::optional<Expected> expected_cost(const Group& group);

}  // namespace porowave::verification
