#include "solver/moving/bar_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reference/problem/errors.hpp"
#include "solver/placement.hpp"
#include "solver/velocity_noise.hpp"

namespace porowave::solver {

namespace {

// See transfer.cpp: a point at exactly the support radius must not weigh anything by rounding.
constexpr double support_margin = 1e-10;

void check(bool good, const char* message) {
  if (!good) throw std::invalid_argument(std::string("bar solver: ") + message);
}

void check_choice(const Discretization& choice) {
  check(choice.transfer == TransferName::mls && choice.scheme == Scheme::galerkin,
        "expected transfer mls, scheme galerkin");
  check(!choice.adaptive_support, "an adaptive support is not offered");
  check(choice.empty_elements.empty(), "empty elements are not offered");
}

bool lies_on_node(double x, double spacing) {
  return std::abs(x / spacing - std::round(x / spacing)) < 1e-9;
}

}  // namespace

BarSolver::BarSolver(const Bar& bar, const Discretization& choice, double time_step, int xpic_order)
    : bar_(bar),
      spacing_((bar.far - bar.near) / choice.elements),
      time_step_(time_step),
      xpic_order_(xpic_order),
      recovered_(choice.strain == Strain::recovered),
      grid_(spacing_, bar.near, bar.far),
      node_rows_(choice.kernel, choice.support_radius * spacing_ * (1.0 - support_margin),
                 choice.basis_order),
      cell_rows_(node_rows_) {
  check_choice(choice);
  check(xpic_order >= 0 && xpic_order <= 10, "expected an order of XPIC from 0 to 10");
  check(bar.density > 0.0, "density must be positive");
  check((!bar.near_end.held || lies_on_node(bar.near, spacing_)) &&
            (!bar.far_end.held || lies_on_node(bar.far, spacing_)),
        "a held end must lie on a node");
  // A held end is the node itself, whatever the rounding of its place.
  const auto on_node = [&](double x) { return spacing_ * std::round(x / spacing_); };
  grid_ = FilledGrid(spacing_, bar.near_end.held ? on_node(bar.near) : bar.near,
                     bar.far_end.held ? on_node(bar.far) : bar.far);
  place_points(choice);
  check(time_step > 0.0 && courant() <= 1.0, "the step must be positive, the Courant number <= 1");
}

void BarSolver::place_points(const Discretization& choice) {
  PlacedPoints placed = solver::place_points(choice, spacing_, Phase::solid);
  for (double& x : placed.x) x += bar_.near;
  for (const double x : placed.x) x_.emplace_back(x);
  const std::vector<std::size_t> order = order_along(x_);
  reorder(order, x_);
  reorder(order, placed.volume);
  for (std::size_t p = 0; p < x_.size(); ++p) {
    const double x = x_[p][0];
    stretch_.push_back(bar_.initial_stretch ? bar_.initial_stretch(x) : 1.0);
    check(stretch_[p] > 0.0, "the initial stretch must be positive");
    stress_free_volume_.push_back(placed.volume[p] / stretch_[p]);
    mass_.push_back(bar_.density * stress_free_volume_[p]);
    stress_.push_back(stress(bar_.law, stretch_[p]));
    velocity_.push_back(bar_.initial_velocity ? bar_.initial_velocity(x, -0.5 * time_step_) : 0.0);
  }
  density_.resize(x_.size());
  moved_.assign(x_.size(), true);
}

double BarSolver::courant() const {
  double fastest = 0.0;
  for (const double f : stretch_) {
    const double c = wave_speed(bar_.law, f, bar_.density);
    if (!(c <= fastest)) fastest = c;  // keeps a NaN
  }
  return fastest * time_step_ / spacing_;
}

void BarSolver::renew_weights() {
  const std::vector<std::size_t> order = order_along(x_);
  if (!order.empty()) {
    reorder(order, x_);
    for (auto* values : {&mass_, &stress_free_volume_, &velocity_, &stretch_, &stress_}) {
      reorder(order, *values);
    }
    moved_.assign(x_.size(), true);
  }
  const MovedPoints moved(moved_);
  renewal_.points_moved = moved.count();
  renewal_.points_over_nodes = order_.renew(x_, spacing_, grid_.first_cell(), grid_.cell_count());
  std::vector<double> nodes;
  for (long i = grid_.first_inner(); i <= grid_.last_inner(); ++i) {
    nodes.push_back(grid_.node_position(i));
  }
  node_rows_.renew(grid_.first_inner(), nodes, x_, moved);
  std::vector<double> middles;
  for (long c = grid_.first_cell(); c < grid_.last_node(); ++c) {
    middles.push_back(grid_.filled_middle(c));
  }
  cell_rows_.renew(grid_.first_cell(), middles, x_, moved);
  renewal_.rows_renewed = node_rows_.renewed() + cell_rows_.renewed();
  renewal_.rows = nodes.size() + middles.size();
  moved_.assign(x_.size(), false);
}

// At all nodes: moving least squares at inner ones, ends held, outer nodes extended.
void BarSolver::read_velocity(std::span<const double> at_points, std::span<double> at_nodes) const {
  const auto inner = static_cast<std::size_t>(grid_.first_inner() - grid_.first_node());
  std::fill(at_nodes.begin(), at_nodes.end(), 0.0);
  node_rows_.multiply(at_points, at_nodes.subspan(inner));
  hold_ends(at_nodes);
  grid_.extend(at_nodes);
}

void BarSolver::hold_ends(std::span<double> nodal) const {
  // A held end lies on a node, so there is no outer one.
  if (bar_.near_end.held) nodal.front() = 0.0;
  if (bar_.far_end.held) nodal.back() = 0.0;
}

void BarSolver::remove_noise() {
  remove_velocity_noise([&](std::span<const double> points,
                            std::span<double> nodes) { read_velocity(points, nodes); },
                        [&](std::span<const double> nodes, std::span<double> points) {
                          for (std::size_t p = 0; p < points.size(); ++p)
                            points[p] = grid_.value(nodes, x_[p][0]);
                        },
                        xpic_order_, nodal_velocity_, velocity_);
}

void BarSolver::find_acceleration() {
  const double t = time();
  cell_stress_.resize(grid_.cell_count());
  cell_rows_.multiply(stress_, cell_stress_);
  for (std::size_t p = 0; p < x_.size(); ++p) {
    density_[p] = mass_[p] / (stretch_[p] * stress_free_volume_[p]);
  }
  const std::vector<double> volume = grid_.nodal_volume();
  const auto inner = static_cast<std::size_t>(grid_.first_inner() - grid_.first_node());
  nodal_density_.assign(grid_.node_count(), 0.0);
  node_rows_.multiply(density_, std::span(nodal_density_).subspan(inner));

  const auto stress_at = [t](const BarEnd& end) { return end.stress ? end.stress(t) : 0.0; };
  nodal_acceleration_.assign(grid_.node_count(), 0.0);
  grid_.internal_force(cell_stress_, stress_at(bar_.near_end), stress_at(bar_.far_end),
                       nodal_acceleration_);
  for (long i = grid_.first_inner(); i <= grid_.last_inner(); ++i) {
    const auto k = static_cast<std::size_t>(i - grid_.first_node());
    double force = nodal_acceleration_[k];
    if (bar_.body_force) force += volume[k] * bar_.body_force(grid_.node_position(i), t);
    nodal_acceleration_[k] = force / (nodal_density_[k] * volume[k]);
  }
  hold_ends(nodal_acceleration_);
  grid_.extend(nodal_acceleration_);
}

double BarSolver::strain_rate(double x) const {
  const auto of_cell = [&](long c) {
    const auto k = static_cast<std::size_t>(c - grid_.first_cell());
    return (nodal_velocity_[k + 1] - nodal_velocity_[k]) / spacing_;
  };
  const double t = x / spacing_;
  if (!recovered_) {
    return of_cell(
        std::clamp(std::lround(std::floor(t)), grid_.first_cell(), grid_.last_node() - 1));
  }
  // The line through the middles of two cells with inner nodes, the nearest ones to x.
  const long c =
      std::clamp(std::lround(std::floor(t - 0.5)), grid_.first_inner(), grid_.last_inner() - 2);
  const double share = t - 0.5 - static_cast<double>(c);
  return (1.0 - share) * of_cell(c) + share * of_cell(c + 1);
}

void BarSolver::move_points() {
  const auto moved_place = [&](double x) {
    return x + time_step_ * grid_.value(nodal_velocity_, x);
  };
  for (std::size_t p = 0; p < x_.size(); ++p) {
    const double x = x_[p][0];
    x_[p][0] = moved_place(x);
    moved_[p] = x_[p][0] != x;
    stretch_[p] *= 1.0 + time_step_ * strain_rate(x);
    stress_[p] = stress(bar_.law, stretch_[p]);
  }
  const double near = bar_.near_end.held ? grid_.near() : moved_place(grid_.near());
  const double far = bar_.far_end.held ? grid_.far() : moved_place(grid_.far());
  ++step_;
  check_stretch();
  grid_ = FilledGrid(spacing_, near, far);
}

void BarSolver::check_stretch() const {
  for (std::size_t p = 0; p < x_.size(); ++p) {
    if (stretch_[p] > 0.0 && std::isfinite(stretch_[p]) && std::isfinite(x_[p][0])) continue;
    throw BreakdownError(fmt::format(
        "step {}, t = {:.6g} s: stretch = {:g} at x = {:.6g} m, which is no positive number; "
        "try a smaller time step",
        step_, time(), stretch_[p], x_[p][0]));
  }
}

void BarSolver::find_nodal_state() {
  renew_weights();
  nodal_velocity_.resize(grid_.node_count());
  read_velocity(velocity_, nodal_velocity_);
  find_acceleration();
}

void BarSolver::accelerate(double duration) {
  for (std::size_t k = 0; k < nodal_velocity_.size(); ++k) {
    nodal_velocity_[k] += duration * nodal_acceleration_[k];
  }
  for (std::size_t p = 0; p < x_.size(); ++p) {
    velocity_[p] += duration * grid_.value(nodal_acceleration_, x_[p][0]);
  }
}

void BarSolver::step() {
  find_nodal_state();
  if (xpic_order_ > 0) remove_noise();
  accelerate(time_step_);
  move_points();
}

BarSnapshot BarSolver::snapshot() const {
  BarSolver now(*this);
  now.find_nodal_state();
  now.accelerate(0.5 * time_step_);
  BarSnapshot s;
  s.time = time();
  s.near = grid_.near();
  s.far = grid_.far();
  for (std::size_t p = 0; p < now.x_.size(); ++p) {
    s.x.push_back(now.x_[p][0]);
    s.volume.push_back(now.stretch_[p] * now.stress_free_volume_[p]);
  }
  s.velocity = std::move(now.velocity_);
  s.stretch = std::move(now.stretch_);
  s.stress = std::move(now.stress_);
  for (long c = grid_.first_cell(); c < grid_.last_node(); ++c) {
    s.cell_x.push_back(grid_.filled_middle(c));
    s.cell_length.push_back(grid_.filled_length(c));
  }
  s.cell_stress = std::move(now.cell_stress_);
  for (long i = grid_.first_inner(); i <= grid_.last_inner(); ++i) {
    s.node_x.push_back(grid_.node_position(i));
    s.node_velocity.push_back(
        now.nodal_velocity_[static_cast<std::size_t>(i - grid_.first_node())]);
  }
  return s;
}

}  // namespace porowave::solver
