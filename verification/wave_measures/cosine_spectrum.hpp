#pragma once

#include <span>
#include <vector>

namespace porowave::verification {

/// Where n or n + 1 values of a grid of n equal cells stand.
enum class Places { cell_middles, nodes };

/// Energy of values in the cosines cos(pi k x/L) of a column of length L, k = 0, 1, ...; wavelength
/// 2 L/k, that is 2 n/k cells. They add up to the sum of the squared values (at nodes: with half
/// weight at the two ends), to rounding (Parseval).
///
/// Cosines are the Fourier series of the values mirrored at both ends. The mirrored values are
/// continuous and periodic, so there is no window and no leakage from a jump between the ends; a
/// slope there leaves a share of the order k^-4. Made by FFTW's DCT-II (cell middles) and DCT-I
/// (nodes). Plans are made once for each number of values and kept; several threads may call.
///
/// Throws std::invalid_argument for less than one cell, std::bad_alloc without memory for a plan.
/// Source: Strang, The Discrete Cosine Transform, SIAM Review 41 (1999) 135-147.
std::vector<double> cosine_spectrum(std::span<const double> values, Places places);

}  // namespace porowave::verification
