#pragma once

#include <optional>
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
  /// Of a run that did not get there; the last frame is then from before it, if there is one.
  std::optional<solver::Breakdown> breakdown = {};
};

/// Runs a case and stops `frames` times (one at least, no more than there are steps), at equal
/// distances up to a step. Throws BreakdownError if the run breaks down, InputError if the
/// reference cannot resolve one of the times.
RunHistory run_history(const solver::Case& scene, int frames);

/// The same of a run that may break down: the frames before that, and why. Takes as many frames as
/// there are steps where these are fewer; only the last frame keeps its points. Throws InputError.
RunHistory watched_run(const solver::Case& scene, int frames);

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

/// Where the ways of both waves have got to at time t (s), m; every place once, ascending.
struct WaveFront {
  double x;
  bool fast;  ///< P1, or P2
};
std::vector<WaveFront> fronts_at(const Problem& problem, double t);

}  // namespace porowave::reports
