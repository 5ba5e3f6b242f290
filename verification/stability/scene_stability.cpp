#include "verification/stability/scene_stability.hpp"

#include <algorithm>
#include <cmath>

#include "solver/staggered/staggered_solver.hpp"

namespace porowave::verification {

namespace {

/// A mode is looked for at this multiple of the critical step, where it stands out.
constexpr double beyond_critical = 1.02;

template <class Solver>
void read_step(const solver::Case& scene, SceneStability& found) {
  const Solver solver(scene);
  found.time_step = solver.time_step();
  found.steps = solver.planned_steps();
}

double largest(const solver::CarriedFields& fields, double impedance) {
  double size = 0.0;
  const auto see = [&](const std::vector<double>& values, double scale) {
    for (const double value : values) size = std::max(size, std::abs(value) / scale);
  };
  see(fields.solid_velocity, 1.0);
  see(fields.fluid_velocity, 1.0);
  see(fields.effective_stress, impedance);
  see(fields.pore_pressure, impedance);
  return size;
}

/// The mode turned so that its largest component is real.
std::vector<std::complex<double>> turned(std::vector<std::complex<double>> mode) {
  const auto peak = *std::max_element(mode.begin(), mode.end(), [](const auto& a, const auto& b) {
    return std::abs(a) < std::abs(b);
  });
  for (auto& value : mode) value *= std::conj(peak) / std::abs(peak);
  return mode;
}

GrowingMode mode_of(const solver::Growth& growth, double courant, const solver::StepOperator& step,
                    double impedance) {
  const auto mode = turned(growth.mode);
  std::vector<double> real(mode.size()), imaginary(mode.size());
  std::transform(mode.begin(), mode.end(), real.begin(), [](const auto& z) { return z.real(); });
  std::transform(mode.begin(), mode.end(), imaginary.begin(),
                 [](const auto& z) { return z.imag(); });
  const double scale = 1.0 / largest(step.fields(real), impedance);
  for (auto* part : {&real, &imaginary}) {
    for (double& value : *part) value *= scale;
  }
  return {courant, growth.per_step, std::abs(std::arg(growth.eigenvalue)), step.fields(real),
          step.fields(imaginary)};
}

}  // namespace

SceneStability scene_stability(const solver::Case& scene, const solver::CriticalSettings& settings,
                               const std::function<void()>& progress) {
  SceneStability found{};
  if (scene.discretization.scheme == solver::Scheme::staggered4) {
    read_step<solver::StaggeredSolver>(scene, found);
  } else {
    read_step<solver::ColumnSolver>(scene, found);
  }
  solver::GrowthSettings of_growth;
  of_growth.limit = settings.limit;
  solver::SceneGrowth growth(scene, of_growth);
  found.fast_crossing = growth.time_step(1.0);
  found.courant = found.time_step / found.fast_crossing;
  const auto growth_at = [&](double courant) {
    const double per_step = growth.at(courant).per_step;
    if (progress) progress();
    return per_step;
  };
  found.critical = solver::critical_step(growth_at, settings);
  found.estimates = solver::step_estimates(scene);

  of_growth.want_mode = true;
  solver::SceneGrowth with_mode(scene, of_growth);
  found.at_requested = with_mode.at(found.courant);
  const Material& m = scene.problem.material;
  const double impedance = m.mixture_density() * m.undrained_speed();
  if (!found.stable(settings.limit) && !found.at_requested.mode.empty()) {
    found.mode = mode_of(found.at_requested, found.courant, with_mode.step(), impedance);
  } else if (found.critical.unstable > 0.0) {
    const double courant =
        std::max(beyond_critical * found.critical.courant, found.critical.unstable);
    const solver::Growth beyond = with_mode.at(courant);
    if (!beyond.mode.empty()) found.mode = mode_of(beyond, courant, with_mode.step(), impedance);
  }
  return found;
}

}  // namespace porowave::verification
