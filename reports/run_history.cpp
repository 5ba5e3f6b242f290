#include "reports/run_history.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <stdexcept>

#include "reference/problem/errors.hpp"
#include "verification/run.hpp"

namespace porowave::reports {

namespace {

constexpr std::size_t most_characteristics = 2048;

RunHistory::Frame frame_of(const solver::ColumnSolver& run, const Problem& problem, double length) {
  RunHistory::Frame frame{run.snapshot(), {}};
  const auto profile = verification::reference_profile(problem, frame.snapshot.time, length);
  for (const double x : frame.snapshot.cell_x) frame.reference.push_back(profile->at(x));
  return frame;
}

bool is_finite(const solver::Snapshot& snapshot) {
  const auto finite = [](double value) { return std::isfinite(value); };
  return std::all_of(snapshot.effective_stress.begin(), snapshot.effective_stress.end(), finite) &&
         std::all_of(snapshot.pore_pressure.begin(), snapshot.pore_pressure.end(), finite);
}

}  // namespace

RunHistory run_history(const solver::Case& scene, int frames) {
  solver::ColumnSolver run(scene);
  if (frames < 1 || frames > run.planned_steps()) {
    throw std::invalid_argument("run history: expected 1 to as many frames as steps");
  }
  RunHistory history{scene, {}};
  const double length = solver::ColumnSolver::grid_length(scene);
  for (long k = 1; k <= frames; ++k) {
    while (run.steps_done() < run.planned_steps() * k / frames) run.step();
    history.frames.push_back(frame_of(run, scene.problem, length));
    if (!is_finite(history.frames.back().snapshot)) {
      throw BreakdownError("run history: values are not finite; try a smaller courant");
    }
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

}  // namespace porowave::reports
