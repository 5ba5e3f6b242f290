#include "reports/run_history.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <stdexcept>

#include "reference/problem/errors.hpp"
#include "solver/staggered/staggered_solver.hpp"
#include "verification/run.hpp"

namespace porowave::reports {

namespace {

constexpr std::size_t most_characteristics = 2048;

/// Beyond this many times the load's size a run counts as broken down (as in the solver).
constexpr double most_of_load = 1e6;
/// What a frame before a breakdown may show of it, over the largest value of the reference.
constexpr double most_of_reference = 10.0;

std::vector<Fields> reference_of(const solver::Snapshot& now, const Problem& problem,
                                 double length) {
  const auto profile = verification::reference_profile(problem, now.time, length);
  std::vector<Fields> values;
  values.reserve(now.cell_x.size());
  for (const double x : now.cell_x) values.push_back(profile->at(x));
  return values;
}

/// Largest size of both stresses; infinite if a value is none.
double largest_stress(const solver::Snapshot& snapshot) {
  double largest = 0.0;
  for (const auto* values : {&snapshot.effective_stress, &snapshot.pore_pressure}) {
    for (const double value : *values) {
      if (!std::isfinite(value)) return HUGE_VAL;
      largest = std::max(largest, std::abs(value));
    }
  }
  return largest;
}

double largest_stress(const std::vector<Fields>& reference) {
  double largest = 0.0;
  for (const Fields& f : reference) {
    largest = std::max({largest, std::abs(f.effective_stress), std::abs(f.pore_pressure)});
  }
  return largest;
}

void advance(solver::ColumnSolver& run, long last) {
  run.advance(last);
}

void advance(solver::StaggeredSolver& run, long last) {
  while (run.steps_done() < last) run.step();
}

/// Results do not depend on the number of threads; several runs may be under way.
void use_one_thread(solver::ColumnSolver& run) {
  run.use_threads(1);
}

void use_one_thread(const solver::StaggeredSolver&) {}

/// Frames up to the end, or up to the first one that is no longer worth a look; whether it got to
/// the end.
template <class Solver>
bool add_frames(Solver& run, int frames, bool points, RunHistory& history) {
  use_one_thread(run);
  const Problem& problem = history.scene.problem;
  const double length = solver::ColumnSolver::grid_length(history.scene);
  const long count = std::min<long>(frames, run.planned_steps());
  for (long k = 1; k <= count; ++k) {
    advance(run, run.planned_steps() * k / count);
    solver::Snapshot now = run.snapshot();
    if (largest_stress(now) > most_of_load * problem.stress_scale()) return false;
    if (!points && !history.frames.empty()) {
      history.frames.back().snapshot.solid = {};
      history.frames.back().snapshot.fluid = {};
    }
    auto reference = reference_of(now, problem, length);
    history.frames.push_back({std::move(now), std::move(reference)});
  }
  return true;
}

/// The last frames before a breakdown may hold nothing but it. They lose their points; the one
/// that stays the last needs them, so the run is made again up to there.
template <class Solver>
void keep_what_tells(RunHistory& history) {
  double largest = 0.0;
  std::size_t telling = 0;
  for (std::size_t k = 0; k < history.frames.size(); ++k) {
    largest = std::max(largest, largest_stress(history.frames[k].reference));
    if (largest_stress(history.frames[k].snapshot) <= most_of_reference * largest) telling = k + 1;
  }
  if (telling == history.frames.size()) return;
  history.frames.resize(telling);
  if (telling == 0) return;
  Solver again(history.scene);
  use_one_thread(again);
  const double time = history.frames.back().snapshot.time;
  advance(again, std::lround(time / again.time_step()));
  history.frames.back().snapshot = again.snapshot();
}

template <class Solver>
void watch(int frames, RunHistory& history) {
  Solver run(history.scene);
  if (add_frames(run, frames, false, history)) return;
  keep_what_tells<Solver>(history);
  // The solver says why, in its own words.
  Solver whole(history.scene);
  use_one_thread(whole);
  history.breakdown = whole.run();
  if (!history.breakdown) history.breakdown = {run.steps_done(), "values are not finite"};
}

bool staggered(const solver::Case& scene) {
  return scene.discretization.scheme == solver::Scheme::staggered4;
}

}  // namespace

RunHistory run_history(const solver::Case& scene, int frames) {
  const auto with = [&](auto&& run) {
    if (frames < 1 || frames > run.planned_steps()) {
      throw std::invalid_argument("run history: expected 1 to as many frames as steps");
    }
    RunHistory history{scene, {}};
    if (add_frames(run, frames, true, history)) return history;
    throw BreakdownError("run history: values are not finite; try a smaller courant");
  };
  return staggered(scene) ? with(solver::StaggeredSolver(scene))
                          : with(solver::ColumnSolver(scene));
}

RunHistory watched_run(const solver::Case& scene, int frames) {
  if (frames < 1) throw std::invalid_argument("run history: expected one frame at least");
  RunHistory history{scene, {}};
  try {
    if (staggered(scene)) {
      watch<solver::StaggeredSolver>(frames, history);
    } else {
      watch<solver::ColumnSolver>(frames, history);
    }
  } catch (const BreakdownError& error) {
    history.breakdown = {0, error.what()};
  }
  return history;
}

std::vector<Characteristic> characteristics(const Problem& problem, double end) {
  struct Start {
    double t;
    bool upwards;           // from x = 0
    bool as_fast, as_slow;  // the waves that set out
    bool operator>(const Start& other) const { return t > other.t; }
  };
  const WaveSpeeds speeds = wave_speeds(problem.material);
  std::priority_queue<Start, std::vector<Start>, std::greater<>> starts;
  starts.push({0.0, true, true, true});
  std::vector<Characteristic> ways;
  while (!starts.empty() && starts.top().t < end && ways.size() + 2 <= most_characteristics) {
    const Start from = starts.top();
    starts.pop();
    const bool converts = from.upwards ? problem.column.far == FarEnd::rigid_drained
                                       : problem.column.near == NearEnd::sealed_traction;
    for (const bool fast : {true, false}) {
      if (!(fast ? from.as_fast : from.as_slow)) continue;
      const double speed = fast ? speeds.p1 : speeds.p2;
      const double length = problem.column.length.value_or(speed * end);
      const double arrival = from.t + length / speed;
      const double until = std::min(arrival, end);
      const double way = speed * (until - from.t);
      const double begin = from.upwards ? 0.0 : length;
      ways.push_back({fast, begin, from.t, from.upwards ? way : length - way, until});
      if (arrival < end) {
        starts.push({arrival, !from.upwards, fast || converts, !fast || converts});
      }
    }
  }
  return ways;
}

std::vector<WaveFront> fronts_at(const Problem& problem, double t) {
  std::vector<WaveFront> fronts;
  for (const Characteristic& way : characteristics(problem, t)) {
    if (way.t_end < t) continue;
    const bool known = std::any_of(fronts.begin(), fronts.end(), [&](const WaveFront& front) {
      return front.fast == way.fast && std::abs(front.x - way.x_end) < 1e-12 * (1.0 + way.x_end);
    });
    if (!known) fronts.push_back({way.x_end, way.fast});
  }
  std::sort(fronts.begin(), fronts.end(),
            [](const WaveFront& a, const WaveFront& b) { return a.x < b.x; });
  return fronts;
}

}  // namespace porowave::reports
