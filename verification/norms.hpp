#pragma once

#include <span>

namespace porowave::verification {

/// Error norms, each divided by the same norm of the reference (dimensionless):
/// l1 = sum w|e| / sum w|r|, l2 = sqrt(sum w e^2 / sum w r^2), linf = max|e| / max|r|.
/// All are NaN when a value is not finite, and when the reference is zero but the error is not;
/// zero when both are.
struct Norms {
  double l1 = 0.0;
  double l2 = 0.0;
  double linf = 0.0;
};

/// Spans of equal, positive length; weights >= 0 (volumes). Throws std::invalid_argument otherwise.
Norms relative_norms(std::span<const double> values, std::span<const double> reference,
                     std::span<const double> weights);

}  // namespace porowave::verification
