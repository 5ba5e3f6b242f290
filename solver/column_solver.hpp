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
// Where the points have not moved by that much since the weights were made, they are eliminated
// (frozen_column.hpp), unless the case says otherwise or its transfer does not allow it: the first
// time they move farther they are brought up to date, and the run goes on with them.
//
// Causality: the run starts at rest and every wave comes from x = 0, so only the nodes up to a
// little ahead of the signal are stepped. Beyond, velocities would be below 1e-30 of the load's;
// the results are the same to rounding. (Stepping them is worse than useless: farther ahead the
// values are too small for normal floating point numbers, which costs a hundred times as much.)
//
// Large scenes use OpenMP's threads. No sum depends on their number, so neither do the results.
//
// Limits of this version: linear elastic solid, one dimension, strains small; the far end
// "half_space" is a column too long for a reflection to arrive before the end of the run.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "solver/body_force.hpp"
#include "solver/case.hpp"
#include "solver/column_operators.hpp"
#include "solver/frozen_column.hpp"
#include "solver/nodal_update.hpp"
#include "solver/placement.hpp"
#include "solver/prepared_update.hpp"
#include "solver/signal_window.hpp"

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

// Why a run cannot go on. What caused it is a question of its own, which takes longer than most
// runs: breakdown_cause.hpp.
struct Breakdown {
  long step;
  std::string reason;      // step, time, quantity, place, what is wrong
  double time_step = 0.0;  // s; 0 if the reason says all there is to say
  double moved = 0.0;      // how far a point has moved at most, m
};

class ColumnSolver {
 public:
  // Throws BreakdownError if the loaded end has no point within reach, InputError if the case asks
  // for path = "frozen" and its transfer has no compact form.
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
  // The path of the steps done so far: frozen if all of them were.
  StepPath path() const;
  long frozen_steps() const { return frozen_steps_; }
  // What a step of a phase is made of, for the points where they are (solver/stability/).
  const ColumnOperators& operators(Phase phase) const {
    return *state_of(phase).prepared.operators;
  }
  const PhaseNodes& nodes(Phase phase) const { return state_of(phase).nodes; }

  // Large scenes take the threads that OpenMP offers, others one; a caller that runs many cases
  // side by side sets 1. Without OpenMP it stays at 1.
  void use_threads(std::size_t most);
  std::size_t threads() const { return threads_; }
  // Steps all nodes from now on, also those that no signal can have reached.
  void disregard_causality() { window_ = SignalWindow::whole_column(node_count_); }

  // What manufactured solutions need, before the first step (std::invalid_argument after it). The
  // run is then not driven by its load alone: it visits its points (std::invalid_argument if the
  // case asks for path = "frozen"), all nodes are stepped, and `run` stops at values that are not
  // finite, however large.
  //
  // The force acts on both phases, see body_force.hpp; from t = 0 on if the run starts at rest.
  void set_body_force(BodyForce force);
  // Points start with the stresses of time 0 and the velocities of half a step before. Throws
  // std::invalid_argument for apic, whose points carry more than that.
  void start_from(const std::function<Fields(double x, double t)>& fields);

  void step();
  // Steps until `last` steps are done; with path = "frozen" no farther than points may move. The
  // same bits as step by step, but frozen steps are made several at a time, which is faster in
  // columns that do not fit into the cache.
  void advance(long last);
  // Runs to the planned end. Stops early, and says why, when a field is not finite or more than
  // 10^6 times as large as the load, and when path = "frozen" is asked for and points have moved by
  // more than reweight_share of h.
  std::optional<Breakdown> run();
  // Velocities are brought to the time of the stresses by half a step, on a copy.
  Snapshot snapshot() const;

 private:
  struct PhaseState {
    PointSet<1> points;  // sorted by x
    PointValues values;
    PreparedPhase prepared;
    PhaseNodes nodes;
    std::vector<double> displacement;  // nodal, since the weights were made
  };
  // Nodal scratch of one thread.
  struct PartScratch {
    std::vector<double> first;
    std::vector<double> second;
  };

  const PhaseState& state_of(Phase phase) const { return phase == Phase::solid ? solid_ : fluid_; }
  static PhaseState start(const Discretization& choice, double spacing, Phase phase,
                          double density);
  static void sort_points(PhaseState& state);
  std::size_t guard() const;  // nodes that a signal can cross in a step, at most
  void choose_threads();
  void make_weights();
  bool phases_share_points() const;
  void share_weights();  // the solid's for both phases
  void move_points();    // from the nodal displacement since the weights were made
  void freeze();
  void thaw();  // brings the points up to date
  StepLoad load_of_step(long step) const;
  StepLoad load_between(double before, double after) const;
  IndexRange part(std::size_t k) const;
  bool sweep(const StepLoad& load);  // whether points have moved too far
  bool sweep_parts(const StepLoad& load, IndexRange parts, PartScratch& scratch);
  void finish_parts(IndexRange parts, PartScratch& scratch);
  bool sweep_to_nodes(const StepLoad& load, IndexRange nodes, PartScratch& scratch);
  void sweep_to_points(IndexRange nodes, PartScratch& scratch);
  void step_frozen(long steps);
  long safe_steps() const;  // at a time, in which points will not move too far as it seems
  bool held_up() const;     // the points have, and path = "frozen"
  void renew_weights();
  void drive_otherwise();  // than by the load alone
  void add_body_force(IndexRange nodes, double* effective, double* pressure) const;
  void synchronise_velocities();  // half a step, after which the object cannot step on
  bool surely_bounded(double velocity, double effective, double pressure) const;
  std::optional<Breakdown> find_breakdown() const;
  Breakdown moved_too_far() const;  // for path = "frozen"

  Case scene_;
  Grid<1> grid_;
  double dt_;
  long steps_;
  long step_ = 0;
  long frozen_steps_ = 0;
  PhaseState solid_;
  PhaseState fluid_;
  PreparedUpdate update_;
  std::optional<FrozenColumn> frozen_;  // then the points are as they were at its start
  long single_until_ = 0;               // no several steps at a time before this one
  std::size_t node_count_;
  SignalWindow window_;
  bool points_moved_ = false;  // since the start, by renewed weights
  std::size_t part_nodes_;     // nodes of one part of the column
  bool lagged_;                // whether a part reaches no farther than the next one
  std::size_t threads_;
  std::vector<PartScratch> scratch_;  // one a thread
  BodyForce body_force_;              // may be empty
  bool only_loaded_ = true;           // starts at rest, no body force
  bool has_past_ = false;             // does not start at rest
};

}  // namespace porowave::solver
