#pragma once

// The transfer between the points of one phase and the grid, as linear operators. Made once for the
// points where they are; every step applies them.
//
//   nodal mass           m_i = ∫ N_i ρ dx
//   nodal velocity       v_i = Σ_p Φ_p(x_i) v_p
//   internal force       f_i = −Σ_q w_q ∂N_i(x_q) s(x_q),  s(x_q) = Σ_p Φ_p(x_q) s_p
//   points               u_p = Σ_i N_i(x_p) u_i, and gradients with ∂N_i(x_p)
//
//   shape   quadrature points are the material points themselves (w_q their volume, s(x_q) = s_p);
//           Φ_p(x_i) = m_p N_i(x_p)/m_i, m_i = Σ_p m_p N_i(x_p)           (Sulsky et al. 1994)
//   mls     quadrature points are the cell middles, Φ_p moving least squares, ρ as well: its nodal
//           value times the volume of the node                             (Chmelnizkij 2023)
//   apic    as shape, but every point carries the gradient C_p of its velocity as well, and
//           gradients of N_i are replaced by those of a local linear fit (apic.hpp)
//
// A node that no point reaches has mass zero; a cell middle that none reaches has s = 0 (vacuum).

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "solver/case.hpp"
#include "solver/grid.hpp"
#include "solver/weights.hpp"

namespace porowave::solver {

template <int Dim>
struct PointSet {
  std::vector<Vector<Dim>> x;
  std::vector<double> volume;
  std::vector<double> mass;
  std::vector<double> domain = {};  // edge of the domain of gimp and cpgimp; may else be empty
};

// Φ as sparse rows, columns are the points. `to_quadrature` is empty for shape.
struct TransferRows {
  SparseRows to_nodes;
  SparseRows to_quadrature;
};

// What a transfer is made for. `compact_form` leaves out the rows of points that this form of a
// step (column_operators.hpp) has no use for, half of all memory: to_points and gradient_at_points
// then throw std::invalid_argument.
enum class TransferUse { all, compact_form };

template <int Dim>
class Transfer {
 public:
  // Throws std::invalid_argument for positions that are not finite, and for recovered strains in
  // more than one dimension.
  Transfer(const PointSet<Dim>& points, const Grid<Dim>& grid, const Discretization& choice,
           TransferUse use = TransferUse::all);

  // Kilograms (per unit area in 1D); zero where no point reaches the node.
  const std::vector<double>& nodal_mass() const { return nodal_mass_; }
  // The part of the node's volume that the phase fills.
  const std::vector<double>& nodal_volume() const { return nodal_volume_; }

  // v_i from v_p; zero where no point reaches the node.
  void to_nodes(std::span<const double> point_values, std::span<double> nodal_values) const;
  // For apic: adds what the gradients C_p along an axis contribute to v_i. No effect otherwise.
  void add_affine(std::span<const double> point_slopes, int axis,
                  std::span<double> nodal_values) const;
  // s at the quadrature points from s_p.
  void to_quadrature(std::span<const double> point_values, std::vector<double>& values) const;
  // Adds factor * Σ_q w_q ∂N_i/∂x_axis(x_q) s(x_q) to f_i.
  void add_divergence(std::span<const double> quadrature_values, double factor, int axis,
                      std::span<double> nodal_force) const;
  // Σ_i N_i(x_p) u_i and Σ_i ∂N_i/∂x_axis(x_p) u_i.
  void to_points(std::span<const double> nodal_values, std::span<double> point_values) const;
  void gradient_at_points(std::span<const double> nodal_values, int axis,
                          std::span<double> point_values) const;

  // The phase's stress in the middle of every cell, as the scheme sees it: for mls the quadrature
  // values, for shape the mean over the points of the cell (zero without points).
  std::vector<double> at_cell_centres(std::span<const double> point_values) const;

  // Evaluations of moving least squares that had to lower the order; and those without any point.
  std::size_t reduced_rows() const { return reduced_rows_; }
  std::size_t empty_rows() const { return empty_rows_; }

  // Hands the rows over to a faster form of the same operators.
  TransferRows take_rows() && { return {std::move(node_rows_), std::move(quadrature_rows_)}; }

 private:
  void build_shape(const PointSet<Dim>& points, const Grid<Dim>& grid);
  void build_mls(const PointSet<Dim>& points, const Grid<Dim>& grid, const Discretization& choice);

  std::vector<bool> reached_cells() const;  // their stress is known
  void build_shared_strain(const PointSet<Dim>& points, const Grid<Dim>& grid,
                           const Discretization& choice);

  LinearRows<Dim> linear_at_points_;      // or of the shape functions chosen
  SparseRows strain_rows_;                // gradients at the points from nodes; empty: ∂N_i
  SparseRows node_rows_;                  // nodes from points
  SparseRows quadrature_rows_;            // quadrature points from points; empty for shape
  LinearRows<Dim> linear_at_quadrature_;  // empty for shape
  std::vector<double> quadrature_weight_;
  std::array<std::vector<double>, Dim> affine_mass_;  // m_p D_p for apic, else empty
  std::vector<double> nodal_mass_;
  std::vector<double> nodal_volume_;
  std::vector<int> cell_of_point_;  // shape only
  std::size_t cell_count_;
  std::size_t reduced_rows_ = 0;
  std::size_t empty_rows_ = 0;
};

}  // namespace porowave::solver
