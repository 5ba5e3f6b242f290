#pragma once

#include <functional>
#include <span>

#include "verification/faults/fault.hpp"
#include "verification/norms.hpp"

namespace porowave::verification::faults {

using NormFunction =
    std::function<Norms(std::span<const double> values, std::span<const double> reference,
                        std::span<const double> weights)>;

/// What every relative norm must fulfil, each with a name; the first that does not hold.
Catch caught_by_norm_facts(const NormFunction& norms);

}  // namespace porowave::verification::faults
