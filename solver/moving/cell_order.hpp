#pragma once

// Points of one phase in the order of the cells: sorted along the grid, and the first point of
// every cell. A velocity that is one function of the place never lets points overtake each other,
// so as they move only the bounds between the cells pass over points: a renewal costs a look at
// every cell and one at every point that has changed its cell. Points that are not sorted (as they
// were placed, or swapped by rounding) are sorted first.

#include <cstddef>
#include <span>
#include <vector>

#include "solver/range_rows.hpp"
#include "solver/vector.hpp"

namespace porowave::solver {

// The order that sorts x, stable; empty if it is sorted.
std::vector<std::size_t> order_along(std::span<const Vector<1>> x);

template <class T>
void reorder(const std::vector<std::size_t>& order, std::vector<T>& values) {
  if (order.empty()) return;
  const std::vector<T> old = values;
  for (std::size_t k = 0; k < order.size(); ++k) values[k] = old[order[k]];
}

class CellOrder {
 public:
  // Finds the points of the cells [first_cell, first_cell + cells) of the endless grid with nodes
  // at i h (m), starting from what was there before. A point on a node is in the cell above it. The
  // points must be sorted, finite, and as many as before; those outside of the cells belong to the
  // first or last one. Gives the number of times that a point passed a bound between cells.
  std::size_t renew(std::span<const Vector<1>> x, double spacing, long first_cell,
                    std::size_t cells);

  // Points [first, last) of a cell, by its number in the endless grid.
  IndexRange points_of(long cell) const {
    const auto c = static_cast<std::size_t>(cell - first_cell_);
    return {first_point_[c], first_point_[c + 1]};
  }

 private:
  long first_cell_ = 0;
  std::vector<std::size_t> first_point_;  // of every cell, and the number of points
};

}  // namespace porowave::solver
