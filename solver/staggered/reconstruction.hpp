#pragma once

// What a field at regular places becomes on its way through the points: Φ L, with L the cubic
// interpolation to the points and Φ moving least squares from the points back to regular places.
// Points that keep their weights hold L q for ever, q the sum of all increments, so that a step
// needs Φ L only.

#include <cstddef>
#include <vector>

#include "solver/kernel.hpp"
#include "solver/staggered/band_matrix.hpp"
#include "solver/staggered/cubic_line.hpp"
#include "solver/weights.hpp"

namespace porowave::solver {

// Moving least squares whose support is enlarged, place by place and by a tenth at a time, where
// the points are too few or stand too badly to carry the order.
struct AdaptiveBasis {
  KernelName kernel;
  double support_radius;  // in the unit of the coordinates; at most 8 times this is used
  int order;              // 0 to 3
};

struct AdaptiveRows {
  SparseRows rows;           // Φ_p(x), a row a place
  std::size_t enlarged = 0;  // places that needed more than support_radius
  std::size_t reduced = 0;   // places of lower order even with the largest support
  std::size_t empty = 0;     // places that no point reaches even then
};

// Throws as mls_rows.
AdaptiveRows adaptive_rows(const std::vector<double>& places, const std::vector<double>& points,
                           const AdaptiveBasis& basis);

// How many values the line has, and which diagonals hold the most (see BandMatrix).
struct BandShape {
  std::size_t columns;
  std::size_t shift;
  std::size_t half_width;
};

// Φ L: a row a place, a column a value of the line. `phi` is for these points.
BandMatrix through(const SparseRows& phi, const std::vector<double>& points, const CubicLine& line,
                   const BandShape& shape);

}  // namespace porowave::solver
