#pragma once

// The coupled double-point column (Chmelnizkij 2023, eqs. 2-4), explicit, in one dimension: two
// sets of material points, one grid. One step:
//
//   1. weights, when points have moved        5. momentum at the nodes (nodal_update.hpp)
//   2. velocities to the nodes                6. velocities and positions of the points
//   3. stress and pressure to quadrature      7. strain rates at the points, stress and pressure
//   4. internal forces
//
// Staggered: velocities stand at half steps, stresses at full steps; second order in time. Small
// strains: volumes and porosity stay as they are, weights are renewed when points may have moved by
// more than `reweight_share` of h.
//
// Limits of this version: linear elastic solid, one dimension, strains small; the far end
// "half_space" is a column too long for a reflection to arrive before the end of the run.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "solver/case.hpp"
#include "solver/nodal_update.hpp"
#include "solver/placement.hpp"
#include "solver/transfer.hpp"

namespace porowave::solver {

inline constexpr double reweight_share = 1e-3;

// The points of one phase at one time. `stress` is the effective stress at solid points and the
// pore pressure at fluid points, Pa.
struct PhasePoints {
  std::vector<double> x;         // m
  std::vector<double> volume;    // m (of mixture, per unit area)
  std::vector<double> velocity;  // m/s
  std::vector<double> stress;    // Pa
};

// Everything at one time: the points, and the fields reconstructed from them by the transfer.
struct Snapshot {
  double time = 0.0;  // s; all fields stand for this time
  PhasePoints solid;
  PhasePoints fluid;
  std::vector<double> cell_x;  // middles of cells
  std::vector<double> effective_stress;
  std::vector<double> pore_pressure;
  std::vector<double> node_x;
  std::vector<double> solid_velocity;
  std::vector<double> fluid_velocity;
};

// Why a run cannot go on.
struct Breakdown {
  long step;
  std::string reason;  // step, time, quantity, place
};

class ColumnSolver {
 public:
  // Throws BreakdownError if the loaded end has no point within reach.
  explicit ColumnSolver(const Case& scene);

  double time_step() const { return dt_; }  // s; the run ends exactly at scene.time.end
  long planned_steps() const { return steps_; }
  long steps_done() const { return step_; }
  double time() const { return dt_ * static_cast<double>(step_); }
  // Length of the grid, m: of the column, or for a half-space as far as anything can get by the
  // end.
  static double grid_length(const Case& scene);
  std::size_t point_count() const;
  std::size_t reduced_rows() const;  // evaluations that had to lower the basis order
  std::size_t empty_rows() const;    // nodes and cell middles that no point reaches

  void step();
  // Runs to the planned end. Stops early, and says why, when a field is not finite or more than
  // 10^6 times as large as the load.
  std::optional<Breakdown> run();
  // Velocities are brought to the time of the stresses by half a step, on a copy.
  Snapshot snapshot() const;

 private:
  struct PhaseState {
    PointSet<1> points;
    std::vector<double> velocity;
    std::vector<double> stress;
    std::vector<double> velocity_gradient;        // C_p of apic, 1/s; else empty
    std::shared_ptr<const Transfer<1>> transfer;  // shared by copies, never changed
    std::vector<double> quadrature;               // stress or pressure there
  };

  static PhaseState start(const Discretization& choice, double spacing, Phase phase,
                          double density);
  void make_weights();
  void move_points();  // from the nodal displacement since the weights were made
  void nodal_velocities_and_forces();
  void update_points();
  void synchronise_velocities();  // half a step, after which the object cannot step on
  std::optional<Breakdown> find_breakdown() const;

  Case scene_;
  Grid<1> grid_;
  double dt_;
  long steps_;
  long step_ = 0;
  PhaseState solid_;
  PhaseState fluid_;
  PhaseNodes solid_nodes_;
  PhaseNodes fluid_nodes_;
  std::vector<double> solid_displacement_;  // nodal, since the weights were made
  std::vector<double> fluid_displacement_;
  std::vector<double> increment_;  // scratch, nodal
  std::vector<double> at_points_;  // scratch
  std::vector<double> more_at_points_;
};

}  // namespace porowave::solver
