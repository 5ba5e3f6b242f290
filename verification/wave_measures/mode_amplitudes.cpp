#include "verification/wave_measures/mode_amplitudes.hpp"

namespace porowave::verification {

ModeAmplitudes::ModeAmplitudes(const Material& m) {
  const reference::WaveModes modes(m);
  const auto& r = modes.velocity_of_mode();
  for (std::size_t k = 0; k < 2; ++k) {
    speed_[k] = modes.speed(static_cast<int>(k));
    weights_[k].solid_velocity = 0.5 * speed_[k] * r[0][k] * m.solid_partial_density();
    weights_[k].fluid_velocity = 0.5 * speed_[k] * r[1][k] * m.fluid_partial_density();
    weights_[k].effective_stress = -0.5 * r[0][k];
    weights_[k].pore_pressure = 0.5 * modes.outflow_of_mode()[k];
  }
}

ModeAmplitudes::Pair ModeAmplitudes::at(int mode, const Fields& f) const {
  const Weights& w = weights_[static_cast<std::size_t>(mode)];
  const double y = w.solid_velocity * f.solid_velocity + w.fluid_velocity * f.fluid_velocity;
  const double z = w.effective_stress * f.effective_stress + w.pore_pressure * f.pore_pressure;
  return {y + z, y - z};
}

ModeAmplitudes::Profiles ModeAmplitudes::of(int mode, const GridFields& fields) const {
  const auto& [effective_stress, pore_pressure, solid_velocity, fluid_velocity] = fields;
  Profiles profiles;
  profiles.up.resize(effective_stress.size());
  profiles.down.resize(effective_stress.size());
  for (std::size_t c = 0; c < effective_stress.size(); ++c) {
    const auto [up, down] = at(mode, {effective_stress[c], pore_pressure[c],
                                      0.5 * (solid_velocity[c] + solid_velocity[c + 1]),
                                      0.5 * (fluid_velocity[c] + fluid_velocity[c + 1])});
    profiles.up[c] = up;
    profiles.down[c] = down;
  }
  return profiles;
}

}  // namespace porowave::verification
