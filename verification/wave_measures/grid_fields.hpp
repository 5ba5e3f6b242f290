#pragma once

#include <array>
#include <span>

#include "solver/column_solver.hpp"
#include "verification/field_errors.hpp"

namespace porowave::verification {

/// The four fields on a grid of n cells, in the order of field_names: stresses at the n middles of
/// cells, velocities at the n + 1 nodes; Pa and m/s.
using GridFields = std::array<std::span<const double>, 4>;

inline GridFields grid_fields(const solver::Snapshot& s) {
  return {s.effective_stress, s.pore_pressure, s.solid_velocity, s.fluid_velocity};
}

inline GridFields grid_fields(const ReferenceValues& values) {
  return {values.field[0], values.field[1], values.field[2], values.field[3]};
}

/// Length of a cell, m.
inline double spacing(const solver::Snapshot& s) {
  return (s.node_x.back() - s.node_x.front()) / static_cast<double>(s.cell_x.size());
}

}  // namespace porowave::verification
