#include "solver/staggered/staggered_solver.hpp"
#include "solver/time_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace porowave::solver {

namespace {

constexpr double growth_limit = 1e6;
constexpr long steps_between_checks = 16;

// Nothing ahead of the signal moves, so only a window is stepped. It grows by some cells when
// something more than `at_rest` of the load's size is within `margin` of its end; a margin is more
// than a step reaches.
constexpr double at_rest = 1e-20;
constexpr std::size_t margin = 24;
constexpr std::size_t window_growth = 64;

// What is beyond its limit first, and where.
std::optional<std::string> excess_of(const std::vector<double>& values, double limit,
                                     const char* quantity, const char* place, double first,
                                     double spacing) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (std::abs(values[k]) <= limit) continue;  // false for NaN
    return fmt::format(
        "{} = {:g} at x = {:.6g} m, {} {}: {}", quantity, values[k],
        first + spacing * static_cast<double>(k), place, k,
        std::isfinite(values[k]) ? "more than 1e6 times the load" : "not a finite number");
  }
  return std::nullopt;
}

std::vector<double> regular_places(std::size_t count, double first, double spacing) {
  std::vector<double> x(count);
  for (std::size_t k = 0; k < count; ++k) x[k] = first + spacing * static_cast<double>(k);
  return x;
}

}  // namespace

StaggeredSolver::StaggeredSolver(const Case& scene)
    : scene_(scene),
      cells_(static_cast<std::size_t>(scene.discretization.elements)),
      spacing_(ColumnSolver::grid_length(scene) / scene.discretization.elements),
      dt_(0.0),
      steps_(step_count(scene, spacing_)),
      solid_(scene, Phase::solid, spacing_),
      fluid_(scene, Phase::fluid, spacing_),
      end_(std::min(cells_ + 1, window_growth)),
      update_(scene.problem, scene.time.end / static_cast<double>(steps_)) {
  dt_ = scene.time.end / static_cast<double>(steps_);
  if (scene.time.order == 4) correction_.emplace(scene.problem, dt_, cells_ + 1);
  for (auto* values : {&forces_, &increments_, &scratch_, &slopes_}) values->assign(cells_ + 1);
  stress_rates_.assign(cells_ + 2);
}

void StaggeredSolver::prescribe_stresses(std::vector<double>& effective_stress,
                                         std::vector<double>& pressure, double load) const {
  switch (scene_.problem.column.near) {
    case NearEnd::drained_traction:
      effective_stress[0] = -load;
      break;
    case NearEnd::sealed_traction:
      pressure[0] = fluid_.stress_at_near_end(pressure);
      effective_stress[0] = pressure[0] - load;
      break;
    case NearEnd::fluid_pressure:
      pressure[0] = load;
      break;
    case NearEnd::velocity:
      break;
  }
}

void StaggeredSolver::reconstruct() {
  prescribe_stresses(solid_.stress_sum, fluid_.stress_sum, scene_.problem.load.value(time()));
  solid_.reconstruct(end_);
  fluid_.reconstruct(end_);
}

void StaggeredSolver::find_forces(const std::vector<double>& effective_stress,
                                  const std::vector<double>& pressure, BothPhases& forces) {
  solid_.stress_slopes(effective_stress, slopes_.solid, end_);
  fluid_.stress_slopes(pressure, slopes_.fluid, end_);
  const double ns = scene_.problem.material.solid_fraction();
  const double nf = scene_.problem.material.porosity;
  for (std::size_t i = 0; i < end_; ++i) {
    forces.solid[i] = slopes_.solid[i] - ns * slopes_.fluid[i];
    forces.fluid[i] = -nf * slopes_.fluid[i];
  }
}

void StaggeredSolver::find_stress_rates(const std::vector<double>& solid,
                                        const std::vector<double>& fluid) {
  const Material& m = scene_.problem.material;
  const std::size_t cells = std::min(end_, cells_);
  solid_.velocity_slopes(solid, slopes_.solid, cells);
  fluid_.velocity_slopes(fluid, slopes_.fluid, cells);
  const double elastic = m.constrained_modulus;
  const double by_solid = m.storage_modulus() * m.solid_fraction();
  const double by_fluid = m.storage_modulus() * m.porosity;
  for (std::size_t c = 0; c < cells; ++c) {
    stress_rates_.solid[c + 1] = elastic * slopes_.solid[c];
    stress_rates_.fluid[c + 1] = -by_solid * slopes_.solid[c] - by_fluid * slopes_.fluid[c];
  }
}

void StaggeredSolver::kick(StepPart part) {
  const Load& load = scene_.problem.load;
  const bool whole = part == StepPart::whole;
  const double before = time() - 0.5 * dt_;
  const double after = whole ? time() + 0.5 * dt_ : time();
  // The correction of half a step starts from the force of now.
  const double traction = whole || !correction_ ? load.mean(before, after) : load.value(after);
  prescribe_stresses(solid_.stress, fluid_.stress, traction);
  find_forces(solid_.stress, fluid_.stress, forces_);
  if (correction_) correct_forces(part);
  const auto find_increments = [&](const VelocityUpdate& update) {
    update.find_increments(forces_, {traction, load.value(before), load.value(after)}, end_,
                           solid_.velocity, fluid_.velocity, increments_);
  };
  if (whole) {
    find_increments(update_);
  } else {
    find_increments(VelocityUpdate(scene_.problem, 0.5 * dt_));
  }
  for (std::size_t i = 0; i < end_; ++i) {
    solid_.velocity[i] += increments_.solid[i];
    fluid_.velocity[i] += increments_.fluid[i];
    solid_.velocity_sum[i] += increments_.solid[i];
    fluid_.velocity_sum[i] += increments_.fluid[i];
  }
}

void StaggeredSolver::correct_forces(StepPart part) {
  const Load& load = scene_.problem.load;
  const StepLoad step{0.0, load.value(time() - 0.5 * dt_), load.value(time() + 0.5 * dt_)};
  update_.find_increments(forces_, step, end_, solid_.velocity, fluid_.velocity, increments_);
  find_stress_rates(increments_.solid, increments_.fluid);
  // The mean of a traction has its second derivative already.
  prescribe_stresses(stress_rates_.solid, stress_rates_.fluid, 0.0);
  find_forces(stress_rates_.solid, stress_rates_.fluid, scratch_);
  correction_->correct(forces_, scratch_, part, end_);
}

void StaggeredSolver::drift() {
  find_stress_rates(solid_.velocity, fluid_.velocity);
  if (correction_) correct_stress_rates();
  const std::size_t cells = std::min(end_, cells_);
  for (std::size_t c = 1; c <= cells; ++c) {
    solid_.stress_sum[c] += dt_ * stress_rates_.solid[c];
    fluid_.stress_sum[c] += dt_ * stress_rates_.fluid[c];
  }
  for (std::size_t i = 0; i < end_; ++i) {
    solid_.displacement[i] += dt_ * solid_.velocity[i];
    fluid_.displacement[i] += dt_ * fluid_.velocity[i];
  }
}

void StaggeredSolver::correct_stress_rates() {
  const Load& load = scene_.problem.load;
  const double after = time() + dt_;
  prescribe_stresses(stress_rates_.solid, stress_rates_.fluid,
                     (load.value(after) - load.value(time())) / dt_);
  find_forces(stress_rates_.solid, stress_rates_.fluid, correction_->force_rates);
  correction_->find_mean_velocities(solid_.velocity, fluid_.velocity, increments_,
                                    load.mean(time(), after), end_, scratch_);
  find_stress_rates(scratch_.solid, scratch_.fluid);
}

void StaggeredSolver::widen_window() {
  if (end_ == cells_ + 1) return;
  const double stress = at_rest * scene_.problem.stress_scale();
  const double velocity = at_rest * scene_.problem.velocity_scale();
  bool moved = false;
  for (std::size_t i = end_ - margin; i < end_; ++i) {
    for (const PhaseLines* lines : {&solid_, &fluid_}) {
      moved = moved || !(std::abs(lines->velocity_sum[i]) <= velocity) ||
              !(std::abs(lines->stress_sum[i]) <= stress);
    }
  }
  if (moved) end_ = std::min(cells_ + 1, end_ + window_growth);
}

void StaggeredSolver::step() {
  reconstruct();
  kick(StepPart::whole);
  drift();
  widen_window();
  ++step_;
}

std::optional<Breakdown> StaggeredSolver::find_breakdown() const {
  const double stress = growth_limit * scene_.problem.stress_scale();
  const double velocity = growth_limit * scene_.problem.velocity_scale();
  const auto stress_excess = [&](const std::vector<double>& values, const char* quantity) {
    // The first one is of the cell before the column.
    return excess_of(values, stress, quantity, "cell", -0.5 * spacing_, spacing_);
  };
  const auto velocity_excess = [&](const std::vector<double>& values, const char* quantity) {
    return excess_of(values, velocity, quantity, "node", 0.0, spacing_);
  };
  auto found = stress_excess(solid_.stress_sum, "effective_stress");
  if (!found) found = stress_excess(fluid_.stress_sum, "pore_pressure");
  if (!found) found = velocity_excess(solid_.velocity_sum, "solid_velocity");
  if (!found) found = velocity_excess(fluid_.velocity_sum, "fluid_velocity");
  if (!found) return std::nullopt;
  return Breakdown{step_, fmt::format("step {}, t = {:.6g} s: {}", step_, time(), *found), dt_};
}

std::optional<Breakdown> StaggeredSolver::run() {
  while (step_ < steps_) {
    step();
    if (step_ % steps_between_checks != 0 && step_ < steps_) continue;
    if (auto found = find_breakdown()) return found;
  }
  return std::nullopt;
}

std::size_t StaggeredSolver::state_size() const {
  return 4 * cells_ + 2 + (correction_ ? 2 * cells_ + 2 : 0);
}

std::vector<double> StaggeredSolver::state() const {
  std::vector<double> state(state_size());
  double* next = state.data();
  for (const PhaseLines* lines : {&solid_, &fluid_}) {
    next = std::copy_n(lines->velocity_sum.data(), cells_ + 1, next);
  }
  for (const PhaseLines* lines : {&solid_, &fluid_}) {
    next = std::copy_n(lines->stress_sum.data() + 1, cells_, next);
  }
  if (!correction_) return state;
  next = std::copy_n(correction_->force_rates.solid.data(), cells_ + 1, next);
  std::copy_n(correction_->force_rates.fluid.data(), cells_ + 1, next);
  return state;
}

void StaggeredSolver::set_state(std::span<const double> state) {
  if (state.size() != state_size()) {
    throw std::invalid_argument("staggered solver: a state of the wrong length");
  }
  end_ = cells_ + 1;
  const double* next = state.data();
  const auto take = [&](std::size_t count, double* to) {
    std::copy_n(next, count, to);
    next += count;
  };
  for (PhaseLines* lines : {&solid_, &fluid_}) take(cells_ + 1, lines->velocity_sum.data());
  for (PhaseLines* lines : {&solid_, &fluid_}) take(cells_, lines->stress_sum.data() + 1);
  if (!correction_) return;
  take(cells_ + 1, correction_->force_rates.solid.data());
  take(cells_ + 1, correction_->force_rates.fluid.data());
}

Snapshot StaggeredSolver::snapshot() const {
  StaggeredSolver now(*this);
  now.reconstruct();
  if (step_ > 0) now.kick(StepPart::first_half);
  const auto cells_of = [](const std::vector<double>& stress) {
    return std::vector<double>(stress.begin() + 1, stress.end() - 1);
  };
  Snapshot snapshot;
  snapshot.time = time();
  snapshot.solid = now.solid_.points();
  snapshot.fluid = now.fluid_.points();
  snapshot.cell_x = regular_places(cells_, 0.5 * spacing_, spacing_);
  snapshot.node_x = regular_places(cells_ + 1, 0.0, spacing_);
  snapshot.effective_stress = cells_of(now.solid_.stress);
  snapshot.pore_pressure = cells_of(now.fluid_.stress);
  snapshot.solid_velocity = now.solid_.velocity;
  snapshot.fluid_velocity = now.fluid_.velocity;
  return snapshot;
}

}  // namespace porowave::solver
