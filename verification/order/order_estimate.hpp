#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "verification/order/convergence_fit.hpp"

namespace porowave::verification {

/// Whether an order can be told from a table of errors, and if not, why.
enum class OrderStatus {
  observed,
  too_few_levels,  ///< fewer than three
  not_finite,      ///< an error is missing, not finite or not positive
  not_asymptotic,  ///< no range of at least three levels follows one order
  at_floor,        ///< the finest errors are mostly a floor that refinement does not lower
};
inline constexpr std::array<std::string_view, 5> order_status_names = {
    "observed", "too_few_levels", "not_finite", "not_asymptotic", "at_floor"};

struct OrderEstimate {
  OrderStatus status = OrderStatus::observed;
  double order = 0.0;  ///< NaN unless observed or at_floor
  double low = 0.0;    ///< interval that holds the order with the confidence asked for
  double high = 0.0;
  double floor = 0.0;           ///< error that refinement does not lower, 0 if none is seen
  std::size_t first_level = 0;  ///< of the asymptotic range, which ends at the finest level
  std::vector<double> pairwise;
};

struct OrderOptions {
  double confidence = 0.95;
  /// Largest difference of a pairwise order from the fit's within the asymptotic range, beyond what
  /// the noise of the replicates explains.
  double spread = 0.15;
  int resamples = 1000;
  std::uint64_t seed = 1;
};

/// The observed order of a quantity: the longest range of levels up to the finest in which one
/// order (and one floor) explains all pairs; fitted; its interval by bootstrap over replicates.
///
/// With several replicates the interval is Student's with the bootstrap's standard error (Efron &
/// Tibshirani 1993, ch. 12; percentiles of few replicates are too narrow). With one there is no
/// noise to resample: the interval is the range of the pairwise orders less that of the floor.
/// Throws std::invalid_argument for a table that is not well formed.
OrderEstimate estimate_order(const ErrorTable& table, const OrderOptions& options = {});

}  // namespace porowave::verification
