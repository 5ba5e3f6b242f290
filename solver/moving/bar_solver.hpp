#pragma once

// A bar whose points move far across the grid, in finite strain, by moving least squares (the
// transfer `mls` of transfer.hpp, for one phase). One step, in the order of the code:
//
//   1. order of the points, filled cells, weights: only what has moved
//   2. velocity and density at the nodes, stress in the middle of the filled part of every cell
//   3. internal force, ends, body force; momentum at the nodes
//   4. velocities, positions and stretch of the points, F ← F (1 + Δt ∂v/∂x); volumes V = F V_0
//   5. stress of the points from F
//
// The grid is endless and only cells that the bar touches exist. It is tied to the bar for the
// length of a step (updated Lagrangian), so there is no convective term. Velocities stand at half
// steps, positions and stresses at full steps; second order in time. FLIP, or XPIC
// (velocity_noise.hpp), which removes the noise that FLIP keeps.
//
// Ends may lie anywhere in a cell (filled_grid.hpp); they move with the nodal velocity like points.
//
// Limits: one phase, one dimension, transfer mls with fixed support, ends free, loaded or held at
// rest. The porous column in finite strain is not offered: its porosity would change.

#include <vector>

#include "solver/case.hpp"
#include "solver/moving/bar.hpp"
#include "solver/moving/cell_order.hpp"
#include "solver/moving/filled_grid.hpp"
#include "solver/moving/moving_rows.hpp"

namespace porowave::solver {

// The bar at one time: its points, and the fields reconstructed from them.
struct BarSnapshot {
  double time = 0.0;  // s; all fields stand for this time
  double near = 0.0;  // m
  double far = 0.0;
  std::vector<double> x;  // of the points, m, ascending
  std::vector<double> volume;
  std::vector<double> velocity;
  std::vector<double> stretch;  // F
  std::vector<double> stress;
  std::vector<double> cell_x;  // middles of the filled parts of the cells
  std::vector<double> cell_length;
  std::vector<double> cell_stress;
  std::vector<double> node_x;  // inner nodes
  std::vector<double> node_velocity;
};

// What the last step did to the weights.
struct RenewalCount {
  std::size_t points_moved = 0;
  std::size_t points_over_nodes = 0;  // times that a point has come to another cell
  std::size_t rows_renewed = 0;       // of nodes and cells
  std::size_t rows = 0;
};

class BarSolver {
 public:
  // `choice` gives elements (over the bar at t = 0: the spacing), kernel, support, basis order,
  // strain, placement. Throws std::invalid_argument for a choice that is not of this solver, a bar
  // that has no length, density or wave speed, a held end off the nodes, and a step (s) above the
  // bar's Courant number 1. xpic_order: 0 FLIP, else 1 to 10.
  BarSolver(const Bar& bar, const Discretization& choice, double time_step, int xpic_order = 0);

  double time() const { return time_step_ * static_cast<double>(step_); }
  long steps_done() const { return step_; }
  double spacing() const { return spacing_; }
  std::size_t point_count() const { return x_.size(); }
  // Largest c Δt/h over the points as they are now.
  double courant() const;
  const RenewalCount& last_renewal() const { return renewal_; }

  // Throws BreakdownError (step, time, quantity, place) when the stretch of a point is not a
  // positive number.
  void step();
  // Velocities are brought to the time of the stresses by half a step, on a copy.
  BarSnapshot snapshot() const;

 private:
  void place_points(const Discretization& choice);
  void renew_weights();
  void read_velocity(std::span<const double> at_points, std::span<double> at_nodes) const;
  void hold_ends(std::span<double> nodal) const;
  void remove_noise();
  void find_acceleration();
  void find_nodal_state();           // velocity and acceleration
  void accelerate(double duration);  // nodes and points
  void move_points();
  double strain_rate(double x) const;
  void check_stretch() const;

  Bar bar_;
  double spacing_;
  double time_step_;
  int xpic_order_;
  bool recovered_;
  long step_ = 0;
  FilledGrid grid_;
  CellOrder order_;
  MovingRows node_rows_;
  MovingRows cell_rows_;
  RenewalCount renewal_;

  std::vector<Vector<1>> x_;  // points, sorted
  std::vector<bool> moved_;   // since the weights were made
  std::vector<double> mass_;
  std::vector<double> stress_free_volume_;
  std::vector<double> velocity_;
  std::vector<double> stretch_;
  std::vector<double> stress_;
  std::vector<double> density_;

  std::vector<double> nodal_velocity_;      // all nodes of grid_; outer ones extended
  std::vector<double> nodal_acceleration_;  // the same
  std::vector<double> nodal_density_;       // inner nodes
  std::vector<double> cell_stress_;
};

}  // namespace porowave::solver
