#pragma once

// Neighbour search: points sorted by the cell they lie in (counting sort, O(points + cells)), and
// the points within a box |x_p − x|_∞ <= R.
//
// The order of an answer is fixed: cells in the order of their numbers, within a cell by ascending
// point index. Points outside the grid belong to the nearest cell and are found like any other.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <stdexcept>
#include <vector>

#include "solver/grid.hpp"

namespace porowave::solver {

template <int Dim>
class CellList {
 public:
  // Copies the positions (finite; std::invalid_argument otherwise). Build again after a move.
  CellList(std::span<const Vector<Dim>> points, const Grid<Dim>& grid)
      : grid_(grid),
        first_(static_cast<std::size_t>(grid.cell_count()) + 1, 0),
        index_(points.size()),
        position_(points.size()) {
    for (const Vector<Dim>& x : points) {
      if (!x.allFinite()) throw std::invalid_argument("cell list: a position is not finite");
      ++first_[cell_of(x) + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t p = 0; p < points.size(); ++p) {
      const std::size_t slot = next[cell_of(points[p])]++;
      index_[slot] = static_cast<std::int32_t>(p);
      position_[slot] = points[p];
    }
  }

  std::size_t size() const { return index_.size(); }

  // Calls f(point index, position) for every point in the closed box x ± radius, radius >= 0.
  template <class F>
  void for_each_in_box(const Vector<Dim>& x, double radius, F&& f) const {
    const Vector<Dim> low = x.array() - radius;
    const Vector<Dim> high = x.array() + radius;
    const CellIndex<Dim> first = grid_.cell_of(low);
    const CellIndex<Dim> last = grid_.cell_of(high);
    CellIndex<Dim> row = first;
    do {  // one row of cells along axis 0: contiguous in the sorted points
      CellIndex<Dim> row_end = row;
      row_end[0] = last[0];
      const std::size_t end = first_[cell_number(row_end) + 1];
      for (std::size_t s = first_[cell_number(row)]; s < end; ++s) {
        const Vector<Dim>& xp = position_[s];
        if ((xp.array() >= low.array()).all() && (xp.array() <= high.array()).all()) {
          f(index_[s], xp);
        }
      }
    } while (advance(row, first, last));
  }

  // The same as a list of point indices; clears `found` first.
  void query(const Vector<Dim>& x, double radius, std::vector<std::int32_t>& found) const {
    found.clear();
    for_each_in_box(x, radius, [&](std::int32_t p, const Vector<Dim>&) { found.push_back(p); });
  }

 private:
  std::size_t cell_number(const CellIndex<Dim>& cell) const {
    return static_cast<std::size_t>(grid_.cell_number(cell));
  }
  std::size_t cell_of(const Vector<Dim>& x) const { return cell_number(grid_.cell_of(x)); }

  // Next row of cells in the box [first, last]; false after the last one.
  static bool advance(CellIndex<Dim>& row, const CellIndex<Dim>& first,
                      const CellIndex<Dim>& last) {
    for (int a = 1; a < Dim; ++a) {
      if (row[a]++ < last[a]) return true;
      row[a] = first[a];
    }
    return false;
  }

  Grid<Dim> grid_;
  std::vector<std::size_t> first_;     // per cell, and one past the last
  std::vector<std::int32_t> index_;    // sorted by cell
  std::vector<Vector<Dim>> position_;  // in the same order
};

// The grid around the points whose cells are at least `width` wide (> 0), and wider where that
// would make more cells than about two a point. Throws as Grid does, and if a position is not
// finite.
template <int Dim>
Grid<Dim> grid_around(std::span<const Vector<Dim>> points, double width) {
  if (!(width > 0.0)) throw std::invalid_argument("grid around points: width must be positive");
  if (points.empty()) return {Vector<Dim>::Zero(), width, CellIndex<Dim>::Ones()};
  Vector<Dim> low = points.front();
  Vector<Dim> high = points.front();
  for (const Vector<Dim>& x : points) {
    if (!x.allFinite()) throw std::invalid_argument("grid around points: a position is not finite");
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const auto cells = [&]() -> Vector<Dim> { return ((high - low) / width).array().floor() + 1.0; };
  while (cells().prod() > 2.0 * static_cast<double>(points.size()) + 1.0) width *= 2.0;
  return {low, width, cells().template cast<int>()};
}

}  // namespace porowave::solver
