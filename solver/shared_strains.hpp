#pragma once

// The strains of points that share those of two cells (strain_recovery.hpp), for sorted points:
// with t the place of a point in its cell c, e_c the cell's strain and D the difference of strains
// across the lower or the upper end of the cell,
//
//   strain = e_c + (t − 1/2) D
//
// Which end that is, if any, is the same for all points of a half of a cell: two small numbers a
// cell instead of a row of weights a point.

#include <cstdint>
#include <vector>

#include "solver/range_rows.hpp"

namespace porowave::solver {

class SharedStrains {
 public:
  SharedStrains() = default;
  // From the rows of the points. first_point: of every cell, and the number of points; place: of
  // every point in its cell, 0 to 1.
  SharedStrains(const SparseRows& strain_rows, const std::vector<std::size_t>& first_point,
                const std::vector<double>& place);

  // Whether no point shares anything: strains are those of the cells.
  bool empty() const { return ends_.empty(); }
  // A point's strain as a row over cells.
  PointRow row(std::size_t cell, double place) const;
  // s_p ← s_p + factor · strain for the points of the cells [cells.first, cells.last), where the
  // strain of a cell is the difference of b across it; b belongs to node cells.first.
  void add(IndexRange cells, const std::vector<std::size_t>& first_point, const double* place,
           const double* b, double factor, double* s) const;

 private:
  // −1 the lower end, 1 the upper one, 0 none; for the points below and above the middle.
  struct Ends {
    std::int8_t below = 0;
    std::int8_t above = 0;
  };
  std::vector<Ends> ends_;
};

}  // namespace porowave::solver
