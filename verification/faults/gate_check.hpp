#pragma once

#include <functional>

#include "verification/faults/fault.hpp"
#include "verification/gate/gate.hpp"

namespace porowave::verification::faults {

using JudgeFunction = std::function<std::vector<Verdict>(
    const std::vector<Group>&, const GateRules&, const std::optional<Baseline>&)>;

/// Stores with a known truth and the verdict that each must have; the first that is judged
/// otherwise.
Catch caught_by_gate_facts(const JudgeFunction& judge);

}  // namespace porowave::verification::faults
