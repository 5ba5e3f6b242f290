#include "reference/modes.hpp"

#include <cmath>

namespace porowave::reference {

WaveModes::WaveModes(const Material& m)
    : undrained_speed_(m.undrained_speed()), relaxation_rate_(m.relaxation_rate()) {
  const WaveSpeeds speeds = wave_speeds(m);
  speed_ = {speeds.p1, speeds.p2};

  // D^(-1/2) A D^(-1/2) = W diag(c^2) W^T with W a rotation; R = D^(-1/2) W diag(1/c).
  const double ns = m.solid_fraction();
  const double nf = m.porosity;
  const double K = m.storage_modulus();
  const std::array<double, 2> root_density = {std::sqrt(m.solid_partial_density()),
                                              std::sqrt(m.fluid_partial_density())};
  const double p11 = (m.constrained_modulus + K * ns * ns) / m.solid_partial_density();
  const double p12 = K * ns * nf / (root_density[0] * root_density[1]);
  const double p22 = K * nf * nf / m.fluid_partial_density();
  const double angle = 0.5 * std::atan2(2.0 * p12, p11 - p22);
  const Matrix2 rotation = {
      {{std::cos(angle), -std::sin(angle)}, {std::sin(angle), std::cos(angle)}}};
  for (std::size_t phase = 0; phase < 2; ++phase) {
    for (std::size_t k = 0; k < 2; ++k) {
      velocity_of_mode_[phase][k] = rotation[phase][k] / (root_density[phase] * speed_[k]);
      traction_of_mode_[phase][k] = rotation[phase][k] * root_density[phase] * speed_[k];
    }
  }
  for (std::size_t k = 0; k < 2; ++k) {
    drag_[k] = std::sqrt(m.drag()) * (velocity_of_mode_[0][k] - velocity_of_mode_[1][k]);
  }
  slowness_gap_ = (speed_[0] - speed_[1]) * (speed_[0] + speed_[1]) /
                  (speed_[0] * speed_[0] * speed_[1] * speed_[1]);
  branch_point_ = {(drag_[0] - drag_[1]) * (drag_[0] + drag_[1]) / slowness_gap_,
                   2.0 * std::abs(drag_[0] * drag_[1]) / slowness_gap_};
}

ModeState WaveModes::at(Complex s, Cut cut) const {
  // The eigenvalues of s diag(1/c^2) + h h^T are s/c_k^2 + nu_k. nu_1 and nu_2 are roots of two
  // quadratics with the same discriminant root^2.
  const double h1 = drag_[0];
  const double h2 = drag_[1];
  const double trace = h1 * h1 + h2 * h2;
  const Complex gap = s * slowness_gap_;
  const Complex from_centre = s - branch_point_.real();
  const Complex to_branch(0.0, branch_point_.imag());
  const Complex ratio = branch_point_.imag() / from_centre;
  const Complex root =
      slowness_gap_ * (cut == Cut::between
                           ? from_centre * std::sqrt(1.0 + ratio * ratio)
                           : std::sqrt((from_centre - to_branch) * (from_centre + to_branch)));

  // Of the two forms of each root, the one that does not subtract nearly equal numbers.
  const auto stable_root = [](Complex half_sum, Complex half_difference, Complex product) {
    return std::norm(half_sum) > std::norm(half_difference) ? product / half_sum : half_difference;
  };
  const Complex sum = 0.5 * (trace + gap + root);
  const Complex difference = 0.5 * (trace + gap - root);
  const std::array<Complex, 2> nu = {
      stable_root(sum, difference, gap * h1 * h1),
      stable_root(0.5 * (root + gap - trace), 0.5 * (root - gap + trace), gap * h2 * h2)};

  ModeState state;
  for (std::size_t k = 0; k < 2; ++k) {
    const double c = speed_[k];
    const Complex stretch = std::sqrt(1.0 + nu[k] * (c * c) / s);  // principal: never < 0 off cut
    state.slowness[k] = stretch / c;
    state.excess[k] = c * nu[k] / (1.0 + stretch);
  }
  state.mixing = 2.0 * h1 * h2 / (gap + h2 * h2 - h1 * h1 + root);
  return state;
}

ModeState WaveModes::frozen() const {
  ModeState state;
  for (std::size_t k = 0; k < 2; ++k) {
    state.slowness[k] = 1.0 / speed_[k];
    state.excess[k] = 0.5 * speed_[k] * drag_[k] * drag_[k];
  }
  state.mixing = 0.0;
  return state;
}

}  // namespace porowave::reference
