#pragma once

#include "reference/modes.hpp"
#include "reference/problem/problem.hpp"

namespace porowave::reference {

/// Amplitudes of the two modes, and the matrix that turns arriving into leaving amplitudes.
using Amplitudes = std::array<Complex, 2>;
using Reflection = std::array<Amplitudes, 2>;

/// What the two ends of the column do to the modes, at one s. A wave of mode k travelling to
/// larger x with amplitude alpha has velocity R e_k alpha and tractions -(lambda_k/s) A R e_k
/// alpha; travelling back, the same with + in the tractions.
struct EndResponse {
  Amplitudes source;   ///< leaving the near end, per unit of the transformed load
  Reflection at_near;  ///< arriving at x = 0 -> leaving it
  Reflection at_far;   ///< arriving at x = length -> leaving it
};

EndResponse end_response(const Problem& problem, const WaveModes& modes, const ModeState& state);

/// True if the end turns one mode into the other.
constexpr bool converts(NearEnd end) {
  return end == NearEnd::sealed_traction;
}
constexpr bool converts(FarEnd end) {
  return end == FarEnd::rigid_drained;
}

/// The four fields of unit amplitude of each mode, travelling up (to larger x) or down.
/// Order of fields: effective stress, pore pressure, solid velocity, fluid velocity.
using FieldVector = std::array<Complex, 4>;
struct ModeFields {
  std::array<FieldVector, 2> up;
  std::array<FieldVector, 2> down;
};
ModeFields mode_fields(const Material& material, const WaveModes& modes, const ModeState& state);

}  // namespace porowave::reference
