#pragma once

#include <functional>

#include "verification/faults/fault.hpp"
#include "verification/order/order_estimate.hpp"

namespace porowave::verification::faults {

using OrderFunction = std::function<OrderEstimate(const ErrorTable&)>;

/// What every estimator of an observed order must find, each with a name; the first that it does
/// not.
Catch caught_by_order_facts(const OrderFunction& order_of);

}  // namespace porowave::verification::faults
