#pragma once

#include <array>

#include "reference/modes.hpp"

namespace porowave::reference {

/// The speeds and scales of a material that wave and consolidation problems are judged by.
struct WaveScales {
  double p1;  ///< frozen speed of the fast wave (no drag, or high frequency), m/s
  double p2;  ///< frozen speed of the slow wave, m/s
  /// sqrt((E + K)/rho), K = K_f/n_f: both phases move together (low frequency), m/s
  double undrained;
  /// sqrt(E/rho): the skeleton alone is stiff but carries the mass rho of the mixture, as in a
  /// one-phase analysis with drained stiffness, m/s
  double drained;
  /// sqrt(E/(n_s rho_s)): the skeleton without its fluid, m/s
  double dry_skeleton;
  /// c_v = kappa/mu E K/(E + K), m^2/s. With rho v' = 0 the governing equations leave
  /// dp/dt = K/(E + K) dq/dt + c_v p''. (Soil mechanics often has K -> infinity: c_v = E kappa/mu.)
  double consolidation;
  /// Rate at which drag levels the two velocities, 1/s.
  double relaxation_rate;
  /// relaxation_rate/(2 pi), Hz: drag governs below, inertia above. Biot's own characteristic
  /// frequency n_f mu/(2 pi rho_f kappa) is n_s rho_s/rho of it: there the solid does not move.
  double characteristic_frequency;
};

/// Valid for every material that read_material accepts.
WaveScales wave_scales(const Material& material);
/// Velocity that a jump of stress makes at most with the slow wave, over that with the undrained
/// one.
double slow_wave_factor(const Material& material);

/// A harmonic wave v ~ e^(i omega t - lambda x), x along its way, lambda = alpha + i
/// omega/velocity.
struct Dispersion {
  double phase_velocity;  ///< m/s
  double attenuation;     ///< alpha, Np/m (times 8.686: dB/m)
  /// Im M/Re M of the modulus M ~ (omega/lambda)^2, twice the damping ratio: near 0 for a wave,
  /// beyond 1 for diffusion. For small attenuation it is 2 attenuation velocity/omega.
  double inverse_q;
};

/// Both modes at a frequency in Hz; index 0 is P1, index 1 is P2, named by their frozen limits and
/// continuous in frequency. Throws InputError unless the frequency is finite and > 0.
///
/// Nothing cancels at either end of the frequencies: with V = R e and lambda^2/s = s/c_k^2 + nu_k
/// an eigenvalue of s diag(1/c^2) + h h^T (modes.hpp), Rayleigh's quotient on s = i omega gives
///   Re (lambda/s)^2 = (|e_1|^2/c_1^2 + |e_2|^2/c_2^2)/|e|^2,   Re nu_k = |h . e|^2/|e|^2,
/// the latter, the power lost to drag, is never negative, and h . e_k = nu_k/h_k by the rows of the
/// eigenvalue problem. So phase velocities never exceed c_1 and attenuations are >= 0.
std::array<Dispersion, 2> dispersion(const WaveModes& modes, double frequency);

/// The mode (0 or 1) that becomes the undrained wave at low frequency; the other one diffuses with
/// c_v. It is P1 unless P1's two phases move against each other more than P2's, as in a stiff
/// skeleton of high porosity; then P1 is the one that diffuses.
int undrained_mode(const WaveModes& modes);

}  // namespace porowave::reference
