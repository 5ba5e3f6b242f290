#include "solver/strain_recovery.hpp"

#include <cmath>
#include <stdexcept>

namespace porowave::solver {

namespace {

// A point's strain: `share` of the difference between the strain of cell `other` and of its own.
struct Mix {
  int other;
  double share;
};

class Sharing {
 public:
  Sharing(std::span<const Vector<1>> points, const Grid<1>& grid,
          const std::vector<bool>& is_material, StrainSharing rule)
      : grid_(grid), is_material_(is_material), has_points_(is_material.size()), rule_(rule) {
    for (const Vector<1>& x : points) {
      has_points_[static_cast<std::size_t>(grid.cell_of(x)[0])] = true;
    }
  }

  Mix at(int cell, double t) const {
    const int side = t < 0.5 ? -1 : 1;
    const double s = std::abs(t - 0.5);
    const int next = cell + side;
    if (rule_ == StrainSharing::lend_empty) {
      const bool lends = counts(next) && !has_points_[static_cast<std::size_t>(next)];
      return {next, lends ? s : 0.0};
    }
    if (counts(next)) return {next, s};
    return {cell - side, counts(cell - side) ? -s : 0.0};
  }

 private:
  bool counts(int cell) const {
    return cell >= 0 && cell < grid_.cells[0] && is_material_[static_cast<std::size_t>(cell)];
  }

  const Grid<1>& grid_;
  const std::vector<bool>& is_material_;
  std::vector<bool> has_points_;
  StrainSharing rule_;
};

// Appends factor * (u_{c+1} − u_c)/h.
void append_strain(SparseRows& rows, int cell, double factor, double spacing) {
  for (const int side : {0, 1}) {
    rows.columns.push_back(cell + side);
    rows.values.push_back((side == 0 ? -factor : factor) / spacing);
  }
}

}  // namespace

SparseRows shared_strain_rows(std::span<const Vector<1>> points, const Grid<1>& grid,
                              const std::vector<bool>& is_material, StrainSharing rule) {
  if (is_material.size() != static_cast<std::size_t>(grid.cell_count())) {
    throw std::invalid_argument("strain recovery: one flag a cell");
  }
  for (const Vector<1>& x : points) {
    if (!x.allFinite()) throw std::invalid_argument("strain recovery: a position is not finite");
  }
  const Sharing sharing(points, grid, is_material, rule);
  SparseRows rows;
  rows.column_count = static_cast<std::size_t>(grid.node_count());
  for (const Vector<1>& x : points) {
    const int cell = grid.cell_of(x)[0];
    const double t = (x[0] - grid.origin[0]) / grid.spacing - cell;
    const Mix mix = sharing.at(cell, t);
    append_strain(rows, cell, 1.0 - mix.share, grid.spacing);
    if (mix.share != 0.0) append_strain(rows, mix.other, mix.share, grid.spacing);
    rows.row_offsets.push_back(rows.columns.size());
  }
  return rows;
}

}  // namespace porowave::solver
