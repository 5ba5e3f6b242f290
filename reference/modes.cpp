#include "reference/modes.hpp"

#include <cmath>

namespace porowave::reference {

namespace {

/// The constants of a material enter every value as a factor: they are computed with more digits
/// than they are stored with, so that each is off by half a unit only.
using Wide = long double;

struct WideMaterial {
  explicit WideMaterial(const Material& m)
      : nf(m.porosity),
        ns(1.0L - nf),
        ms(ns * m.grain_density),
        mf(nf * m.fluid_density),
        E(m.constrained_modulus),
        K(m.fluid_bulk_modulus / nf),
        drag(nf * nf * m.fluid_viscosity / m.intrinsic_permeability) {}
  Wide nf, ns, ms, mf, E, K, drag;
};

}  // namespace

WaveModes::WaveModes(const Material& material) {
  const WideMaterial m(material);
  undrained_speed_ = static_cast<double>(std::sqrt((m.E + m.K) / (m.ms + m.mf)));
  relaxation_rate_ = static_cast<double>(m.drag * (1.0L / m.ms + 1.0L / m.mf));

  // D^(-1/2) A D^(-1/2) = W diag(c^2) W^T with W a rotation; R = D^(-1/2) W diag(1/c). The smaller
  // eigenvalue from the product of both, so that nothing cancels.
  const std::array<Wide, 2> root_density = {std::sqrt(m.ms), std::sqrt(m.mf)};
  const Wide p11 = (m.E + m.K * m.ns * m.ns) / m.ms;
  const Wide p12 = m.K * m.ns * m.nf / (root_density[0] * root_density[1]);
  const Wide p22 = m.K * m.nf * m.nf / m.mf;
  const Wide fast = 0.5L * (p11 + p22 + std::hypot(p11 - p22, 2.0L * p12));
  const Wide slow = m.E * m.K * m.nf * m.nf / (m.ms * m.mf) / fast;
  const std::array<Wide, 2> c = {std::sqrt(fast), std::sqrt(slow)};
  const Wide angle = 0.5L * std::atan2(2.0L * p12, p11 - p22);
  const std::array<std::array<Wide, 2>, 2> rotation = {
      {{std::cos(angle), -std::sin(angle)}, {std::sin(angle), std::cos(angle)}}};
  std::array<Wide, 2> h;
  for (std::size_t k = 0; k < 2; ++k) {
    speed_[k] = static_cast<double>(c[k]);
    std::array<Wide, 2> velocity;
    for (std::size_t phase = 0; phase < 2; ++phase) {
      velocity[phase] = rotation[phase][k] / (root_density[phase] * c[k]);
      velocity_of_mode_[phase][k] = static_cast<double>(velocity[phase]);
      traction_of_mode_[phase][k] =
          static_cast<double>(rotation[phase][k] * root_density[phase] * c[k]);
    }
    h[k] = std::sqrt(m.drag) * (velocity[0] - velocity[1]);
    drag_[k] = static_cast<double>(h[k]);
    // n . r_k from the second row of A r_k, where it does not cancel for the slow mode.
    outflow_of_mode_[k] =
        static_cast<double>(rotation[1][k] * root_density[1] * c[k] / (m.K * m.nf));
  }
  const Wide gap = (c[0] - c[1]) * (c[0] + c[1]) / (fast * slow);
  slowness_gap_ = static_cast<double>(gap);
  branch_point_ = {static_cast<double>((h[0] - h[1]) * (h[0] + h[1]) / gap),
                   static_cast<double>(2.0L * std::abs(h[0] * h[1]) / gap)};
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
