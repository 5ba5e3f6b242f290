// When more hands pay: threads of one machine, and messages between processes.
//
//   one_over_two_threads     wall time of a step by one thread over that by two, taken in turns
//   time of a neighbour_exchange    one message each way between two processes over a local socket

#include <benchmark/benchmark.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <vector>

#include "verification/bench/scenes.hpp"

namespace {

using namespace porowave::bench;

void threads(benchmark::State& state, StepPath path, Placement placement) {
  const Scene scene{.elements = static_cast<int>(state.range(0)), .placement = placement};
  const ColumnSolver one = whole_column(scene, path, 1);
  const ColumnSolver two = whole_column(scene, path, 2);
  std::vector<double> ratios;
  std::vector<double> steps;
  for (auto _ : state) {
    const double alone = time_steps(one, wall_now);
    steps.push_back(time_steps(two, wall_now));
    ratios.push_back(alone / steps.back());
    state.SetIterationTime((alone + steps.back()) * steps_at_a_time(one));
  }
  state.counters["one_over_two_threads"] = median(ratios);
  state.counters["s_per_step_of_two"] = median(steps);
  state.counters["points"] = static_cast<double>(one.point_count());
}

bool send_all(int socket, std::vector<double>& values) {
  const auto bytes = static_cast<ssize_t>(values.size() * sizeof(double));
  return send(socket, values.data(), static_cast<std::size_t>(bytes), MSG_NOSIGNAL) == bytes;
}

bool receive_all(int socket, std::vector<double>& values) {
  const auto bytes = static_cast<ssize_t>(values.size() * sizeof(double));
  return recv(socket, values.data(), static_cast<std::size_t>(bytes), MSG_WAITALL) == bytes;
}

/// What a step of a divided column needs at least: its neighbour's border, and to give its own.
void neighbour_exchange(benchmark::State& state) {
  std::vector<double> border(static_cast<std::size_t>(state.range(0)));
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) {
    return state.SkipWithError("no pair of sockets");
  }
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    while (receive_all(ends[1], border) && send_all(ends[1], border)) {
    }
    _exit(0);
  }
  close(ends[1]);
  for (auto _ : state) {
    if (child < 0 || !send_all(ends[0], border) || !receive_all(ends[0], border)) {
      state.SkipWithError("the other process has ended");
      break;
    }
  }
  close(ends[0]);
  if (child > 0) waitpid(child, nullptr, 0);
}

constexpr auto frozen = StepPath::frozen;
constexpr auto points = StepPath::points;
constexpr auto regular = Placement::uniform;
constexpr auto stratified = Placement::stratified;

#define SIZES(name, path, placement)                \
  BENCHMARK_CAPTURE(threads, name, path, placement) \
      ->RangeMultiplier(4)                          \
      ->Range(256, 1 << 20)                         \
      ->UseManualTime()

SIZES(frozen, frozen, regular);
SIZES(frozen_stratified, frozen, stratified);
SIZES(points, points, regular);
BENCHMARK(neighbour_exchange)->Arg(8)->Arg(256)->UseRealTime();

}  // namespace
