#pragma once

#include <span>

namespace porowave::verification {

/// What a field has beyond the reference's, at the same places; dimensionless.
struct Overshoot {
  /// Largest excess over the reference's largest or under its smallest value, divided by the
  /// difference of these two. 0 if there is none.
  double excess = 0.0;
  /// Total variation, sum |f_i+1 - f_i|, divided by the reference's. 1 for the reference; more
  /// where the field rings, less where fronts are cut off. A front within the column costs its
  /// height once, so a smeared step has total variation 1 and so has a shifted one.
  double total_variation = 1.0;
};

/// Spans of equal length, at least one value, in the order of x; std::invalid_argument otherwise.
/// Where the reference is the same everywhere: excess 0 and variation 1 if the field is just that,
/// NaN otherwise. NaN also for values that are not finite.
Overshoot overshoot(std::span<const double> values, std::span<const double> reference);

}  // namespace porowave::verification
