#include "reference/consolidation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "reference/constants.hpp"
#include "reference/phi.hpp"
#include "reference/problem/errors.hpp"

namespace porowave::reference {

namespace {

void require_consolidation(const Problem& problem) {
  const Column& column = problem.column;
  const LoadShape shape = problem.load.shape();
  if (column.far != FarEnd::rigid_sealed ||
      (column.near != NearEnd::drained_traction && column.near != NearEnd::fluid_pressure)) {
    throw InputError(fmt::format(
        "consolidation with ends {} and {}: expected drained_traction or fluid_pressure, and "
        "rigid_sealed",
        name(column.near), name(column.far)));
  }
  if (shape != LoadShape::step && shape != LoadShape::smooth_ramp &&
      shape != LoadShape::sin4_pulse) {
    throw InputError(fmt::format(
        "consolidation under a load {}: expected step, smooth_ramp or sin4_pulse", name(shape)));
  }
}

/// dq/dt for t > 0.
double rate(const Load& load, double t) {
  const double T = load.duration();
  const double z = t / T;
  if (load.shape() == LoadShape::step || z >= 1.0) return 0.0;
  if (load.shape() == LoadShape::smooth_ramp) {
    return load.magnitude() * 30.0 / T * z * z * (1.0 - z) * (1.0 - z);
  }
  return load.magnitude() * pi / T * (std::sin(2.0 * pi * z) - 0.5 * std::sin(4.0 * pi * z));
}

/// integral_0^t sin(b t') e^(-a (t - t')) dt'
double sine_response(double b, double a, double t) {
  return (a * std::sin(b * t) - b * std::cos(b * t) + b * std::exp(-a * t)) / (a * a + b * b);
}

/// integral_0^t dq/dt' e^(-a (t - t')) dt'
double response(const Load& load, double a, double t) {
  if (load.shape() == LoadShape::step) return load.magnitude() * std::exp(-a * t);
  const double T = load.duration();
  const double loading = std::min(t, T);
  const double since = std::exp(-a * (t - loading));
  if (since == 0.0) return 0.0;
  if (load.shape() == LoadShape::sin4_pulse) {
    const double b = 2.0 * pi / T;
    return load.magnitude() * since * pi / T *
           (sine_response(b, a, loading) - 0.5 * sine_response(2.0 * b, a, loading));
  }
  // dq/dt = 30/T (z^2 - 2 z^3 + z^4); t^n/n! convolves to t^(n+1) phi_(n+1)(-a t).
  const double z = loading / T;
  const auto phi = phi_functions<5>(-a * loading);
  return load.magnitude() * since * 30.0 * z * z * z *
         (2.0 * phi[3] - 12.0 * z * phi[4] + 24.0 * z * z * phi[5]).real();
}

}  // namespace

Fields consolidating(const Problem& problem, double x, double t) {
  require_consolidation(problem);
  if (t <= 0.0) return {};
  const Material& m = problem.material;
  const double E = m.constrained_modulus;
  const double K = m.storage_modulus();
  const double L = *problem.column.length;
  const double cv = m.intrinsic_permeability / m.fluid_viscosity * E * K / (E + K);
  const double q = problem.load.value(t);
  const double q_rate = rate(problem.load, t);

  // p = held q + what diffuses, which is 0 at x = 0 and has the source driven dq/dt.
  const bool fluid_loads = problem.column.near == NearEnd::fluid_pressure;
  const double held = fluid_loads ? 1.0 : 0.0;
  const double driven = fluid_loads ? -E / (E + K) : K / (E + K);
  double pressure = held * q;
  double integral = held * q_rate * (L - x);  // of dp/dt from x to L
  constexpr int most_terms = 20'000;
  for (int j = 0; j < most_terms; ++j) {
    const double M = (j + 0.5) * pi;
    const double a = M * M * cv / (L * L);
    const double excited = driven * response(problem.load, a, t);
    const double changing = driven * q_rate - a * excited;
    pressure += 2.0 / M * std::sin(M * x / L) * excited;
    integral += 2.0 * L / (M * M) * std::cos(M * x / L) * changing;
    if (problem.load.shape() == LoadShape::step && a * t > 50.0) break;
  }
  const double solid = -(integral - q_rate * (L - x)) / E;
  const double both = integral / K;  // n_s v_s + n_f v_f, what is squeezed out beyond x
  return {pressure - q, pressure, solid, (both - m.solid_fraction() * solid) / m.porosity};
}

}  // namespace porowave::reference
