#include "verification/manufactured/bar_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace porowave::verification {

using std::numbers::pi;

namespace {

double growth(double t, double duration) {
  return 0.5 * (1.0 - std::cos(pi * t / duration));
}
double growth_rate(double t, double duration) {
  return 0.5 * pi / duration * std::sin(pi * t / duration);
}
double growth_acceleration(double t, double duration) {
  return 0.5 * pi * pi / (duration * duration) * std::cos(pi * t / duration);
}

/// u / (L g)
double form(const BarMotion& m, double X) {
  const double z = X / m.length;
  return m.shift + m.stretch * z + m.wave * std::cos(pi * z) + m.bulge * std::sin(pi * z);
}

}  // namespace

double BarMotion::place(double X, double t) const {
  return X + length * growth(t, duration) * form(*this, X);
}

double BarMotion::deformation(double X, double t) const {
  const double z = pi * X / length;
  return 1.0 + growth(t, duration) * (stretch - pi * wave * std::sin(z) + pi * bulge * std::cos(z));
}

double BarMotion::deformation_slope(double X, double t) const {
  const double z = pi * X / length;
  return -growth(t, duration) * pi * pi / length * (wave * std::cos(z) + bulge * std::sin(z));
}

double BarMotion::velocity(double X, double t) const {
  return length * growth_rate(t, duration) * form(*this, X);
}

double BarMotion::acceleration(double X, double t) const {
  return length * growth_acceleration(t, duration) * form(*this, X);
}

double BarMotion::stress(double X, double t) const {
  return solver::stress(law, deformation(X, t));
}

double BarMotion::body_force(double X, double t) const {
  const double F = deformation(X, t);
  return (density * acceleration(X, t) - solver::stress_slope(law, F) * deformation_slope(X, t)) /
         F;
}

double BarMotion::undeformed_place(double x, double t) const {
  double X = x - length * growth(t, duration) * form(*this, x);
  for (int iteration = 0; iteration < 50; ++iteration) {
    const double step = (place(X, t) - x) / deformation(X, t);
    X -= step;
    if (std::abs(step) <= 1e-15 * length) break;
  }
  return X;
}

solver::Bar BarMotion::bar(bool held) const {
  if (held && !(shift == 0.0 && stretch == 0.0 && wave == 0.0)) {
    throw std::invalid_argument("bar motion: the ends of this motion cannot be held");
  }
  const BarMotion motion = *this;
  solver::Bar bar;
  bar.near = 0.0;
  bar.far = length;
  bar.density = density;
  bar.law = law;
  const auto end = [&](double X) {
    solver::BarEnd e;
    e.held = held;
    if (!held) e.stress = [motion, X](double t) { return motion.stress(X, t); };
    return e;
  };
  bar.near_end = end(0.0);
  bar.far_end = end(length);
  bar.body_force = [motion](double x, double t) {
    return motion.body_force(motion.undeformed_place(x, t), t);
  };
  // Undeformed at t = 0: the place is X.
  bar.initial_velocity = [motion](double X, double t) { return motion.velocity(X, t); };
  return bar;
}

double BarMotion::fastest_wave() const {
  double fastest = 0.0;
  for (int i = 0; i <= 100; ++i) {
    const double X = length * i / 100.0;
    for (const double t : {0.0, 0.5 * duration, duration}) {
      fastest = std::max(fastest, solver::wave_speed(law, deformation(X, t), density));
    }
  }
  return fastest;
}

}  // namespace porowave::verification
