#include "reference/waves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/problem/errors.hpp"

namespace porowave::reference {

WaveScales wave_scales(const Material& m) {
  const double E = m.constrained_modulus;
  const double K = m.storage_modulus();
  const WaveSpeeds frozen = wave_speeds(m);
  const double series_modulus = 1.0 / (1.0 / E + 1.0 / K);
  WaveScales scales{};
  scales.p1 = frozen.p1;
  scales.p2 = frozen.p2;
  scales.undrained = m.undrained_speed();
  scales.drained = std::sqrt(E / m.mixture_density());
  scales.dry_skeleton = std::sqrt(E / m.solid_partial_density());
  scales.consolidation = m.intrinsic_permeability / m.fluid_viscosity * series_modulus;
  scales.relaxation_rate = m.relaxation_rate();
  scales.characteristic_frequency = m.relaxation_rate() / (2.0 * std::numbers::pi);
  return scales;
}

double slow_wave_factor(const Material& m) {
  return m.mixture_density() * m.undrained_speed() /
         (std::min(m.solid_partial_density(), m.fluid_partial_density()) * wave_speeds(m).p2);
}

std::array<Dispersion, 2> dispersion(const WaveModes& modes, double frequency) {
  if (!(frequency > 0.0) || !std::isfinite(frequency)) {
    throw InputError(fmt::format("frequency = {}: expected a finite number > 0", frequency));
  }
  const double omega = 2.0 * std::numbers::pi * frequency;
  const ModeState state = modes.at({0.0, omega});
  const ModeState frozen = modes.frozen();
  const double epsilon_squared = std::norm(state.mixing);
  std::array<Dispersion, 2> result;
  for (std::size_t k = 0; k < 2; ++k) {
    const double c = modes.speed(static_cast<int>(k));
    const double other = modes.speed(static_cast<int>(1 - k));
    const Complex nu = state.excess[k] * (1.0 + c * state.slowness[k]) / c;
    const double drag_squared = 2.0 * frozen.excess[k].real() / c;  // h_k^2
    const double e_squared = 1.0 + epsilon_squared;
    // A mode without relative velocity (h_k = 0) is not damped.
    const double loss = drag_squared > 0.0 ? std::norm(nu) / (drag_squared * e_squared) : 0.0;
    // (lambda/s)^2 = in_phase - i out_of_phase, its root = slowness - i attenuation/omega.
    const double in_phase = (1.0 / (c * c) + epsilon_squared / (other * other)) / e_squared;
    const double out_of_phase = loss / omega;
    const double slowness = std::sqrt(0.5 * (in_phase + std::hypot(in_phase, out_of_phase)));
    result[k] = {1.0 / slowness, 0.5 * loss / slowness, out_of_phase / in_phase};
  }
  return result;
}

int undrained_mode(const WaveModes& modes) {
  // Going down the imaginary axis, the frozen modes keep their order unless the pair of branch
  // points, where they meet, lies to the right of it.
  return modes.branch_point().real() > 0.0 ? 1 : 0;
}

}  // namespace porowave::reference
