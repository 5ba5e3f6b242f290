#pragma once

// Transfer weights as sparse rows: made once, used every step for as long as the points stay.
//
//   mls_rows     row = evaluation point, column = point: Φ_p(x), from points to nodes or
//                quadrature points
//   linear_rows  row = point, column = node: N_i(x_p) and ∂N_i/∂x_a(x_p), from nodes to points;
//                transposed it is the classical P2G

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/adaptive_support.hpp"
#include "solver/grid.hpp"
#include "solver/kernel.hpp"
#include "solver/mls.hpp"

namespace porowave::solver {

// Compressed sparse rows. Row r holds the entries row_offsets[r] ... row_offsets[r + 1] − 1.
struct SparseRows {
  std::vector<std::size_t> row_offsets{0};
  std::vector<std::int32_t> columns;
  std::vector<double> values;
  std::size_t column_count = 0;

  std::size_t row_count() const { return row_offsets.size() - 1; }
};

// out_r = Σ_c rows_rc in_c. Throws std::invalid_argument if a length does not fit; in and out must
// not overlap.
void multiply(const SparseRows& rows, std::span<const double> in, std::span<double> out);

// out_c = Σ_r rows_rc in_r, the transpose. Throws as multiply.
void multiply_transposed(const SparseRows& rows, std::span<const double> in, std::span<double> out);

// What happened while moving least squares rows were made.
struct MlsReport {
  std::size_t rows_of_reduced_order = 0;  // 0 <= order used < order asked for
  std::size_t rows_without_point = 0;     // empty rows: every product is zero there, which is no
                                          // approximation; the caller must decide
  std::size_t rows_of_enlarged_support = 0;
  double largest_radius = 0.0;          // over the rows with points, in the unit of coordinates
  double worst_condition = 0.0;         // over the rows with points, at the order used; >= 1
  std::vector<std::int8_t> order_used;  // per row; -1 without a point
};

// Φ_p at the evaluation points. Entries of a row are in the order of the cell list, zeros are
// left out. Radii of the support in the unit of the coordinates (not in h); a number is a fixed
// support of that radius. 0 <= basis_order <= 3. `report` is overwritten.
// Throws std::invalid_argument for arguments out of range and positions that are not finite.
template <int Dim>
SparseRows mls_rows(std::span<const Vector<Dim>> evaluation_points,
                    std::span<const Vector<Dim>> points, KernelName kernel, const Support& support,
                    int basis_order, MlsReport& report,
                    double max_condition = default_max_condition);

template <int Dim>
struct LinearRows {
  SparseRows values;                      // N_i(x_p)
  std::array<SparseRows, Dim> gradients;  // ∂N_i/∂x_a(x_p), in 1/length
};

// All 2^Dim entries are kept in every row, also those that are zero, so that the four structures
// agree. Throws std::invalid_argument if a point is not finite; points outside the grid are
// extrapolated (see Grid::linear_shape).
template <int Dim>
LinearRows<Dim> linear_rows(std::span<const Vector<Dim>> points, const Grid<Dim>& grid);

}  // namespace porowave::solver
