#pragma once

#include <span>
#include <vector>

namespace porowave::reference {

/// sum_n a_n sin((n + 1/2) pi j/M) at j = 0 ... M, for any number of amplitudes a_0, a_1, ...:
/// those beyond M look on this grid like lower ones and are added to them. By FFTW (RODFT10).
std::vector<double> quarter_wave_sines(std::span<const double> amplitudes, std::size_t intervals);

/// The same with cosines (REDFT10); zero at j = M.
std::vector<double> quarter_wave_cosines(std::span<const double> amplitudes, std::size_t intervals);

}  // namespace porowave::reference
