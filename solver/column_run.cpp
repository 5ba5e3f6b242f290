// Running to the end, and looking at a run: the parts of ColumnSolver that are no steps.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "solver/column_solver.hpp"

namespace porowave::solver {

namespace {

constexpr double growth_limit = 1e6;
constexpr long steps_between_checks = 16;

std::vector<double> coordinates(const PointSet<1>& points) {
  std::vector<double> x;
  x.reserve(points.x.size());
  for (const Vector<1>& position : points.x) x.push_back(position[0]);
  return x;
}

// A value beyond its limits.
struct Excess {
  Phase phase;
  std::size_t point;
  std::string words;  // quantity and value; where; what is wrong with it
};

// The worst of the points' values: the largest, or of those that are not finite the one in the
// middle, as they spread to both sides.
std::optional<Excess> worst_of(const std::vector<double>& values, const PointSet<1>& points,
                               double limit, Phase phase, const char* quantity) {
  std::vector<std::size_t> not_finite;
  std::size_t worst = values.size();
  for (std::size_t p = 0; p < values.size(); ++p) {
    if (std::abs(values[p]) <= limit) continue;  // false for NaN
    if (!std::isfinite(values[p])) not_finite.push_back(p);
    if (worst == values.size() || std::abs(values[p]) > std::abs(values[worst])) worst = p;
  }
  if (worst == values.size()) return std::nullopt;
  std::string what = "more than 1e6 times the load";
  if (!not_finite.empty()) {
    worst = not_finite[not_finite.size() / 2];
    what = fmt::format("not a finite number, as at {} points in all", not_finite.size());
  }
  return Excess{
      phase, worst,
      fmt::format("{} = {:g} at x = {:.6g} m, {} point {}: {}", quantity, values[worst],
                  points.x[worst][0], phase == Phase::solid ? "solid" : "fluid", worst, what)};
}

// A solid under a pressure of its modulus has no length left, and its points overtake each other.
std::optional<Excess> inverted_of(const std::vector<double>& stress, const PointSet<1>& points,
                                  double modulus) {
  const auto least = std::min_element(stress.begin(), stress.end());
  if (least == stress.end() || *least > -modulus) return std::nullopt;
  const auto p = static_cast<std::size_t>(least - stress.begin());
  return Excess{Phase::solid, p,
                fmt::format("effective_stress = {:g} at x = {:.6g} m, solid point {}: points are "
                            "inverted, the strain is {:.3g}",
                            *least, points.x[p][0], p, *least / modulus)};
}

// How far points are from where they started, at most, m. They do not overtake each other.
double largest_distance(const PointSet<1>& points, const PlacedPoints& start) {
  std::vector<double> x = start.x;
  std::sort(x.begin(), x.end());
  double largest = 0.0;
  for (std::size_t p = 0; p < x.size(); ++p) {
    largest = std::max(largest, std::abs(points.x[p][0] - x[p]));
  }
  return largest;
}

double largest_size(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

// Without a branch, which lets the loop be vectorised; false for NaN.
bool bounded(std::span<const double> values, double limit) {
  std::size_t outside = 0;
  for (const double value : values) outside += std::abs(value) <= limit ? 0 : 1;
  return outside == 0;
}

}  // namespace

// What eliminates the points knows of the load only, and so does what is left out ahead of it.
void ColumnSolver::drive_otherwise() {
  if (step_ > 0) throw std::invalid_argument("column solver: the run has begun");
  if (scene_.time.path == StepPath::frozen) {
    throw std::invalid_argument(
        "column solver: path = \"frozen\" is for runs that only their load drives; "
        "expected \"auto\" or \"points\"");
  }
  thaw();
  only_loaded_ = false;
  disregard_causality();
}

void ColumnSolver::set_body_force(BodyForce force) {
  drive_otherwise();
  body_force_ = std::move(force);
}

void ColumnSolver::start_from(const std::function<Fields(double x, double t)>& fields) {
  if (scene_.discretization.transfer == TransferName::apic) {
    throw std::invalid_argument("column solver: points of apic start at rest");
  }
  drive_otherwise();
  has_past_ = true;
  for (PhaseState* state : {&solid_, &fluid_}) {
    const bool is_solid = state == &solid_;
    for (std::size_t p = 0; p < state->points.x.size(); ++p) {
      const double x = state->points.x[p][0];
      const Fields before = fields(x, -0.5 * dt_);
      const Fields now = fields(x, 0.0);
      state->values.velocity[p] = is_solid ? before.solid_velocity : before.fluid_velocity;
      state->values.stress[p] = is_solid ? now.effective_stress : now.pore_pressure;
    }
  }
}

// Where nothing was before t = 0, the first step feels the force for its second half only.
void ColumnSolver::add_body_force(IndexRange nodes, double* effective, double* pressure) const {
  const double share = step_ > 0 || has_past_ ? 1.0 : 0.5;
  solver::add_body_force(body_force_, time(), share, scene_.problem.material, grid_,
                         {solid_.nodes.volume, fluid_.nodes.volume}, nodes, effective, pressure);
}

// Beyond the window all is at rest. Points that are eliminated have at most the values of nodes,
// and twice those of cells.
bool ColumnSolver::surely_bounded(double velocity, double effective, double pressure) const {
  const IndexRange cells{
      0, points_moved_ ? node_count_ - 1 : std::min(window_.nodes, node_count_ - 1)};
  if (frozen_) {
    const auto q = frozen_->node_values();
    const auto e = frozen_->cell_values();
    const double stress = 0.5 * std::min(effective, pressure);
    return bounded(q[0].first(window_.nodes), velocity) &&
           bounded(q[1].first(window_.nodes), velocity) &&
           bounded(e[0].first(cells.size()), stress) && bounded(e[1].first(cells.size()), stress);
  }
  const auto all_bounded = [&](const PhaseState& phase, double stress) {
    const IndexRange points = phase.prepared.operators->points_of(cells);
    const auto among = [&](const std::vector<double>& values) {
      return std::span(values).subspan(points.first, points.size());
    };
    return bounded(among(phase.values.stress), stress) &&
           bounded(among(phase.values.velocity), velocity);
  };
  return all_bounded(solid_, effective) && all_bounded(fluid_, pressure);
}

std::optional<Breakdown> ColumnSolver::find_breakdown() const {
  constexpr double finite = std::numeric_limits<double>::max();
  const double modulus = only_loaded_ ? scene_.problem.material.constrained_modulus : finite;
  const double stress = only_loaded_ ? growth_limit * scene_.problem.stress_scale() : finite;
  const double velocity = only_loaded_ ? growth_limit * scene_.problem.velocity_scale() : finite;
  if (surely_bounded(velocity, std::min(stress, modulus), stress)) return std::nullopt;
  if (frozen_) {
    ColumnSolver now(*this);
    now.thaw();
    return now.find_breakdown();
  }
  const auto check = [&](const auto& values, Phase phase, double limit, const char* quantity) {
    return worst_of(values, state_of(phase).points, limit, phase, quantity);
  };
  auto found = check(solid_.values.stress, Phase::solid, stress, "effective_stress");
  if (!found) found = check(fluid_.values.stress, Phase::fluid, stress, "pore_pressure");
  if (!found) found = check(solid_.values.velocity, Phase::solid, velocity, "solid_velocity");
  if (!found) found = check(fluid_.values.velocity, Phase::fluid, velocity, "fluid_velocity");
  if (!found) found = inverted_of(solid_.values.stress, solid_.points, modulus);
  if (!found) return std::nullopt;
  const PhaseState& state = state_of(found->phase);
  const double moved = largest_distance(state.points, place_points(scene_.discretization,
                                                                   grid_.spacing, found->phase)) +
                       largest_size(state.displacement);
  return Breakdown{step_, fmt::format("step {}, t = {:.6g} s: {}", step_, time(), found->words),
                   dt_, moved};
}

Breakdown ColumnSolver::moved_too_far() const {
  double stress = 0.0;
  for (const double s : solid_.values.stress) stress = std::max(stress, std::abs(s));
  return {step_,
          fmt::format("step {}, t = {:.6g} s: displacement is more than {:g} of an element, "
                      "which path = \"frozen\" does not allow (effective_stress is up to "
                      "{:g} times the load); expected path = \"auto\" or \"points\"",
                      step_, time(), reweight_share, stress / scene_.problem.stress_scale())};
}

std::optional<Breakdown> ColumnSolver::run() {
  while (step_ < steps_) {
    advance(std::min(steps_, (step_ / steps_between_checks + 1) * steps_between_checks));
    if (held_up()) return moved_too_far();
    if (auto found = find_breakdown()) return found;
  }
  return std::nullopt;
}

void ColumnSolver::synchronise_velocities() {
  const double t = time();
  const double before = t - 0.5 * dt_;
  const double ns = scene_.problem.material.solid_fraction();
  const double nf = scene_.problem.material.porosity;
  std::vector<double> pressure_force(node_count_);
  fluid_.prepared.operators->gather(fluid_.values, {0, node_count_}, fluid_.nodes.velocity.data(),
                                    pressure_force.data());
  solid_.prepared.operators->gather(solid_.values, {0, node_count_}, solid_.nodes.velocity.data(),
                                    solid_.nodes.force.data());
  if (body_force_) {
    add_body_force({0, node_count_}, solid_.nodes.force.data(), pressure_force.data());
  }
  // f_s = −∫ ∂N (σ′ − n_s p), f_f = −∫ ∂N (−n_f p); p is integrated over the fluid's points.
  for (std::size_t i = 0; i < node_count_; ++i) {
    solid_.nodes.force[i] -= ns * pressure_force[i];
    fluid_.nodes.force[i] = -nf * pressure_force[i];
  }
  update_nodes(scene_.problem, load_between(before, t), 0.5 * dt_, solid_.nodes, fluid_.nodes);
  for (PhaseState* state : {&solid_, &fluid_}) {
    std::vector<double> increment(node_count_);
    for (std::size_t i = 0; i < node_count_; ++i) {
      increment[i] = state->nodes.new_velocity[i] - state->nodes.velocity[i];
    }
    std::vector<double> change(state->points.x.size());
    state->prepared.operators->to_points(increment.data(), change.data());
    for (std::size_t p = 0; p < change.size(); ++p) state->values.velocity[p] += change[p];
  }
}

Snapshot ColumnSolver::snapshot() const {
  ColumnSolver now(*this);
  now.thaw();
  if (step_ > 0 || has_past_) now.synchronise_velocities();
  now.move_points();
  const auto points_of = [](PhaseState& state) {
    return PhasePoints{coordinates(state.points), std::move(state.points.volume),
                       std::move(state.values.velocity), std::move(state.values.stress)};
  };
  Snapshot snapshot;
  snapshot.time = time();
  snapshot.solid = points_of(now.solid_);
  snapshot.fluid = points_of(now.fluid_);
  snapshot.effective_stress = solid_.prepared.operators->at_cell_centres(snapshot.solid.stress);
  snapshot.pore_pressure = fluid_.prepared.operators->at_cell_centres(snapshot.fluid.stress);
  snapshot.solid_velocity = std::move(now.solid_.nodes.new_velocity);
  snapshot.fluid_velocity = std::move(now.fluid_.nodes.new_velocity);
  for (int c = 0; c < grid_.cell_count(); ++c) snapshot.cell_x.push_back(grid_.cell_centre(c)[0]);
  for (int i = 0; i < grid_.node_count(); ++i) snapshot.node_x.push_back(grid_.node_position(i)[0]);
  return snapshot;
}

}  // namespace porowave::solver
