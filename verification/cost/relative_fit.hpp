#pragma once

#include <span>
#include <vector>

namespace porowave::verification {

/// One measurement and what it is to be a sum of.
struct Measurement {
  std::vector<double> terms;  ///< >= 0, as many in all measurements
  double value;               ///< > 0
};

/// Constants c >= 0, one a term, for which the sum over all measurements of
/// (terms . c / value - 1)^2 is least: relative errors count, so that short cases have a say as
/// long ones have. A term that is zero everywhere gets 0. By coordinate descent, which is right for
/// the half dozen terms here. Empty without measurements.
std::vector<double> relative_fit(std::span<const Measurement> measurements);

}  // namespace porowave::verification
