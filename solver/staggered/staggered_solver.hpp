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
// There is no weak form, so momentum is conserved to the order of the scheme and not to rounding.
// The moving least squares of few random points can make the scheme unstable at any time step
// (two a cell already, where cells may be empty); a run then breaks down.

#include <cstddef>
#include <optional>
#include <vector>

#include "solver/column_solver.hpp"
#include "solver/staggered/phase_lines.hpp"

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
  // Evaluations that had to lower the basis order, even with an enlarged support.
  std::size_t reduced_rows() const { return solid_.reduced_rows() + fluid_.reduced_rows(); }
  std::size_t empty_rows() const { return 0; }  // such a case is refused

  void step();
  // Runs to the planned end. Stops early, and says why, when a field is not finite or more than
  // 10^6 times as large as the load.
  std::optional<Breakdown> run();
  // Velocities are brought to the time of the stresses by half a step, on a copy.
  Snapshot snapshot() const;

 private:
  // Per volume, at the nodes.
  struct Forces {
    std::vector<double> solid;
    std::vector<double> fluid;
  };

  void reconstruct();
  void prescribe_stresses(std::vector<double>& effective_stress, std::vector<double>& pressure,
                          double load) const;
  void find_forces();
  void kick(const StepLoad& load, double dt);  // velocities over dt at the stresses of now
  void kick_ends(const StepLoad& load, double dt);
  void drift();  // stresses over a step at the velocities of now
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
  std::size_t end_;  // nodes and cells from here on are at rest
  Forces forces_;
  std::vector<double> solid_slopes_;  // scratch
  std::vector<double> fluid_slopes_;
};

}  // namespace porowave::solver
