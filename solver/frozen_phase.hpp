#pragma once

// A phase without its points. While the weights stay and the material is linear, everything that a
// step does to points is a combination of shape functions:
//
//   v_p = φ v_p⁰ + Σ_i N_i(x_p) q_i        q ← flip (q − v) + v',  φ ← flip φ
//   s_p = s_p⁰ + e(cell of p)              e ← e + c (b_(i+1) − b_i)/h
//
// with flip, v, v', b, c of PointUpdate. So the nodes need only q and the cells' e:
//
//   v_i = φ Σ_p Φ_p(x_i) v_p⁰ + (W q)_i,  W = Φ N      S_c = S_c⁰ + (B e)_c,  B = Φ (cell of p)
//
// The strain of a cell stands for ∂N u: summed in the cell it does not lose the digits that the
// difference of large displacements would. Points are made up for when they are asked for.

#include <memory>
#include <span>
#include <vector>

#include "solver/banded_rows.hpp"
#include "solver/compact_operators.hpp"

namespace porowave::solver {

// W and B, made once for the points where they are.
struct FrozenOperators {
  explicit FrozenOperators(const CompactOperators& compact);

  BandedRows nodes;  // W
  BandedRows cells;  // B
  double spacing;
};

class FrozenPhase {
 public:
  // From the values of all points, which stay the caller's.
  FrozenPhase(std::shared_ptr<const ColumnOperators> points, std::span<const double> velocity,
              std::span<const double> stress);

  // Whether a phase with these operators can be frozen.
  static bool possible(const ColumnOperators& points);

  // As those of ColumnOperators.
  void gather(Range nodes, double* nodal_velocity, double* force) const;
  void scatter(const PointUpdate& update, Range cells);
  // To be called once after every step.
  void end_step(double flip) { kept_ *= flip; }

  // Brings velocities and stresses of all points, as they were at the start, up to now.
  void settle(std::span<double> velocity, std::span<double> stress) const;

  // Whether all points had neither velocity nor stress when they were frozen.
  bool started_at_rest() const { return first_velocity_.empty() && first_stress_.empty(); }
  // What settle would add, q of the nodes and e of the cells; bounds for points that started at
  // rest.
  std::span<const double> node_values() const { return {node_values_.data(), node_count_}; }
  std::span<const double> cell_values() const { return {cell_values_.data(), node_count_ - 1}; }

 private:
  std::shared_ptr<const CompactOperators> points_;
  std::shared_ptr<const FrozenOperators> operators_;
  std::size_t node_count_;
  PaddedValues node_values_;  // q, m/s
  PaddedValues cell_values_;  // e, Pa
  double kept_ = 1.0;         // φ
  // Contribution of the points' first values; empty where they are all zero.
  std::vector<double> first_velocity_;
  std::vector<double> first_stress_;
};

}  // namespace porowave::solver
