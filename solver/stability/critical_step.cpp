#include "solver/stability/critical_step.hpp"

#include <cmath>
#include <stdexcept>

#include "solver/column_solver.hpp"

namespace porowave::solver {

SceneGrowth::SceneGrowth(const Case& scene, const GrowthSettings& settings)
    : step_(step_operator(scene)),
      settings_(settings),
      crossing_(ColumnSolver::grid_length(scene) / scene.discretization.elements /
                wave_speeds(scene.problem.material).p1) {}

Growth SceneGrowth::at(double courant) {
  GrowthSettings settings = settings_;
  settings.want_mode = settings.want_mode || step_->size() > settings.largest_dense;
  Growth found = growth(step_->at(time_step(courant)), settings);
  if (!found.mode.empty()) settings_.guess = found.mode;
  return found;
}

std::vector<CriticalStep::Sample> CriticalStep::unstable_below() const {
  std::vector<Sample> below;
  for (const Sample& sample : scan) {
    if (sample.courant < courant && !sample.stable) below.push_back(sample);
  }
  return below;
}

CriticalStep critical_step(const std::function<double(double)>& growth_at,
                           const CriticalSettings& settings) {
  if (!(settings.limit > 0.0 && settings.lowest > 0.0 && settings.highest >= settings.lowest &&
        settings.spacing > 0.0 && settings.tolerance > 0.0)) {
    throw std::invalid_argument(
        "critical step: expected 0 < lowest <= highest, and limit, "
        "spacing and tolerance > 0");
  }
  const auto sample = [&](double courant) {
    const double growth = growth_at(courant);
    return CriticalStep::Sample{courant, growth, growth <= 1.0 + settings.limit};
  };
  CriticalStep found;
  const double steps = (settings.highest - settings.lowest) / settings.spacing;
  for (int k = 0; k <= static_cast<int>(std::floor(steps + 1e-9)); ++k) {
    found.scan.push_back(sample(settings.highest - k * settings.spacing));
    if (!found.scan.back().stable || found.courant > 0.0) continue;
    found.courant = found.scan.back().courant;
    if (k > 0) found.unstable = found.scan[found.scan.size() - 2].courant;
    if (!settings.whole_scan) break;
  }
  if (found.courant == 0.0) {
    found.unstable = found.scan.back().courant;
    return found;
  }
  while (found.unstable - found.courant > settings.tolerance * found.courant) {
    const auto middle = sample(0.5 * (found.courant + found.unstable));
    (middle.stable ? found.courant : found.unstable) = middle.courant;
  }
  return found;
}

}  // namespace porowave::solver
