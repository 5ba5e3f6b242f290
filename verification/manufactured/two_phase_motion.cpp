#include "verification/manufactured/two_phase_motion.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace porowave::verification {

using std::numbers::pi;

TwoPhaseMotion::TwoPhaseMotion(const Material& material, double length, NearEnd near, double strain)
    : problem_{material, {length, near, FarEnd::rigid_sealed}, Load(LoadShape::step, 0.0)},
      rate_(material.undrained_speed() * pi / length) {
  if (near != NearEnd::velocity && near != NearEnd::drained_traction) {
    throw std::invalid_argument("two-phase motion: expected near velocity or drained_traction");
  }
  const double size = strain * length / pi;
  const double apart = size / (1.0 + material.drag() / (material.fluid_partial_density() * rate_));
  solid_ = {{size, 1, rate_, 0.4}, {0.4 * size, 2, 1.3 * rate_, 1.9}};
  fluid_ = solid_;
  fluid_.push_back({apart, 1, 0.8 * rate_, 1.2});
  fluid_.push_back({0.5 * apart, 2, rate_, -0.3});
}

double TwoPhaseMotion::derivative(const Modes& modes, int in_x, int in_t, double x,
                                  double t) const {
  // Every derivative of a sine turns it by a quarter; a cosine is a sine a quarter ahead.
  const bool is_cosine = problem_.column.near == NearEnd::drained_traction;
  double sum = 0.0;
  for (const Mode& mode : modes) {
    const double number = mode.number - (is_cosine ? 0.5 : 0.0);
    const double wave_number = number * pi / *problem_.column.length;
    const double ahead = 0.5 * pi * (in_x + (is_cosine ? 1 : 0));
    sum += mode.amplitude * std::pow(wave_number, in_x) * std::sin(wave_number * x + ahead) *
           std::pow(mode.rate, in_t) * std::sin(mode.rate * t + mode.phase + 0.5 * pi * in_t);
  }
  return sum;
}

Fields TwoPhaseMotion::fields(double x, double t) const {
  const Material& m = problem_.material;
  const double solid_strain = derivative(solid_, 1, 0, x, t);
  const double fluid_strain = derivative(fluid_, 1, 0, x, t);
  return {m.constrained_modulus * solid_strain,
          -m.storage_modulus() * (m.solid_fraction() * solid_strain + m.porosity * fluid_strain),
          derivative(solid_, 0, 1, x, t), derivative(fluid_, 0, 1, x, t)};
}

solver::PhaseForces TwoPhaseMotion::body_force(double x, double t) const {
  const Material& m = problem_.material;
  const double solid_slope = derivative(solid_, 2, 0, x, t);
  const double fluid_slope = derivative(fluid_, 2, 0, x, t);
  const double stress_slope = m.constrained_modulus * solid_slope;
  const double pressure_slope =
      -m.storage_modulus() * (m.solid_fraction() * solid_slope + m.porosity * fluid_slope);
  const double drag = m.drag() * (derivative(fluid_, 0, 1, x, t) - derivative(solid_, 0, 1, x, t));
  return {m.solid_partial_density() * derivative(solid_, 0, 2, x, t) - stress_slope +
              m.solid_fraction() * pressure_slope - drag,
          m.fluid_partial_density() * derivative(fluid_, 0, 2, x, t) + m.porosity * pressure_slope +
              drag};
}

}  // namespace porowave::verification
