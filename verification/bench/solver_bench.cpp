// Cost of the column solver, by scene and path. Every step is taken over the whole column, as if
// the signal had reached its end. CPU time of one thread, unless the name says otherwise.
//
//   s_per_point_step, s_per_node_step    seconds (printed with a prefix: 3n is 3 ns)
//   points_over_frozen, general_over_frozen    cost for the same scene, taken in turns
//   time of an iteration                     up to 150 steps
//   bytes_per_point, peak_bytes_per_point      of a solver at work; while it is made

#include <benchmark/benchmark.h>
#include <malloc.h>

#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "solver/column_solver.hpp"
#include "solver/general_operators.hpp"
#include "verification/bench/scenes.hpp"

namespace {

using namespace porowave;
using namespace porowave::solver;
using namespace porowave::bench;

void report(benchmark::State& state, double seconds, std::size_t points, int elements) {
  state.counters["s_per_point_step"] = seconds / static_cast<double>(points);
  state.counters["s_per_node_step"] = seconds / (elements + 1);
}

void steps(benchmark::State& state, StepPath path, const Scene& scene, double (*now)() = cpu_now,
           std::size_t threads = 1) {
  const ColumnSolver solver = whole_column(scene, path, threads);
  std::vector<double> seconds;
  for (auto _ : state) {
    seconds.push_back(time_steps(solver, now));
    state.SetIterationTime(seconds.back() * steps_at_a_time(solver));
  }
  report(state, median(seconds), solver.point_count(), scene.elements);
}

/// The two phases' part in a step by the rows of Transfer, without the nodes' own.
class GeneralStep {
 public:
  explicit GeneralStep(const Scene& scene) {
    const Case choice = case_of(scene, StepPath::points);
    const double h = *choice.problem.column.length / scene.elements;
    const Grid<1> grid(Vector<1>(0.0), h, CellIndex<1>(scene.elements));
    const PlacedPoints placed = place_points(choice.discretization, h, Phase::solid);
    PointSet<1> points;
    for (const double x : placed.x) points.x.emplace_back(x);
    points.volume = points.mass = placed.volume;
    operators_.emplace(Transfer<1>(points, grid, choice.discretization), points.x.size());
    values_.velocity.resize(points.x.size());
    values_.stress.resize(points.x.size());
    nodal_.resize(static_cast<std::size_t>(grid.node_count()));
    force_.resize(nodal_.size());
  }
  double seconds() {
    const double start = cpu_now();
    for (int phase = 0; phase < 2; ++phase) {
      operators_->gather(values_, {0, nodal_.size()}, nodal_.data(), force_.data());
      operators_->scatter({1.0, nodal_.data(), nodal_.data(), nodal_.data(), 1.0},
                          {0, nodal_.size() - 1}, values_);
    }
    return cpu_now() - start;
  }

 private:
  std::optional<GeneralOperators> operators_;
  PointValues values_;
  std::vector<double> nodal_, force_;
};

void compare(benchmark::State& state, const Scene& scene) {
  const ColumnSolver points = whole_column(scene, StepPath::points);
  const ColumnSolver frozen = whole_column(scene, StepPath::frozen);
  GeneralStep general(scene);
  std::vector<double> points_ratio, general_ratio;
  for (auto _ : state) {
    const double frozen_seconds = time_steps(frozen, cpu_now);
    points_ratio.push_back(time_steps(points, cpu_now) / frozen_seconds);
    general_ratio.push_back(general.seconds() / frozen_seconds);
    state.SetIterationTime(3.0 * frozen_seconds * steps_at_a_time(frozen));
  }
  state.counters["points_over_frozen"] = median(points_ratio);
  state.counters["general_over_frozen"] = median(general_ratio);
}

double allocated_bytes() {
  const auto info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

double peak_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word != "VmHWM:") continue;
    double kibibytes = 0.0;
    status >> kibibytes;
    return 1024.0 * kibibytes;
  }
  return 0.0;
}

void memory(benchmark::State& state, StepPath path, const Scene& scene) {
  for (auto _ : state) {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";  // the peak from now on
    const double peak_before = peak_bytes();
    const double before = allocated_bytes();
    const ColumnSolver solver(case_of(scene, path));
    const auto points = static_cast<double>(solver.point_count());
    state.counters["bytes_per_point"] = (allocated_bytes() - before) / points;
    state.counters["peak_bytes_per_point"] = (peak_bytes() - peak_before) / points;
    state.SetIterationTime(1e-9);
  }
}

#define SCENE(function, name, ...) BENCHMARK_CAPTURE(function, name, __VA_ARGS__)->UseManualTime()

SCENE(steps, points_4_a_cell, StepPath::points, Scene{});
SCENE(steps, points_8_a_cell, StepPath::points, Scene{.points_per_element = 8});
SCENE(steps, points_radius_5, StepPath::points, Scene{.support_radius = 5.0});
SCENE(steps, points_100_thousand, StepPath::points, Scene{.elements = 12'500});
SCENE(steps, points_1_million, StepPath::points, Scene{.elements = 125'000});
SCENE(steps, frozen_4_a_cell, StepPath::frozen, Scene{});
SCENE(steps, frozen_radius_5, StepPath::frozen, Scene{.support_radius = 5.0});
SCENE(steps, frozen_125_thousand_cells, StepPath::frozen, Scene{.elements = 125'000});
SCENE(steps, points_1_million_wall_1_thread, StepPath::points, Scene{.elements = 125'000},
      wall_now);
SCENE(steps, points_1_million_wall_2_threads, StepPath::points, Scene{.elements = 125'000},
      wall_now, 2);
SCENE(steps, points_4_stratified, StepPath::points, Scene{.placement = Placement::stratified});
SCENE(steps, frozen_4_stratified, StepPath::frozen, Scene{.placement = Placement::stratified});
SCENE(steps, frozen_1_million_cells, StepPath::frozen, Scene{.elements = 1'000'000});
SCENE(steps, frozen_1_million_cells_wall_1_thread, StepPath::frozen, Scene{.elements = 1'000'000},
      wall_now);
SCENE(steps, frozen_1_million_cells_wall_2_threads, StepPath::frozen, Scene{.elements = 1'000'000},
      wall_now, 2);
SCENE(steps, frozen_125_thousand_stratified, StepPath::frozen,
      Scene{.elements = 125'000, .placement = Placement::stratified});
SCENE(compare, 4_a_cell, Scene{});
SCENE(compare, 8_a_cell, Scene{.points_per_element = 8});
SCENE(memory, points_1_million, StepPath::points, Scene{.elements = 125'000})->Iterations(1);
SCENE(memory, points_1_million_stratified, StepPath::points,
      Scene{.elements = 125'000, .placement = Placement::stratified})
    ->Iterations(1);
SCENE(memory, frozen_1_million, StepPath::frozen, Scene{.elements = 125'000})->Iterations(1);

}  // namespace
