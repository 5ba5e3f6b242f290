#pragma once

#include <span>

#include "verification/wave_measures/cosine_spectrum.hpp"

namespace porowave::verification {

/// The part of a field's error in wavelengths shorter than four cells: no grid resolves them, so
/// what stands there is ringing, noise of the points, or a front sharper than the grid.
struct Ringing {
  /// Its L2 norm divided by that of the reference: the square of the field's relative L2 error
  /// (norms.hpp) is this one squared plus that of the longer waves.
  double amplitude = 0.0;
  /// Its share of the error's energy, 0 to 1. An error that jumps has some by itself: a step in the
  /// error at a front, sampled on a grid, has energy in all waves.
  double share = 0.0;
};

/// Values and reference at the places; spans of equal length, std::invalid_argument otherwise.
/// Amplitude as relative_norms: NaN for values that are not finite, and where the reference is zero
/// but the short waves are not. The share of an error that is zero is 0.
Ringing ringing(std::span<const double> values, std::span<const double> reference, Places places);

}  // namespace porowave::verification
