#pragma once

// The coupled column by collocation, of fourth order in space (scheme = "staggered4"). Nodes hold
// velocities, cell middles hold stresses:
//
//   1. velocities at the nodes and stresses at the middles from the points: moving least squares of
//      order 2 or 3, the support enlarged where points are too few (reconstruction.hpp)
//   2. ρ a = ∂σ at the nodes, strain rates at the middles: fourth-order staggered differences, at
//      the ends cubics through what is known there (cubic_line.hpp)
//   3. increments of velocity and of stress back to the points by cubic interpolation
//
// Drag, ends and staggering in time are those of ColumnSolver. Points keep the weights of where
// they start (small strains): what they hold is the interpolation of the sums of all increments,
// those sums are the state, and points are visited only for output.
//
// With time_order = 4 the step is corrected by the modified equation (time_correction.hpp): half as
// much work again, and stable up to courant 1 at most ends (0.9 at a sealed loaded end).
//
// There is no weak form, so momentum is conserved to the order of the scheme and not to rounding.
// The moving least squares of few random points can make the scheme unstable at any time step
// (two a cell already, where cells may be empty); a run then breaks down.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "solver/column_solver.hpp"
#include "solver/staggered/phase_lines.hpp"
#include "solver/staggered/time_correction.hpp"
#include "solver/staggered/velocity_update.hpp"

namespace porowave::solver {

class StaggeredSolver {
 public:
  // Throws BreakdownError if a node or cell middle is out of reach of every point of a phase.
  explicit StaggeredSolver(const Case& scene);

  double time_step() const { return dt_; }  // s; the run ends exactly at scene.time.end
  long planned_steps() const { return steps_; }
  long steps_done() const { return step_; }
  double time() const { return dt_ * static_cast<double>(step_); }
  std::size_t point_count() const { return solid_.point_count() + fluid_.point_count(); }
  // Points are visited for output only, on one thread.
  StepPath path() const { return StepPath::frozen; }
  long frozen_steps() const { return step_; }
  static std::size_t threads() { return 1; }
  // Evaluations that had to lower the basis order, even with an enlarged support.
  std::size_t reduced_rows() const { return solid_.reduced_rows() + fluid_.reduced_rows(); }
  std::size_t empty_rows() const { return 0; }  // such a case is refused

  void step();
  // Runs to the planned end. Stops early, and says why, when a field is not finite or more than
  // 10^6 times as large as the load.
  std::optional<Breakdown> run();
  // Velocities are brought to the time of the stresses by half a step, on a copy.
  Snapshot snapshot() const;

  // All that a step carries to the next one: what the points hold, as solid and fluid velocities of
  // the nodes (m/s), effective stresses and pressures of the cells (Pa); with time_order = 4 also
  // the rates of the forces of both phases at the nodes (N/m³/s). 4 or 6 times elements, and 2 or 4
  // more.
  std::size_t state_size() const;
  std::vector<double> state() const;
  // The run goes on from there, in all nodes. Throws std::invalid_argument for a wrong length.
  void set_state(std::span<const double> state);

 private:
  void reconstruct();
  // What the near end prescribes, for stresses or for their rates.
  void prescribe_stresses(std::vector<double>& effective_stress, std::vector<double>& pressure,
                          double load) const;
  void find_forces(const std::vector<double>& effective_stress, const std::vector<double>& pressure,
                   BothPhases& forces);
  void find_stress_rates(const std::vector<double>& solid, const std::vector<double>& fluid);
  void kick(StepPart part);  // velocities at the stresses of now
  void correct_forces(StepPart part);
  void drift();  // stresses over a step at the velocities of now
  void correct_stress_rates();
  void widen_window();
  std::optional<Breakdown> find_breakdown() const;

  Case scene_;
  std::size_t cells_;
  double spacing_;
  double dt_;
  long steps_;
  long step_ = 0;
  PhaseLines solid_;
  PhaseLines fluid_;
  std::size_t end_;                           // nodes and cells from here on are at rest
  VelocityUpdate update_;                     // over a whole step
  std::optional<TimeCorrection> correction_;  // for time_order = 4
  BothPhases forces_;                         // per volume, at the nodes
  BothPhases increments_;                     // of the velocities
  BothPhases stress_rates_;                   // laid out as stresses
  BothPhases scratch_;                        // at the nodes
  BothPhases slopes_;
};

}  // namespace porowave::solver
