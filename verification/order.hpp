#pragma once

#include <span>

namespace porowave::verification {

/// The error of one level of a refinement.
struct LevelError {
  double element_length;  ///< m, > 0
  double error;           ///< > 0, in whatever norm
};

/// Order of accuracy observed between two levels, ln(e1/e2) / ln(h1/h2): positive where the error
/// falls with h, negative where it grows; any ratio of lengths. NaN for an error that is not a
/// finite number > 0. Throws std::invalid_argument unless both lengths are > 0 and different.
double observed_order(const LevelError& coarse, const LevelError& fine);

/// The same over many levels: slope of the straight line that fits ln e over ln h best in the sense
/// of least squares. NaN for an error that is not a finite number > 0. Throws std::invalid_argument
/// for fewer than two levels, a length <= 0, or lengths that are all the same.
/// Source: Roache, Fundamentals of Verification and Validation (2009), chapter 5.
double fitted_order(std::span<const LevelError> levels);

}  // namespace porowave::verification
