#pragma once

// One phase of a staggered column: velocities at nodes, stresses at cell middles, and how both pass
// through the points. Arrays of velocities have an entry a node. Arrays of stresses (effective
// stress, or pore pressure) have that of cell c at index c + 1, between the values at both ends of
// the column, which count where the end prescribes them.

#include <array>
#include <cstddef>
#include <vector>

#include "solver/case.hpp"
#include "solver/column_solver.hpp"
#include "solver/placement.hpp"
#include "solver/staggered/band_matrix.hpp"
#include "solver/staggered/cubic_line.hpp"

namespace porowave::solver {

class PhaseLines {
 public:
  // The column at rest. Throws BreakdownError if a node or cell middle is out of reach of every
  // point of the phase.
  PhaseLines(const Case& scene, Phase phase, double spacing);

  // Velocity and stress of the nodes and cells before `end`, from what the points hold.
  void reconstruct(std::size_t end);
  // ∂stress at the nodes and ∂velocity in the cells before `end` (1/length).
  void stress_slopes(const std::vector<double>& stress, std::vector<double>& slopes,
                     std::size_t end) const;
  void velocity_slopes(const std::vector<double>& velocity, std::vector<double>& slopes,
                       std::size_t end) const;
  // A stress continued to x = 0 by the cubic through what is nearest.
  double stress_at_near_end(const std::vector<double>& stress) const;

  // The points: their values, and their places moved by the displacement.
  PhasePoints points() const;
  std::size_t point_count() const { return x_.size(); }
  std::size_t reduced_rows() const { return reduced_rows_; }

  std::vector<double> velocity_sum;  // sums of all increments: what the points hold, by
  std::vector<double> stress_sum;    // interpolation
  std::vector<double> displacement;  // of the nodes, m
  std::vector<double> velocity;      // reconstructed from the points
  std::vector<double> stress;

 private:
  BandMatrix through_points(const Case& scene, const CubicLine& line, double first,
                            std::size_t places, std::size_t values);

  std::size_t cells_;
  double spacing_;
  std::size_t reduced_rows_ = 0;
  std::vector<double> x_;       // where the points started
  std::vector<double> volume_;  // m
  CubicLine velocity_line_;
  CubicLine stress_line_;
  BandMatrix velocity_through_points_;
  BandMatrix stress_through_points_;
  std::array<CubicRow, 4> stress_slope_rows_;    // at the nodes 0, 1, last − 1 and last
  std::array<CubicRow, 2> velocity_slope_rows_;  // in the first and the last cell
  CubicRow near_end_row_;
};

// Σ_j weight_j values_index_j
double at(const CubicRow& row, const std::vector<double>& values);

}  // namespace porowave::solver
