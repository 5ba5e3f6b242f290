// Cost of the reference on the paper's column: a profile of 1,001 points, a million points, single
// values in three regimes of drag, and the same value by the other routes.

#include <benchmark/benchmark.h>

#include "reference/bromwich.hpp"
#include "reference/modal.hpp"
#include "reference/problem/problem_fixtures.hpp"
#include "reference/profile.hpp"

namespace {

using namespace porowave;
using namespace porowave::reference;

constexpr double time = 4e-5;

Problem paper_problem(double permeability, const Load& load = Load(LoadShape::step, 1.0)) {
  Problem problem = fixtures::paper_problem(load);
  problem.material.intrinsic_permeability = permeability;
  return problem;
}

/// Four fields at `points` places of one time, the profile's construction included.
void profile(benchmark::State& state) {
  const auto points = static_cast<int>(state.range(0));
  const ColumnSolution solution(paper_problem(1e-11));
  double error = 0.0;
  for (auto _ : state) {
    const Profile profile(solution, time, 0.1);
    for (int i = 0; i < points; ++i) benchmark::DoNotOptimize(profile.at(0.1 * i / (points - 1)));
    error = profile.error();
  }
  state.counters["ns_per_point"] = benchmark::Counter(
      points * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["error"] = error;
}
BENCHMARK(profile)->Arg(1001)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

/// One value of four fields in the middle of the column; the argument is -log10 of the
/// permeability.
void contour_value(benchmark::State& state) {
  const ColumnSolution solution(paper_problem(std::pow(10.0, -static_cast<int>(state.range(0)))));
  for (auto _ : state) benchmark::DoNotOptimize(solution.at(0.05, time));
}
BENCHMARK(contour_value)->Arg(11)->Arg(13)->Arg(15)->Unit(benchmark::kMicrosecond);

/// The GSL route at 1e-9.
void bromwich_value(benchmark::State& state) {
  const BromwichSolution solution(paper_problem(1e-11), 1e-9);
  double x = 0.005;
  for (auto _ : state) {
    benchmark::DoNotOptimize(solution.at(x, time));
    x = x > 0.09 ? 0.005 : x + 0.007;
  }
}
BENCHMARK(bromwich_value)->Unit(benchmark::kMicrosecond);

}  // namespace
