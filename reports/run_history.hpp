#pragma once

#include <vector>

#include "solver/column_solver.hpp"

namespace porowave::reports {

/// A run at several times of its course, beside the reference.
struct RunHistory {
  struct Frame {
    solver::Snapshot snapshot;
    std::vector<Fields> reference;  ///< at the middles of cells
  };
  solver::Case scene;
  std::vector<Frame> frames;  ///< ascending in time, the last at the end of the run
};

/// Runs a case and stops `frames` times (one at least, no more than there are steps), at equal
/// distances up to a step. Throws BreakdownError if the run breaks down, InputError if the
/// reference cannot resolve one of the times.
RunHistory run_history(const solver::Case& scene, int frames);

/// The way of a wave's front between two ends of the column, or up to the end of the run.
struct Characteristic {
  bool fast = true;  ///< P1, or P2
  double x_begin = 0.0, t_begin = 0.0;
  double x_end = 0.0, t_end = 0.0;
};

/// The ways of what the beginning of the load sends off, with every reflection, up to time `end`.
/// An end that fixes both velocities or both tractions reflects a wave as itself, the others
/// (sealed_traction, rigid_drained) as both. At most 2 048 ways, earliest first.
std::vector<Characteristic> characteristics(const Problem& problem, double end);

}  // namespace porowave::reports
