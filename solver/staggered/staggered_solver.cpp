#include "solver/staggered/staggered_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

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

long step_count(const Case& scene, double spacing) {
  const double stable = scene.time.courant * spacing / wave_speeds(scene.problem.material).p1;
  return std::max(1L, std::lround(std::ceil(scene.time.end / stable * (1.0 - 1e-12))));
}

// (1 − e^−z)/z for z >= 0
double phi_1(double z) {
  return z > 1e-8 ? -std::expm1(-z) / z : 1.0 - 0.5 * z;
}

// The increments of both velocities at a free node are linear in the forces per volume and in the
// relative velocity w = v_f − v_s: the sum of momenta gets the sum of forces, w gets
// Δw = w (e^−θ − 1) + dt φ_1(θ) (f_f/ρ_f − f_s/ρ_s), the exact drag for constant forces.
struct FreeKick {
  double solid_by_solid, solid_by_fluid, solid_by_relative;
  double fluid_by_solid, fluid_by_fluid, fluid_by_relative;

  FreeKick(const Material& m, double dt) {
    const double solid = m.solid_partial_density();
    const double fluid = m.fluid_partial_density();
    const double share = fluid / (solid + fluid);
    const double theta = m.relaxation_rate() * dt;
    const double gain = dt * phi_1(theta);
    const double common = dt / (solid + fluid);
    solid_by_solid = common + share * gain / solid;
    solid_by_fluid = common - share * gain / fluid;
    solid_by_relative = -share * std::expm1(-theta);
    fluid_by_solid = common - (1.0 - share) * gain / solid;
    fluid_by_fluid = common + (1.0 - share) * gain / fluid;
    fluid_by_relative = (1.0 - share) * std::expm1(-theta);
  }
};

struct MovedPhase {
  const double* __restrict force;
  double* __restrict velocity;
  double* __restrict sum;
};

void kick_free_nodes(const FreeKick& k, const MovedPhase& s, const MovedPhase& f, std::size_t first,
                     std::size_t end) {
  for (std::size_t i = first; i < end; ++i) {
    const double w = f.velocity[i] - s.velocity[i];
    const double ds =
        k.solid_by_solid * s.force[i] + k.solid_by_fluid * f.force[i] + k.solid_by_relative * w;
    const double df =
        k.fluid_by_solid * s.force[i] + k.fluid_by_fluid * f.force[i] + k.fluid_by_relative * w;
    s.velocity[i] += ds;
    f.velocity[i] += df;
    s.sum[i] += ds;
    f.sum[i] += df;
  }
}

std::optional<Breakdown> worst_of(const std::vector<double>& values, double limit,
                                  const char* quantity, double first, double spacing, long step,
                                  double time) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (std::abs(values[k]) <= limit) continue;  // false for NaN
    return Breakdown{
        step,
        fmt::format("step {}, t = {:.6g} s: {} = {:g} at x = {:.6g} m: {}", step, time, quantity,
                    values[k], first + spacing * static_cast<double>(k),
                    std::isfinite(values[k]) ? "more than 1e6 times the load; try a smaller courant"
                                             : "not a finite number; try a smaller courant")};
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
      end_(std::min(cells_ + 1, window_growth)) {
  dt_ = scene.time.end / static_cast<double>(steps_);
  for (auto* values : {&forces_.solid, &forces_.fluid, &solid_slopes_, &fluid_slopes_}) {
    values->assign(cells_ + 1, 0.0);
  }
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

void StaggeredSolver::find_forces() {
  solid_.stress_slopes(solid_.stress, solid_slopes_, end_);
  fluid_.stress_slopes(fluid_.stress, fluid_slopes_, end_);
  const double ns = scene_.problem.material.solid_fraction();
  const double nf = scene_.problem.material.porosity;
  for (std::size_t i = 0; i < end_; ++i) {
    forces_.solid[i] = solid_slopes_[i] - ns * fluid_slopes_[i];
    forces_.fluid[i] = -nf * fluid_slopes_[i];
  }
}

void StaggeredSolver::kick(const StepLoad& load, double dt) {
  prescribe_stresses(solid_.stress, fluid_.stress, load.mean);
  find_forces();
  const auto moved = [](const std::vector<double>& force, PhaseLines& lines) {
    return MovedPhase{force.data(), lines.velocity.data(), lines.velocity_sum.data()};
  };
  kick_free_nodes(FreeKick(scene_.problem.material, dt), moved(forces_.solid, solid_),
                  moved(forces_.fluid, fluid_), 1, std::min(end_, cells_));
  kick_ends(load, dt);
}

// The two ends as a grid of two nodes of unit volume. A traction already is in the forces.
void StaggeredSolver::kick_ends(const StepLoad& load, double dt) {
  const std::array<std::size_t, 2> nodes{0, cells_};
  PhaseNodes s;
  PhaseNodes f;
  s.resize(2);
  f.resize(2);
  for (std::size_t e = 0; e < 2; ++e) {
    s.mass[e] = scene_.problem.material.solid_partial_density();
    f.mass[e] = scene_.problem.material.fluid_partial_density();
    s.volume[e] = f.volume[e] = 1.0;
    s.velocity[e] = solid_.velocity[nodes[e]];
    f.velocity[e] = fluid_.velocity[nodes[e]];
    s.force[e] = forces_.solid[nodes[e]];
    f.force[e] = forces_.fluid[nodes[e]];
  }
  update_nodes(scene_.problem, {0.0, load.before, load.after}, dt, s, f);
  for (std::size_t e = 0; e < 2; ++e) {
    solid_.velocity[nodes[e]] = s.new_velocity[e];
    fluid_.velocity[nodes[e]] = f.new_velocity[e];
    solid_.velocity_sum[nodes[e]] += s.new_velocity[e] - s.velocity[e];
    fluid_.velocity_sum[nodes[e]] += f.new_velocity[e] - f.velocity[e];
  }
}

void StaggeredSolver::drift() {
  const Material& m = scene_.problem.material;
  const std::size_t cells = std::min(end_, cells_);
  solid_.velocity_slopes(solid_.velocity, solid_slopes_, cells);
  fluid_.velocity_slopes(fluid_.velocity, fluid_slopes_, cells);
  const double elastic = dt_ * m.constrained_modulus;
  const double by_solid = dt_ * m.storage_modulus() * m.solid_fraction();
  const double by_fluid = dt_ * m.storage_modulus() * m.porosity;
  double* effective_stress = solid_.stress_sum.data() + 1;
  double* pressure = fluid_.stress_sum.data() + 1;
  for (std::size_t c = 0; c < cells; ++c) {
    effective_stress[c] += elastic * solid_slopes_[c];
    pressure[c] -= by_solid * solid_slopes_[c] + by_fluid * fluid_slopes_[c];
  }
  for (std::size_t i = 0; i < end_; ++i) {
    solid_.displacement[i] += dt_ * solid_.velocity[i];
    fluid_.displacement[i] += dt_ * fluid_.velocity[i];
  }
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
  const Load& load = scene_.problem.load;
  const double before = time() - 0.5 * dt_;
  const double after = time() + 0.5 * dt_;
  reconstruct();
  kick({load.mean(before, after), load.value(before), load.value(after)}, dt_);
  drift();
  widen_window();
  ++step_;
}

std::optional<Breakdown> StaggeredSolver::find_breakdown() const {
  const double stress = growth_limit * scene_.problem.stress_scale();
  const double velocity = growth_limit * scene_.problem.velocity_scale();
  const auto check = [&](const auto& values, double limit, const char* quantity, double first) {
    return worst_of(values, limit, quantity, first, spacing_, step_, time());
  };
  const double middle = -0.5 * spacing_;  // of the cell before the first
  if (auto found = check(solid_.stress_sum, stress, "effective_stress", middle)) return found;
  if (auto found = check(fluid_.stress_sum, stress, "pore_pressure", middle)) return found;
  if (auto found = check(solid_.velocity_sum, velocity, "solid_velocity", 0.0)) return found;
  return check(fluid_.velocity_sum, velocity, "fluid_velocity", 0.0);
}

std::optional<Breakdown> StaggeredSolver::run() {
  while (step_ < steps_) {
    step();
    if (step_ % steps_between_checks != 0 && step_ < steps_) continue;
    if (auto found = find_breakdown()) return found;
  }
  return std::nullopt;
}

Snapshot StaggeredSolver::snapshot() const {
  StaggeredSolver now(*this);
  now.reconstruct();
  if (step_ > 0) {
    const Load& load = scene_.problem.load;
    const double before = time() - 0.5 * dt_;
    now.kick({load.mean(before, time()), load.value(before), load.value(time())}, 0.5 * dt_);
  }
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
