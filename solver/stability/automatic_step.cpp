#include "solver/stability/automatic_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "solver/column_solver.hpp"
#include "solver/stability/critical_step.hpp"
#include "solver/stability/remedies.hpp"
#include "solver/stability/run_growth.hpp"
#include "solver/time_step.hpp"

namespace porowave::solver {

namespace {

constexpr double widest_support_of_window = 12.0;
constexpr int ways_of_moving = 8;
constexpr int gap_group = 8;  // elements that stay together when a gap is moved

bool on_shape_functions(const Discretization& d) {
  return d.scheme == Scheme::galerkin && d.transfer != TransferName::mls;
}

// Gaps of the first elements, or the first one moved into their middle.
std::vector<double> gaps_of_window(const Discretization& d, double h) {
  std::vector<double> gaps;
  for (const double x : d.empty_elements) {
    if (x < most_analysed_elements * h) gaps.push_back(x);
  }
  if (!gaps.empty() || d.empty_elements.empty()) return gaps;
  const double first = *std::min_element(d.empty_elements.begin(), d.empty_elements.end());
  const double shift = std::floor(first / h - most_analysed_elements / 2) * h;
  for (const double x : d.empty_elements) {
    if (x < first + gap_group * h) gaps.push_back(x - shift);
  }
  return gaps;
}

Case window_of(const Case& scene) {
  if (scene.discretization.elements <= most_analysed_elements) return scene;
  Case window = scene;
  const double h = ColumnSolver::grid_length(scene) / scene.discretization.elements;
  window.problem.column.length = most_analysed_elements * h;
  window.discretization.elements = most_analysed_elements;
  window.discretization.empty_elements = gaps_of_window(scene.discretization, h);
  return window;
}

// Regular points next to a gap can end exactly where a node begins. Moved by next to nothing they
// give that node next to no mass, and the step is another: so the same points a little moved, in
// several ways, must be stable as well.
std::vector<RunGrowth> with_moved_points(const Case& scene, double end) {
  const Discretization& d = scene.discretization;
  std::vector<RunGrowth> moved;
  if (d.placement != Placement::uniform || d.empty_elements.empty()) return moved;
  Case jittered = scene;
  jittered.discretization.placement = Placement::jittered;
  jittered.discretization.jitter = reweight_share * d.points_per_element;
  for (int seed = 1; seed <= ways_of_moving; ++seed) {
    jittered.discretization.seed = static_cast<std::uint64_t>(seed);
    moved.emplace_back(jittered, end);
  }
  return moved;
}

AutomaticStep by_formula(const Case& scene) {
  return {StepRule::formula, estimated_courant(scene), 0.0,
          std::numeric_limits<double>::quiet_NaN(), 0};
}

std::string no_stable_step(const Case& window, RunGrowth& growth, const CriticalStep& found) {
  const auto best =
      std::min_element(found.scan.begin(), found.scan.end(),
                       [](const auto& a, const auto& b) { return a.growth < b.growth; });
  const FastestMode mode = growth.fastest(best->courant);
  const auto remedies = remedies_that_help(window, growth.end());
  return fmt::format(
      "a scene with a stable step: with these points and this method noise grows at every courant "
      "from {:g} to {:g}; least at {:.3g}, by {:.2g} a step ({:.1e} times in this run), most at "
      "x = {:.4g} m. {}",
      found.scan.back().courant, found.scan.front().courant, best->courant, mode.per_step - 1.0,
      best->growth, mode.x,
      remedies.empty() ? "Other points are needed: placement = \"uniform\" or more of them"
                       : "Stable with " + remedies);
}

std::string no_step_with_a_margin(const CriticalStep& found, bool gaps) {
  return fmt::format(
      "a scene with a stable step: courant {:.3g} is the largest stable one, but none from nine "
      "tenths of it down to {:.2g} is{}; points_per_element, placement or kernel can change that",
      found.courant, share_of_critical * run_scan().lowest,
      gaps ? " when the points have moved a little (next to the empty elements)" : "");
}

}  // namespace

AutomaticStep automatic_step(const Case& scene) {
  const Discretization& d = scene.discretization;
  const bool whole = d.elements <= most_analysed_elements;
  if (!whole && (on_shape_functions(d) || d.support_radius > widest_support_of_window)) {
    return by_formula(scene);
  }
  const Case window = window_of(scene);
  RunGrowth growth(window, scene.time.end);
  const CriticalStep found =
      critical_step([&](double courant) { return growth.at(courant); }, run_scan());
  const AutomaticStep choice{whole ? StepRule::critical_step : StepRule::window, 0.0, found.courant,
                             0.0, window.discretization.elements};
  std::vector<RunGrowth> moved = with_moved_points(window, scene.time.end);
  const auto chosen = [&](double courant) {
    AutomaticStep step = choice;
    step.courant = courant;
    step.noise_growth = growth.at(courant);
    for (RunGrowth& other : moved)
      step.noise_growth = std::max(step.noise_growth, other.at(courant));
    return step;
  };
  double courant = share_of_critical * found.courant;
  if (!whole && d.placement != Placement::uniform) {
    courant = std::min(courant, estimated_courant(scene));
  }
  for (; courant >= share_of_critical * run_scan().lowest; courant *= share_of_critical) {
    const AutomaticStep step = chosen(courant);
    if (step.noise_growth <= tolerated_growth) return step;
  }
  if (on_shape_functions(d)) {
    const AutomaticStep step = chosen(estimated_courant(scene));
    if (step.noise_growth <= tolerated_growth) return step;
  }
  if (found.courant > 0.0) throw NoStableStep(no_step_with_a_margin(found, !moved.empty()));
  throw NoStableStep(no_stable_step(window, growth, found));
}

double automatic_courant(const Case& scene) {
  return automatic_step(scene).courant;
}

}  // namespace porowave::solver
