#include "solver/column_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "reference/problem/errors.hpp"
#include "solver/particle_domain.hpp"
#include "solver/velocity_noise.hpp"

namespace porowave::solver {

namespace {

constexpr double growth_limit = 1e6;
constexpr long steps_between_checks = 16;
// A half-space ends this much beyond what the fast wave can reach.
constexpr double half_space_margin = 1.05;

Grid<1> make_grid(double length, int elements) {
  return {Vector<1>(0.0), length / elements, CellIndex<1>(elements)};
}

long step_count(const Case& scene, double spacing) {
  const double stable = scene.time.courant * spacing / wave_speeds(scene.problem.material).p1;
  return std::max(1L, std::lround(std::ceil(scene.time.end / stable * (1.0 - 1e-12))));
}

std::vector<double> coordinates(const PointSet<1>& points) {
  std::vector<double> x;
  x.reserve(points.x.size());
  for (const Vector<1>& position : points.x) x.push_back(position[0]);
  return x;
}

std::optional<Breakdown> worst_of(const std::vector<double>& values, const PointSet<1>& points,
                                  double limit, const char* quantity, long step, double time) {
  for (std::size_t p = 0; p < values.size(); ++p) {
    if (std::abs(values[p]) <= limit) continue;  // false for NaN
    return Breakdown{step, fmt::format("step {}, t = {:.6g} s: {} = {:g} at x = {:.6g} m: {}", step,
                                       time, quantity, values[p], points.x[p][0],
                                       std::isfinite(values[p])
                                           ? "more than 1e6 times the load; try a smaller courant"
                                           : "not a finite number; try a smaller courant")};
  }
  return std::nullopt;
}

}  // namespace

ColumnSolver::PhaseState ColumnSolver::start(const Discretization& choice, double spacing,
                                             Phase phase, double density) {
  const PlacedPoints placed = place_points(choice, spacing, phase);
  PhaseState state;
  for (std::size_t p = 0; p < placed.x.size(); ++p) {
    state.points.x.emplace_back(placed.x[p]);
    state.points.mass.push_back(density * placed.volume[p]);
  }
  state.points.volume = placed.volume;
  state.points.domain = placed.volume;
  state.velocity.assign(placed.x.size(), 0.0);
  state.stress.assign(placed.x.size(), 0.0);
  if (choice.transfer == TransferName::apic) state.velocity_gradient = state.stress;
  return state;
}

ColumnSolver::ColumnSolver(const Case& scene)
    : scene_(scene),
      grid_(make_grid(grid_length(scene), scene.discretization.elements)),
      dt_(0.0),
      steps_(step_count(scene, grid_.spacing)),
      solid_(start(scene.discretization, grid_.spacing, Phase::solid,
                   scene.problem.material.solid_partial_density())),
      fluid_(start(scene.discretization, grid_.spacing, Phase::fluid,
                   scene.problem.material.fluid_partial_density())) {
  dt_ = scene.time.end / static_cast<double>(steps_);
  const auto nodes = static_cast<std::size_t>(grid_.node_count());
  solid_nodes_.resize(nodes);
  fluid_nodes_.resize(nodes);
  increment_.resize(nodes);
  solid_displacement_.assign(nodes, 0.0);
  fluid_displacement_.assign(nodes, 0.0);
  make_weights();
  const bool needs_both = scene.problem.column.near != NearEnd::velocity;
  if (needs_both && (solid_nodes_.mass[0] <= 0.0 || fluid_nodes_.mass[0] <= 0.0)) {
    throw BreakdownError(
        "step 0: no point within reach of the loaded end x = 0, nodal mass = 0; "
        "more points per element or a larger support_radius would reach it");
  }
}

double ColumnSolver::grid_length(const Case& scene) {
  if (scene.problem.column.length) return *scene.problem.column.length;
  return half_space_margin * wave_speeds(scene.problem.material).p1 * scene.time.end;
}

std::size_t ColumnSolver::point_count() const {
  return solid_.points.x.size() + fluid_.points.x.size();
}

std::size_t ColumnSolver::reduced_rows() const {
  return solid_.transfer->reduced_rows() + fluid_.transfer->reduced_rows();
}

std::size_t ColumnSolver::empty_rows() const {
  return solid_.transfer->empty_rows() + fluid_.transfer->empty_rows();
}

void ColumnSolver::make_weights() {
  for (auto [state, nodes] :
       {std::pair(&solid_, &solid_nodes_), std::pair(&fluid_, &fluid_nodes_)}) {
    state->transfer = std::make_shared<Transfer<1>>(state->points, grid_, scene_.discretization);
    nodes->mass = state->transfer->nodal_mass();
    nodes->volume = state->transfer->nodal_volume();
  }
}

void ColumnSolver::move_points() {
  if (convects_domains(scene_.discretization.shape)) {
    for (PhaseState* state : {&solid_, &fluid_}) {
      stretch_domains(*state->transfer, solid_displacement_, state->points.domain);
    }
  }
  for (auto [state, displacement] :
       {std::pair(&solid_, &solid_displacement_), std::pair(&fluid_, &fluid_displacement_)}) {
    at_points_.resize(state->velocity.size());
    state->transfer->to_points(*displacement, at_points_);
    for (std::size_t p = 0; p < at_points_.size(); ++p) state->points.x[p][0] += at_points_[p];
    std::fill(displacement->begin(), displacement->end(), 0.0);
  }
}

void ColumnSolver::nodal_velocities_and_forces() {
  const double ns = scene_.problem.material.solid_fraction();
  const double nf = scene_.problem.material.porosity;
  solid_.transfer->to_nodes(solid_.velocity, solid_nodes_.velocity);
  fluid_.transfer->to_nodes(fluid_.velocity, fluid_nodes_.velocity);
  solid_.transfer->add_affine(solid_.velocity_gradient, 0, solid_nodes_.velocity);
  fluid_.transfer->add_affine(fluid_.velocity_gradient, 0, fluid_nodes_.velocity);
  solid_.transfer->to_quadrature(solid_.stress, solid_.quadrature);
  fluid_.transfer->to_quadrature(fluid_.stress, fluid_.quadrature);
  std::fill(solid_nodes_.force.begin(), solid_nodes_.force.end(), 0.0);
  std::fill(fluid_nodes_.force.begin(), fluid_nodes_.force.end(), 0.0);
  // f_s = −∫ ∂N (σ′ − n_s p), f_f = −∫ ∂N (−n_f p); p is integrated over the fluid's points.
  solid_.transfer->add_divergence(solid_.quadrature, -1.0, 0, solid_nodes_.force);
  fluid_.transfer->add_divergence(fluid_.quadrature, ns, 0, solid_nodes_.force);
  fluid_.transfer->add_divergence(fluid_.quadrature, nf, 0, fluid_nodes_.force);
}

void ColumnSolver::step() {
  const double t = time();
  nodal_velocities_and_forces();
  const Load& load = scene_.problem.load;
  const double before = t - 0.5 * dt_;
  const double after = t + 0.5 * dt_;
  update_nodes(scene_.problem, {load.mean(before, after), load.value(before), load.value(after)},
               dt_, solid_nodes_, fluid_nodes_);
  update_points();
  ++step_;
}

void ColumnSolver::update_points() {
  const double flip = scene_.time.flip;
  double largest = 0.0;
  for (auto [state, nodes, displacement] :
       {std::tuple(&solid_, &solid_nodes_, &solid_displacement_),
        std::tuple(&fluid_, &fluid_nodes_, &fluid_displacement_)}) {
    // v_p ← flip (v_p + N Δv) + (1 − flip) N v
    for (std::size_t i = 0; i < increment_.size(); ++i) {
      increment_[i] = nodes->new_velocity[i] - flip * nodes->velocity[i];
      (*displacement)[i] += dt_ * nodes->new_velocity[i];
      largest = std::max(largest, std::abs((*displacement)[i]));
    }
    at_points_.resize(state->velocity.size());
    if (scene_.time.xpic_order > 0) {
      remove_velocity_noise(*state->transfer, scene_.time.xpic_order, nodes->velocity,
                            state->velocity);
    }
    if (!state->velocity_gradient.empty()) {
      state->transfer->gradient_at_points(nodes->new_velocity, 0, state->velocity_gradient);
    }
    state->transfer->to_points(increment_, at_points_);
    for (std::size_t p = 0; p < at_points_.size(); ++p) {
      state->velocity[p] = flip * state->velocity[p] + at_points_[p];
    }
  }

  const Material& m = scene_.problem.material;
  at_points_.resize(solid_.stress.size());
  solid_.transfer->gradient_at_points(solid_nodes_.new_velocity, 0, at_points_);
  for (std::size_t p = 0; p < at_points_.size(); ++p) {
    solid_.stress[p] += dt_ * m.constrained_modulus * at_points_[p];
  }
  // ṗ = −K (n_s ∂v_s + n_f ∂v_f), both gradients at the fluid's points.
  for (std::size_t i = 0; i < increment_.size(); ++i) {
    increment_[i] = m.solid_fraction() * solid_nodes_.new_velocity[i] +
                    m.porosity * fluid_nodes_.new_velocity[i];
  }
  at_points_.resize(fluid_.stress.size());
  fluid_.transfer->gradient_at_points(increment_, 0, at_points_);
  for (std::size_t p = 0; p < at_points_.size(); ++p) {
    fluid_.stress[p] -= dt_ * m.storage_modulus() * at_points_[p];
  }

  if (largest > reweight_share * grid_.spacing) {
    move_points();
    make_weights();
  }
}

std::optional<Breakdown> ColumnSolver::find_breakdown() const {
  const double stress = growth_limit * scene_.problem.stress_scale();
  const double velocity = growth_limit * scene_.problem.velocity_scale();
  const auto check = [&](const auto& values, const PhaseState& state, double limit,
                         const char* quantity) {
    return worst_of(values, state.points, limit, quantity, step_, time());
  };
  if (auto found = check(solid_.stress, solid_, stress, "effective_stress")) return found;
  if (auto found = check(fluid_.stress, fluid_, stress, "pore_pressure")) return found;
  if (auto found = check(solid_.velocity, solid_, velocity, "solid_velocity")) return found;
  return check(fluid_.velocity, fluid_, velocity, "fluid_velocity");
}

std::optional<Breakdown> ColumnSolver::run() {
  while (step_ < steps_) {
    step();
    if (step_ % steps_between_checks != 0 && step_ < steps_) continue;
    if (auto found = find_breakdown()) return found;
  }
  return std::nullopt;
}

void ColumnSolver::synchronise_velocities() {
  const double t = time();
  const double before = t - 0.5 * dt_;
  nodal_velocities_and_forces();
  const Load& load = scene_.problem.load;
  update_nodes(scene_.problem, {load.mean(before, t), load.value(before), load.value(t)}, 0.5 * dt_,
               solid_nodes_, fluid_nodes_);
  for (auto [state, nodes] :
       {std::pair(&solid_, &solid_nodes_), std::pair(&fluid_, &fluid_nodes_)}) {
    for (std::size_t i = 0; i < increment_.size(); ++i) {
      increment_[i] = nodes->new_velocity[i] - nodes->velocity[i];
    }
    at_points_.resize(state->velocity.size());
    state->transfer->to_points(increment_, at_points_);
    for (std::size_t p = 0; p < at_points_.size(); ++p) state->velocity[p] += at_points_[p];
  }
}

Snapshot ColumnSolver::snapshot() const {
  ColumnSolver now(*this);
  if (step_ > 0) now.synchronise_velocities();
  now.move_points();
  const auto points_of = [](const PhaseState& state) {
    return PhasePoints{coordinates(state.points), state.points.volume, state.velocity,
                       state.stress};
  };
  Snapshot snapshot;
  snapshot.time = time();
  snapshot.solid = points_of(now.solid_);
  snapshot.fluid = points_of(now.fluid_);
  snapshot.effective_stress = solid_.transfer->at_cell_centres(solid_.stress);
  snapshot.pore_pressure = fluid_.transfer->at_cell_centres(fluid_.stress);
  snapshot.solid_velocity = now.solid_nodes_.new_velocity;
  snapshot.fluid_velocity = now.fluid_nodes_.new_velocity;
  for (int c = 0; c < grid_.cell_count(); ++c) snapshot.cell_x.push_back(grid_.cell_centre(c)[0]);
  for (int i = 0; i < grid_.node_count(); ++i) snapshot.node_x.push_back(grid_.node_position(i)[0]);
  return snapshot;
}

}  // namespace porowave::solver
