#include "reference/boundary.hpp"

namespace porowave::reference {

namespace {

using Vector2 = std::array<double, 2>;

/// matrix * [e_1 e_2], with e_1 = (1, -eps), e_2 = (eps, 1).
std::array<std::array<Complex, 2>, 2> in_modes(const Matrix2& matrix, Complex eps) {
  std::array<std::array<Complex, 2>, 2> result;
  for (std::size_t row = 0; row < 2; ++row) {
    result[row][0] = matrix[row][0] - eps * matrix[row][1];
    result[row][1] = eps * matrix[row][0] + matrix[row][1];
  }
  return result;
}

/// [e_1 e_2]^-1 of a vector given by its parts along the frozen modes.
Amplitudes project(const Vector2& along, Complex eps) {
  const Complex determinant = 1.0 + eps * eps;
  return {(along[0] - eps * along[1]) / determinant, (eps * along[0] + along[1]) / determinant};
}

Reflection multiple_of_identity(double factor) {
  return {{{Complex(factor), Complex(0.0)}, {Complex(0.0), Complex(factor)}}};
}

/// An end where the traction combination u . T and the velocity combination w . V are prescribed.
/// `sign` is -1 at the near end, where leaving waves travel up, and +1 at the far end.
struct MixedEnd {
  Amplitudes traction;  ///< u^T A R [e_1 e_2] diag(lambda/s)
  Amplitudes velocity;  ///< w^T R [e_1 e_2]

  MixedEnd(const WaveModes& modes, const ModeState& state, const Vector2& u, const Vector2& w) {
    const auto tractions = in_modes(modes.traction_of_mode(), state.mixing);
    const auto velocities = in_modes(modes.velocity_of_mode(), state.mixing);
    for (std::size_t k = 0; k < 2; ++k) {
      traction[k] = (u[0] * tractions[0][k] + u[1] * tractions[1][k]) * state.slowness[k];
      velocity[k] = w[0] * velocities[0][k] + w[1] * velocities[1][k];
    }
  }

  /// Solves traction . a = first, velocity . a = second.
  Amplitudes solve(Complex first, Complex second) const {
    const Complex determinant = traction[0] * velocity[1] - traction[1] * velocity[0];
    return {(first * velocity[1] - traction[1] * second) / determinant,
            (traction[0] * second - first * velocity[0]) / determinant};
  }

  /// traction . (leaving - arriving) = 0 and velocity . (leaving + arriving) = 0.
  Reflection reflection() const {
    const Amplitudes first = solve(traction[0], -velocity[0]);
    const Amplitudes second = solve(traction[1], -velocity[1]);
    return {{{first[0], second[0]}, {first[1], second[1]}}};
  }
};

constexpr Vector2 both = {1.0, 1.0};
constexpr Vector2 relative = {1.0, -1.0};
constexpr Vector2 solid = {1.0, 0.0};
constexpr Vector2 fluid = {0.0, 1.0};

/// Leaving waves for prescribed tractions, given by their work r_k . T on the frozen modes.
Amplitudes traction_source(const ModeState& state, const Vector2& work) {
  Amplitudes source = project(work, state.mixing);
  for (std::size_t k = 0; k < 2; ++k) source[k] /= -state.slowness[k];
  return source;
}

}  // namespace

EndResponse end_response(const Problem& problem, const WaveModes& modes, const ModeState& state) {
  EndResponse response{};
  switch (problem.column.near) {
    case NearEnd::drained_traction:
      response.source = traction_source(
          state, {-modes.velocity_of_mode()[0][0], -modes.velocity_of_mode()[0][1]});
      response.at_near = multiple_of_identity(1.0);
      break;
    case NearEnd::fluid_pressure:
      response.source =
          traction_source(state, {-modes.outflow_of_mode()[0], -modes.outflow_of_mode()[1]});
      response.at_near = multiple_of_identity(1.0);
      break;
    case NearEnd::velocity:
      response.source = project({modes.traction_of_mode()[0][0] + modes.traction_of_mode()[1][0],
                                 modes.traction_of_mode()[0][1] + modes.traction_of_mode()[1][1]},
                                state.mixing);
      response.at_near = multiple_of_identity(-1.0);
      break;
    case NearEnd::sealed_traction: {
      const MixedEnd piston(modes, state, both, relative);
      response.source = piston.solve(1.0, 0.0);  // -traction . a = -q
      response.at_near = piston.reflection();
      break;
    }
  }
  switch (problem.column.far) {
    case FarEnd::rigid_sealed:
      response.at_far = multiple_of_identity(-1.0);
      break;
    case FarEnd::free_drained:
      response.at_far = multiple_of_identity(1.0);
      break;
    case FarEnd::rigid_drained:
      response.at_far = MixedEnd(modes, state, fluid, solid).reflection();
      break;
    case FarEnd::half_space:
      response.at_far = multiple_of_identity(0.0);
      break;
  }
  return response;
}

ModeFields mode_fields(const Material& material, const WaveModes& modes, const ModeState& state) {
  const auto velocities = in_modes(modes.velocity_of_mode(), state.mixing);
  const auto tractions = in_modes(modes.traction_of_mode(), state.mixing);
  const double ns = material.solid_fraction();
  const double nf = material.porosity;
  ModeFields fields;
  for (std::size_t k = 0; k < 2; ++k) {
    const Complex pressure = tractions[1][k] * state.slowness[k] / -nf;
    const Complex stress = tractions[0][k] * state.slowness[k] + ns * pressure;
    fields.up[k] = {-stress, -pressure, velocities[0][k], velocities[1][k]};
    fields.down[k] = {stress, pressure, velocities[0][k], velocities[1][k]};
  }
  return fields;
}

}  // namespace porowave::reference
