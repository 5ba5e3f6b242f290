#pragma once

#include "reference/integrand.hpp"
#include "reference/node_table.hpp"

namespace porowave::reference {

struct Inverted {
  FourSums value{};
  FourSums error{};    ///< bounds; infinity where the sum could not be resolved
  double worst = 0.0;  ///< largest bound over what a full wave under the load has
};

/// Trapezoidal rule on the hyperbola of `table` with nested doubling of the nodes, until two sums
/// agree to their rounding.
///
/// The bound counts the rounding of every term, amplified by the size of its exponent; the rounding
/// of the times of arrival, by the rate at which the values change; and the last change under
/// doubling. `uncertainty` is the rounding of the times, s.
Inverted invert(Integrand& integrand, NodeTable& table, double uncertainty);

}  // namespace porowave::reference
