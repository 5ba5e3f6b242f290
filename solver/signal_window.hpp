#pragma once

// The nodes that are stepped: the first ones, up to a little ahead of the signal. Velocities beyond
// would be below `negligible`.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace porowave::solver {

struct SignalWindow {
  static constexpr std::size_t growth = 16;  // nodes at a time, and a guard

  std::size_t nodes;       // so many are stepped
  std::size_t node_count;  // of the column
  std::size_t guard;       // nodes that a signal can cross in a step, at most
  double negligible;       // m/s

  static SignalWindow at_rest(std::size_t node_count, std::size_t guard, double negligible) {
    return {std::min(node_count, growth + guard), node_count, guard, negligible};
  }
  static SignalWindow whole_column(std::size_t node_count) {
    return {node_count, node_count, 0, 0.0};
  }

  // After a step, from what all nodes have of it: wider if the signal has come close to the end.
  void widen(std::span<const double> solid_velocity, std::span<const double> fluid_velocity) {
    if (nodes == node_count) return;
    for (std::size_t i = nodes - std::min(nodes, guard); i < nodes; ++i) {
      if (std::abs(solid_velocity[i]) <= negligible && std::abs(fluid_velocity[i]) <= negligible) {
        continue;
      }
      nodes = std::min(node_count, nodes + growth + guard);
      return;
    }
  }
};

}  // namespace porowave::solver
