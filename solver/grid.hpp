#pragma once

// The background grid: equal cubic cells along the axes, and its linear shape functions N_i.
//
// Numbering: axis 0 runs fastest, for cells and for nodes. Corner c of a cell, 0 <= c < 2^Dim, lies
// on the upper side of axis a if bit a of c is set.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

#include "solver/vector.hpp"

namespace porowave::solver {

template <int Dim>
using CellIndex = Eigen::Matrix<int, Dim, 1>;

// N_i(x) and ∇N_i(x), in 1/length, of the nodes of one cell, in the order of its corners.
template <int Dim>
struct LinearShape {
  std::array<int, (std::size_t{1} << Dim)> nodes;
  std::array<double, (std::size_t{1} << Dim)> values;
  std::array<Vector<Dim>, (std::size_t{1} << Dim)> gradients;
};

template <int Dim>
struct Grid {
  static constexpr int corners = 1 << Dim;

  Vector<Dim> origin;    // lowest corner
  double spacing;        // h, the edge of a cell, in the unit of the coordinates
  CellIndex<Dim> cells;  // number of cells along each axis

  // Throws std::invalid_argument unless origin is finite, 0 < h < ∞, every axis has at least one
  // cell and the node numbers fit an int.
  Grid(const Vector<Dim>& origin_, double spacing_, const CellIndex<Dim>& cells_)
      : origin(origin_), spacing(spacing_), cells(cells_) {
    if (!origin.allFinite()) throw std::invalid_argument("grid: origin is not finite");
    if (!(spacing > 0.0) || !std::isfinite(spacing)) {
      throw std::invalid_argument("grid: spacing must be positive and finite");
    }
    double nodes = 1.0;
    for (int a = 0; a < Dim; ++a) {
      if (cells[a] < 1) throw std::invalid_argument("grid: an axis has no cell");
      nodes *= cells[a] + 1.0;
    }
    if (nodes > std::numeric_limits<int>::max())
      throw std::invalid_argument("grid: too many nodes");
  }

  int cell_count() const { return cells.prod(); }
  int node_count() const { return (cells.array() + 1).prod(); }

  int cell_number(const CellIndex<Dim>& cell) const { return number(cell, cells); }
  CellIndex<Dim> cell_index(int cell) const { return index(cell, cells); }

  int node_number(const CellIndex<Dim>& node) const { return number(node, node_sizes()); }
  CellIndex<Dim> node_index(int node) const { return index(node, node_sizes()); }

  // The node at a corner of a cell.
  int node_of(const CellIndex<Dim>& cell, int corner) const {
    return node_number(cell + corner_bits(corner));
  }

  Vector<Dim> node_position(int node) const {
    return origin + spacing * node_index(node).template cast<double>();
  }

  Vector<Dim> cell_centre(int cell) const {
    return origin +
           spacing * (cell_index(cell).template cast<double>() + Vector<Dim>::Constant(0.5));
  }

  // The cell that contains x; on a face the upper one, outside the grid the nearest one.
  // Monotone in every coordinate, also under rounding. A NaN goes to the first cell.
  CellIndex<Dim> cell_of(const Vector<Dim>& x) const {
    CellIndex<Dim> cell;
    for (int a = 0; a < Dim; ++a) {
      const double t = (x[a] - origin[a]) / spacing;
      cell[a] = t > 0.0 ? static_cast<int>(std::min(t, cells[a] - 1.0)) : 0;
    }
    return cell;
  }

  bool contains(const Vector<Dim>& x) const {
    const Vector<Dim> upper = origin + spacing * cells.template cast<double>();
    return (x.array() >= origin.array()).all() && (x.array() <= upper.array()).all();
  }

  // Linear shape functions of the cell of x. Outside the grid the functions of the nearest cell
  // are continued, so that linear fields stay reproduced (values then leave [0, 1]).
  LinearShape<Dim> linear_shape(const Vector<Dim>& x) const {
    const CellIndex<Dim> cell = cell_of(x);
    const Vector<Dim> t = (x - origin) / spacing - cell.template cast<double>();
    LinearShape<Dim> shape;
    for (int corner = 0; corner < corners; ++corner) {
      const CellIndex<Dim> upper = corner_bits(corner);
      double value = 1.0;
      Vector<Dim> gradient = Vector<Dim>::Ones();
      for (int a = 0; a < Dim; ++a) {
        const double factor = upper[a] == 1 ? t[a] : 1.0 - t[a];
        const double slope = (upper[a] == 1 ? 1.0 : -1.0) / spacing;
        for (int b = 0; b < Dim; ++b) gradient[b] *= (a == b) ? slope : factor;
        value *= factor;
      }
      const auto c = static_cast<std::size_t>(corner);
      shape.nodes[c] = node_of(cell, corner);
      shape.values[c] = value;
      shape.gradients[c] = gradient;
    }
    return shape;
  }

  // ∫ N_i dx over the grid: h^Dim, halved for every axis on whose end the node lies.
  double nodal_volume(int node) const {
    const CellIndex<Dim> i = node_index(node);
    double volume = 1.0;
    for (int a = 0; a < Dim; ++a) {
      volume *= (i[a] == 0 || i[a] == cells[a]) ? 0.5 * spacing : spacing;
    }
    return volume;
  }

 private:
  CellIndex<Dim> node_sizes() const { return cells + CellIndex<Dim>::Ones(); }

  static CellIndex<Dim> corner_bits(int corner) {
    CellIndex<Dim> bits;
    for (int a = 0; a < Dim; ++a) bits[a] = (corner >> a) & 1;
    return bits;
  }

  static int number(const CellIndex<Dim>& i, const CellIndex<Dim>& sizes) {
    int n = i[Dim - 1];
    for (int a = Dim - 2; a >= 0; --a) n = n * sizes[a] + i[a];
    return n;
  }

  static CellIndex<Dim> index(int n, const CellIndex<Dim>& sizes) {
    CellIndex<Dim> i;
    for (int a = 0; a < Dim; ++a) {
      i[a] = n % sizes[a];
      n /= sizes[a];
    }
    return i;
  }
};

}  // namespace porowave::solver
