#include "verification/stability/observed_growth.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "solver/column_solver.hpp"
#include "solver/staggered/staggered_solver.hpp"

namespace porowave::verification {

namespace {

/// Of the start, relative to fields of 1 m/s. Grown by 1e40 between two looks and by 1e40 before,
/// it is still too small to move a point.
constexpr double smallness = 1e-140;
constexpr double exploded = 1e40;
constexpr long looks_apart = 64;  ///< steps; at the beginning 16

/// Stresses per velocity of the same energy.
double stress_scale(const Material& m) {
  return m.mixture_density() * wave_speeds(m).p1;
}

/// Largest value of any point, in multiples of the start.
double size_of(const solver::Snapshot& now, double stress) {
  double size = 0.0;
  const auto see = [&](const std::vector<double>& values, double scale) {
    for (const double value : values) {
      const double share = std::abs(value) / scale;
      if (!(share <= size)) size = share;  // keeps a NaN
    }
  };
  for (const solver::PhasePoints* points : {&now.solid, &now.fluid}) {
    see(points->velocity, smallness);
    see(points->stress, smallness * stress);
  }
  return size;
}

/// Sizes of a run at times of looking.
struct History {
  std::vector<long> steps;
  std::vector<double> sizes;

  double largest(long first, long last) const {
    double size = 0.0;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      if (steps[k] > first && steps[k] <= last) size = std::max(size, sizes[k]);
    }
    return size;
  }
  /// Over the second half of the first n steps; from the start where little was seen.
  double growth(long n) const {
    const double before = largest(n * 3 / 8, n / 2);
    const double after = largest(n * 7 / 8, n);
    if (steps.size() < 8) return std::pow(sizes.back(), 1.0 / static_cast<double>(n));
    return before > 0.0 ? std::pow(after / before, 2.0 / static_cast<double>(n)) : 0.0;
  }
};

/// Whether growth after so many steps leaves no doubt on which side of the limit it stays: not when
/// it is too close, nor when it is below and still rising.
bool clear(const History& history, long steps, double limit) {
  const double now = history.growth(steps) - 1.0;
  if (std::abs(now - limit) <= 3.0 / static_cast<double>(steps)) return false;
  const double earlier = history.growth(steps / 2) - 1.0;
  return now > limit || now < 0.1 * limit || now - earlier < 0.05 * limit;
}

template <class Solver>
ObservedGrowth watch(Solver& solver, double stress, long steps, double limit) {
  History history;
  for (long most = steps;; most *= 2) {
    while (solver.steps_done() < most) {
      const long pause = solver.steps_done() < 16 * looks_apart ? 16 : looks_apart;
      for (long n = 0; n < pause; ++n) solver.step();
      history.steps.push_back(solver.steps_done());
      history.sizes.push_back(size_of(solver.snapshot(), stress));
      const double size = history.sizes.back();
      if (size < exploded) continue;  // false for NaN
      return {history.growth(solver.steps_done()), solver.steps_done()};
    }
    if (clear(history, most, limit) || most >= 16 * steps) return {history.growth(most), most};
  }
}

solver::Case run_of(const solver::Case& scene, double courant, long steps) {
  solver::Case run = scene;
  const double h = solver::ColumnSolver::grid_length(scene) / scene.discretization.elements;
  run.problem.column.length = solver::ColumnSolver::grid_length(scene);
  run.time.courant = courant;
  run.time.end = static_cast<double>(steps) * courant * h / wave_speeds(scene.problem.material).p1;
  run.time.path = solver::StepPath::automatic;
  run.problem.load = Load(LoadShape::step, 0.0);
  return run;
}

}  // namespace

ObservedGrowth observed_growth(const solver::Case& scene, double courant, long steps,
                               double limit) {
  solver::Case run = run_of(scene, courant, steps);
  const double stress = stress_scale(scene.problem.material);
  const bool staggered = scene.discretization.scheme == solver::Scheme::staggered4;
  if (staggered || scene.discretization.transfer == solver::TransferName::apic) {
    const bool velocity = scene.problem.column.near == NearEnd::velocity;
    run.problem.load = Load(LoadShape::step, smallness * (velocity ? 1.0 : stress));
    if (staggered) {
      solver::StaggeredSolver solver(run);
      return watch(solver, stress, steps, limit);
    }
    solver::ColumnSolver solver(run);
    solver.use_threads(1);
    return watch(solver, stress, steps, limit);
  }
  solver::ColumnSolver solver(run);
  solver.use_threads(1);
  std::mt19937_64 generator(scene.discretization.seed + 1);
  const auto noise = [&] {
    return smallness * (static_cast<double>(generator() >> 11) * 0x1p-52 - 1.0);
  };
  solver.start_from([&](double, double) {
    const double effective_stress = stress * noise();
    const double pore_pressure = stress * noise();
    const double solid_velocity = noise();
    return Fields{effective_stress, pore_pressure, solid_velocity, noise()};
  });
  return watch(solver, stress, steps, limit);
}

}  // namespace porowave::verification
