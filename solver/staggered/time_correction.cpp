#include "solver/staggered/time_correction.hpp"

#include <cmath>

namespace porowave::solver {

namespace {

// ∫ e^(−θ (1/2 − τ)) τ dτ over ±1/2, divided by φ_1(θ)
double forgetting(double theta) {
  if (theta < 1e-3) return theta / 12.0;
  const double integral =
      0.5 * phi_1(theta) - (1.0 - std::exp(-theta) * (1.0 + theta)) / (theta * theta);
  return integral / phi_1(theta);
}

}  // namespace

TimeCorrection::TimeCorrection(const Problem& problem, double dt, std::size_t nodes)
    : problem_(problem), dt_(dt), theta_(problem.material.relaxation_rate() * dt) {
  force_rates.assign(nodes);
}

void TimeCorrection::correct(BothPhases& forces, const BothPhases& second, StepPart part,
                             std::size_t end) const {
  // Weights of f′(t − dt/2) and of f″ dt, with f′(t) = f′(t − dt/2) + f″ dt/2. Over the first half
  // the mean of τ is −dt/4, that of τ²/2 is dt²/24; drag moves the former towards 0 by θ/12.
  const bool whole = part == StepPart::whole;
  const double by_rate = whole ? 0.0 : -0.25 * dt_;
  const double by_second = whole ? dt_ / 24.0 : dt_ / 24.0 - 0.125 * dt_;
  const double relative = dt_ * (whole ? forgetting(theta_) : 0.25 * theta_ / (12.0 + theta_));
  const double solid = problem_.material.solid_partial_density();
  const double fluid = problem_.material.fluid_partial_density();
  const double reduced = relative * solid * fluid / (solid + fluid);
  for (std::size_t i = 0; i < end; ++i) {
    const double rate_s = force_rates.solid[i] + 0.5 * second.solid[i];
    const double rate_f = force_rates.fluid[i] + 0.5 * second.fluid[i];
    const double of_drag = reduced * (rate_f / fluid - rate_s / solid);
    forces.solid[i] += by_rate * force_rates.solid[i] + by_second * second.solid[i] - of_drag;
    forces.fluid[i] += by_rate * force_rates.fluid[i] + by_second * second.fluid[i] + of_drag;
  }
}

void TimeCorrection::find_mean_velocities(const std::vector<double>& solid,
                                          const std::vector<double>& fluid,
                                          const BothPhases& increments, double load_mean,
                                          std::size_t end, BothPhases& mean) const {
  const double rho_s = problem_.material.solid_partial_density();
  const double rho_f = problem_.material.fluid_partial_density();
  const double fluid_share = rho_f / (rho_s + rho_f);
  const double drag = theta_ / dt_ / (1.0 + theta_ * theta_);  // of the relative velocity, bounded
  const double weight = dt_ * dt_ / 24.0;
  for (std::size_t i = 0; i < end; ++i) {
    const double rate_s = force_rates.solid[i] / rho_s;
    const double rate_f = force_rates.fluid[i] / rho_f;
    // w′ = (v_f − v_s)′: half a step ago, and brought to now.
    const double before = (increments.fluid[i] - increments.solid[i]) / dt_;
    const double slowing = drag * (before + 0.5 * dt_ * (rate_f - rate_s - drag * before));
    mean.solid[i] = solid[i] + weight * (rate_s + fluid_share * slowing);
    mean.fluid[i] = fluid[i] + weight * (rate_f - (1.0 - fluid_share) * slowing);
  }
  if (problem_.column.near == NearEnd::sealed_traction) {
    const double rate = (force_rates.solid[0] + force_rates.fluid[0]) / (rho_s + rho_f);
    mean.solid[0] = mean.fluid[0] = solid[0] + weight * rate;
  }
  prescribe_mean_at_ends(load_mean, mean);
}

void TimeCorrection::prescribe_mean_at_ends(double load_mean, BothPhases& mean) const {
  if (problem_.column.near == NearEnd::velocity) mean.solid[0] = mean.fluid[0] = load_mean;
  switch (problem_.column.far) {
    case FarEnd::rigid_sealed:
    case FarEnd::half_space:
      mean.solid.back() = mean.fluid.back() = 0.0;
      break;
    case FarEnd::rigid_drained:
      mean.solid.back() = 0.0;
      break;
    case FarEnd::free_drained:
      break;
  }
}

}  // namespace porowave::solver
