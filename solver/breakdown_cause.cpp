#include "solver/breakdown_cause.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "solver/column_solver.hpp"
#include "solver/poor_place.hpp"
#include "solver/stability/critical_step.hpp"
#include "solver/time_step.hpp"

namespace porowave::solver {

namespace {

constexpr double explaining_factor = 1e4;
constexpr double harmless_factor = 10.0;
constexpr double share_of_critical = 0.9;
constexpr double harmless_motion = 0.1;  // elements
// Dense matrices of more rows cost more than the iteration.
constexpr std::size_t largest_dense_state = 100;

double spacing_of(const Case& scene) {
  return ColumnSolver::grid_length(scene) / scene.discretization.elements;
}

double courant_of(const Case& scene, double time_step) {
  return time_step * wave_speeds(scene.problem.material).p1 / spacing_of(scene);
}

// Growth a step from which on a run of so many steps is called unstable.
double limit_for(const Case& scene, double steps) {
  const double affordable = 1.4e-6 * scene.discretization.elements;
  return std::clamp(std::log(harmless_factor) / steps, affordable, 0.05);
}

GrowthSettings growth_settings(const Case& scene, double steps) {
  GrowthSettings settings;
  settings.limit = limit_for(scene, steps);
  settings.largest_dense = largest_dense_state;
  settings.want_mode = true;
  return settings;
}

// The scene at the step of its run.
struct Analysis {
  const Case& scene;
  double courant;
  double steps;  // of the whole run
  GrowthSettings settings;
  SceneGrowth growth;

  Analysis(const Case& of, double time_step)
      : scene(of),
        courant(courant_of(of, time_step)),
        steps(of.time.end / time_step),
        settings(growth_settings(of, steps)),
        growth(of, settings) {}

  bool stable(double at) { return growth.at(at).per_step <= 1.0 + settings.limit; }
};

// Where the energy of a mode is densest.
double peak_of(const std::vector<std::complex<double>>& mode, const StepOperator& step,
               const Material& m) {
  std::vector<double> real(mode.size()), imaginary(mode.size());
  for (std::size_t k = 0; k < mode.size(); ++k) {
    real[k] = mode[k].real();
    imaginary[k] = mode[k].imag();
  }
  const CarriedFields a = step.fields(real);
  const CarriedFields b = step.fields(imaginary);
  double largest = -1.0, x = 0.0;
  const auto see = [&](double energy, double place) {
    if (energy > largest) {
      largest = energy;
      x = place;
    }
  };
  const auto squared = [](double p, double q) { return p * p + q * q; };
  for (std::size_t i = 0; i < a.node_x.size(); ++i) {
    see(m.solid_partial_density() * squared(a.solid_velocity[i], b.solid_velocity[i]) +
            m.fluid_partial_density() * squared(a.fluid_velocity[i], b.fluid_velocity[i]),
        a.node_x[i]);
  }
  for (std::size_t c = 0; c < a.cell_x.size(); ++c) {
    see(squared(a.effective_stress[c], b.effective_stress[c]) / m.constrained_modulus +
            squared(a.pore_pressure[c], b.pore_pressure[c]) / m.storage_modulus(),
        a.cell_x[c]);
  }
  return x;
}

// A stable Courant number below that of the run, with a margin if that is stable as well. The
// critical one is returned beside it.
std::optional<std::pair<double, double>> stable_courant(Analysis& at) {
  CriticalSettings search;
  search.limit = at.settings.limit;
  search.highest = at.courant;
  search.lowest = std::min(0.05, 0.2 * at.courant);
  search.spacing = std::max(0.05 * at.courant, (search.highest - search.lowest) / 20.0);
  search.tolerance = 0.01;
  search.whole_scan = false;
  const double critical =
      critical_step([&](double courant) { return at.growth.at(courant).per_step; }, search).courant;
  if (critical == 0.0) return std::nullopt;
  for (const double share : {share_of_critical, 1.0}) {
    const double advised = std::floor(100.0 * share * critical) / 100.0;
    if (advised > 0.0 && at.stable(advised)) return std::pair{advised, critical};
  }
  return std::nullopt;
}

// Other choices that may help where no shorter step does, as words and as a case.
std::vector<std::pair<std::string, Case>> other_choices(const Case& scene) {
  std::vector<std::pair<std::string, Case>> choices;
  const auto add = [&](std::string words, auto&& change) {
    Case other = scene;
    other.time.path = StepPath::points;
    change(other);
    choices.emplace_back(std::move(words), std::move(other));
  };
  const Discretization& d = scene.discretization;
  const bool galerkin = d.scheme == Scheme::galerkin;
  const bool is_mls = galerkin && d.transfer == TransferName::mls;
  const bool is_linear = is_mls || (galerkin && d.transfer == TransferName::shape &&
                                    d.shape == shape_name<LinearSpline>);
  if (is_linear && d.strain == Strain::cell) {
    add("strain = \"recovered\"", [](Case& c) { c.discretization.strain = Strain::recovered; });
  }
  if (is_mls && !d.adaptive_support) {
    add("an adaptive support_radius", [](Case& c) { c.discretization.adaptive_support = true; });
  }
  if (is_mls && d.basis_order != 1) {
    add("basis_order = 1", [](Case& c) { c.discretization.basis_order = 1; });
  }
  if (galerkin && d.transfer != TransferName::apic && scene.time.xpic_order == 0) {
    add("xpic_order = 2", [](Case& c) { c.time.xpic_order = 2; });
  }
  for (const int factor : {2, 4}) {
    const int points = factor * d.points_per_element;
    add(fmt::format("points_per_element = {}", points),
        [=](Case& c) { c.discretization.points_per_element = points; });
  }
  if (d.placement != Placement::uniform) {
    add("placement = \"uniform\"",
        [](Case& c) { c.discretization.placement = Placement::uniform; });
  }
  return choices;
}

std::optional<std::string> stable_choice(const Case& scene, double time_step) {
  for (const auto& [words, other] : other_choices(scene)) {
    try {
      Analysis at(other, time_step);
      if (at.stable(at.courant)) return words;
    } catch (const std::exception&) {
      continue;  // not a choice for this scene
    }
  }
  return std::nullopt;
}

void explain_growth(Analysis& at, const Growth& found, const BrokenRun& run,
                    BreakdownCause& cause) {
  const double h = spacing_of(at.scene);
  std::string where;
  if (!found.mode.empty()) {
    cause.x = peak_of(found.mode, at.growth.step(), at.scene.problem.material);
    where =
        fmt::format(", most near x = {:.6g} m{}", cause.x, poor_place(at.scene, cause.x, 2.0 * h));
  }
  const std::string what =
      fmt::format("fields grow by a factor of {:.6g} a step at courant = {:.3g}{}", found.per_step,
                  at.courant, where);
  if (const auto courant = stable_courant(at)) {
    cause.kind = CauseKind::long_step;
    cause.courant = courant->first;
    cause.text = fmt::format(
        "likely cause: the time step is too long: {}; the scene is stable at {:.3g}; "
        "try a smaller courant: {:.3g}",
        what, courant->second, courant->first);
    return;
  }
  cause.kind = CauseKind::unstable_points;
  const auto other = stable_choice(at.scene, run.time_step);
  cause.text = fmt::format(
      "likely cause: these points are unstable at this and every shorter time step: {}; {}", what,
      other ? fmt::format("stable with {}: try that", *other)
            : "nor was another choice of strain, support, points or update found stable; try more "
              "points in every element");
}

void explain_motion(const Case& scene, const BrokenRun& run, BreakdownCause& cause) {
  const double strain = scene.problem.stress_scale() / scene.problem.material.constrained_modulus;
  const double at_rest = strain * scene.discretization.elements;
  const double elements = run.moved / spacing_of(scene);
  if (elements > far_moved && at_rest > far_at_rest) {
    cause.kind = CauseKind::moved_points;
    cause.text = fmt::format(
        "likely cause: points have left their cells: they have moved by {:.3g} elements, under a "
        "load that moves its end by {:.3g} at rest (a strain of {:.2g}), while the time step is "
        "stable where they started; try a load of less than {:.1g} of this one",
        elements, at_rest, strain, harmless_motion / at_rest);
    return;
  }
  cause.text = fmt::format(
      "no cause found: the time step is stable where the points started (fields grow by a factor "
      "of {:.6g} a step at most) "
      "and points have moved by {:.2g} elements; look at the load and at what else drives the run",
      cause.growth, elements);
}

}  // namespace

BreakdownCause breakdown_cause(const Case& scene, const BrokenRun& run) {
  BreakdownCause cause;
  if (scene.discretization.elements > most_elements_analysed) {
    cause.text = fmt::format(
        "no cause looked for with more than {} elements; try a smaller courant, or fewer elements "
        "to learn more",
        most_elements_analysed);
    return cause;
  }
  try {
    Analysis at(scene, run.time_step);
    const Growth found = at.growth.at(at.courant);
    cause.growth = found.per_step;
    if (static_cast<double>(run.steps) * std::log(found.per_step) >= std::log(explaining_factor)) {
      explain_growth(at, found, run, cause);
    } else {
      explain_motion(scene, run, cause);
    }
  } catch (const std::exception& error) {
    cause = {};
    cause.text = fmt::format("no cause found: {}; try a smaller courant", error.what());
  }
  return cause;
}

std::string reason_and_cause(const Case& scene, const Breakdown& breakdown) {
  if (breakdown.time_step == 0.0) return breakdown.reason;
  const BrokenRun run{breakdown.step, breakdown.time_step, breakdown.moved};
  return breakdown.reason + "; " + breakdown_cause(scene, run).text;
}

}  // namespace porowave::solver
