#pragma once

// For sources of this room only: whoever includes it needs nlohmann_json.

#include <cmath>
#include <nlohmann/json.hpp>

#include "verification/norms.hpp"

namespace porowave::verification {

using Json = nlohmann::ordered_json;

/// A number that is not finite becomes null.
inline Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

inline Json norms_json(const Norms& norms) {
  return {{"l1", number(norms.l1)}, {"l2", number(norms.l2)}, {"linf", number(norms.linf)}};
}

}  // namespace porowave::verification
