// Several steps of a frozen column at a time, so that its fields come from memory once for all of
// them.
//
// Step t of part k reads t of the parts k − 1, k, k + 1 and writes t + 1. So the steps go through
// the parts as a wave: for every w, in this order, step 0 of part w, step 1 of part w − 1, ... Then
// part k + 1 has just made step t − 1 when part k makes step t, and nobody needs state t − 1 of
// part k any more, which is where state t + 1 goes. The state before the first step is kept as it
// is.
//
// With several threads each has a segment of the parts. Where another one's begins, it leaves out
// one part more in every step; what is missing beside the border, one part to either side after the
// first step, two after the second, is filled in after all have come to their end. No value that
// this needs has been written over: on either side that would have been done by the step after the
// next, which ended one part before.
//
//   step 2   0 0 0 0 0 . . . . 1 1 1 1        . filled in
//   step 1   0 0 0 0 0 0 . . 1 1 1 1 1        0, 1 made by that thread
//   step 0   0 0 0 0 0 0 0 1 1 1 1 1 1

#ifdef _OPENMP
#include <omp.h>
#endif

#include <algorithm>
#include <cmath>

#include "solver/frozen_column.hpp"

namespace porowave::solver {

namespace {

// What is filled in beside the borders should be the smaller share.
constexpr std::size_t parts_of_thread_per_step = 4;

std::size_t parts_in(std::size_t nodes) {
  return (nodes + FrozenColumn::part_nodes - 1) / FrozenColumn::part_nodes;
}

}  // namespace

struct FrozenColumn::Chunk {
  using StepSquares = std::array<double, longest_chunk>;  // the largest of any part
  struct Segment {
    IndexRange parts;
    bool first, last;  // of the column
  };

  Chunk(FrozenColumn& frozen, const NodeUpdate& update, std::span<const StepLoad> all_loads,
        const SignalWindow& window);
  Segment segment(std::size_t mine, std::size_t all) const;
  void climb(const Segment& segment, StepSquares& squares);
  void fill(std::size_t border, StepSquares& squares);
  void step(std::size_t t, std::size_t part, std::size_t end, StepSquares& squares);
  void end_step(std::size_t t);

  FrozenColumn& column;
  const NodeUpdate& by;
  std::span<const StepLoad> loads;
  std::array<Turn, longest_chunk> turns{};
  std::array<SignalWindow, longest_chunk + 1> windows;  // all nodes, while not known
  std::array<PartEnds, longest_chunk> starts{};         // of the first part
};

FrozenColumn::Chunk::Chunk(FrozenColumn& frozen, const NodeUpdate& update,
                           std::span<const StepLoad> all_loads, const SignalWindow& window)
    : column(frozen), by(update), loads(all_loads) {
  windows.fill(SignalWindow::whole_column(column.node_count_));
  windows[0] = window;
  std::size_t before = column.now_;
  for (std::size_t t = 0; t < loads.size(); ++t) {
    const std::size_t after = (column.now_ + 1 + t % 2) % column.states_.size();
    turns[t] = {before, after};
    before = after;
  }
}

FrozenColumn::Chunk::Segment FrozenColumn::Chunk::segment(std::size_t mine, std::size_t all) const {
  const std::size_t parts = parts_in(windows[0].nodes);
  return {{parts * mine / all, parts * (mine + 1) / all}, mine == 0, mine + 1 == all};
}

void FrozenColumn::Chunk::step(std::size_t t, std::size_t part, std::size_t end,
                               StepSquares& squares) {
  const IndexRange nodes{part * part_nodes, std::min((part + 1) * part_nodes, end)};
  squares[t] = std::max(squares[t], column.step_part(turns[t], loads[t], by, nodes));
  if (part == 0) starts[t] = column.ends_[0];
}

// A part is the last one of a step only if the step before has come to its end, and then the window
// is known. All parts before are stepped whole.
void FrozenColumn::Chunk::climb(const Segment& segment, StepSquares& squares) {
  const auto first_part = [&](std::size_t t) {
    return segment.first ? segment.parts.first : segment.parts.first + t;
  };
  const auto end_of_parts = [&](std::size_t t) {
    return segment.last ? parts_in(windows[t].nodes) : segment.parts.last - t;
  };
  const std::size_t last_step = loads.size() - 1;
  for (std::size_t wave = segment.parts.first; wave < end_of_parts(last_step) + last_step; ++wave) {
    for (std::size_t t = 0; t <= last_step && wave >= first_part(t) + t; ++t) {
      const std::size_t part = wave - t;
      if (part >= end_of_parts(t)) continue;
      step(t, part, segment.last ? windows[t].nodes : column.node_count_, squares);
      if (part > first_part(t)) column.step_cell_behind(turns[t], part - 1);
      if (segment.last && part + 1 == end_of_parts(t)) end_step(t);
    }
  }
}

void FrozenColumn::Chunk::end_step(std::size_t t) {
  column.step_cell_behind(turns[t], parts_in(windows[t].nodes) - 1);
  const State& after = column.states_[turns[t].after];
  windows[t + 1] = windows[t];
  windows[t + 1].widen({after.solid_q.data(), column.node_count_},
                       {after.fluid_q.data(), column.node_count_});
}

void FrozenColumn::Chunk::fill(std::size_t border, StepSquares& squares) {
  for (std::size_t t = 0; t < loads.size(); ++t) {
    for (std::size_t part = border - t; part < border + t; ++part) {
      step(t, part, column.node_count_, squares);
      column.step_cell_behind(turns[t], part - 1);
    }
    column.step_cell_behind(turns[t], border + t - 1);
  }
}

void FrozenColumn::advance(const NodeUpdate& by, std::span<const StepLoad> loads,
                           SignalWindow& window, std::size_t threads) {
  Chunk chunk(*this, by, loads, window);
  const std::size_t most = parts_in(window.nodes) / (parts_of_thread_per_step * loads.size());
  threads = std::clamp<std::size_t>(most, 1, std::max<std::size_t>(threads, 1));
  std::vector<Chunk::StepSquares> squares(threads, Chunk::StepSquares{});
  if (threads > 1) {
#ifdef _OPENMP
#pragma omp parallel num_threads(static_cast <int>(threads))
    {
      const auto me = static_cast<std::size_t>(omp_get_thread_num());
      const auto all = static_cast<std::size_t>(omp_get_num_threads());
      const Chunk::Segment mine = chunk.segment(me, all);
      chunk.climb(mine, squares[me]);
#pragma omp barrier
      if (!mine.first) chunk.fill(mine.parts.first, squares[me]);
    }
#endif
  } else {  // a team of one thread would cost as much as 200 nodes
    chunk.climb(chunk.segment(0, 1), squares[0]);
  }
  undone_ = now_;
  undone_motion_ = motion_;
  now_ = chunk.turns[loads.size() - 1].after;
  window = chunk.windows[loads.size()];
  for (std::size_t t = 0; t < loads.size(); ++t) {
    double largest = 0.0;
    for (const Chunk::StepSquares& of_thread : squares) largest = std::max(largest, of_thread[t]);
    motion_.solid_first += constants_.time_step * chunk.starts[t].solid_first;
    motion_.fluid_first += constants_.time_step * chunk.starts[t].fluid_first;
    motion_.rise = constants_.time_step * std::sqrt(largest);
    motion_.bound += motion_.rise;
  }
}

std::size_t FrozenColumn::most_steps() const {
  const std::size_t reach = std::max(to_nodes_->reach(), to_cells_->reach());
  return reach + lanes < part_nodes ? longest_chunk : 1;
}

std::size_t FrozenColumn::steps_before(double limit) const {
  const double steps = 0.5 * (limit - motion_.bound) / motion_.rise;
  return steps < static_cast<double>(longest_chunk) ? static_cast<std::size_t>(std::max(steps, 0.0))
                                                    : longest_chunk;
}

// Ahead of the signal all states are zero; those that were written may have been wider.
void FrozenColumn::undo() {
  now_ = undone_;
  motion_ = undone_motion_;
  for (std::size_t k = 1; k < states_.size(); ++k) {
    states_[(now_ + k) % states_.size()] = at_rest();
  }
  std::fill(ends_.begin(), ends_.end(), PartEnds{});
}

}  // namespace porowave::solver
