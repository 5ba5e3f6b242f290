#pragma once

// Sparse rows whose columns are neighbours: the weights of sorted points in one dimension. A row
// keeps its first column and its values, so a product reads both operands straight through.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/weights.hpp"

namespace porowave::solver {

// Rows or columns [first, last).
struct IndexRange {
  std::size_t first;
  std::size_t last;

  std::size_t size() const { return last - first; }
};

// Up to two entries of a row: columns first and first + 1.
struct PointRow {
  int first;
  std::array<double, 2> values;
};

struct RangeRows {
  std::vector<std::size_t> row_offsets{0};  // row r holds values row_offsets[r] ...
  std::vector<std::int32_t> first_column;
  std::vector<double> values;

  std::size_t row_count() const { return first_column.size(); }
  IndexRange columns(std::size_t row) const {
    const auto first = static_cast<std::size_t>(first_column[row]);
    return {first, first + row_offsets[row + 1] - row_offsets[row]};
  }
};

// The same operator; gaps between the columns of a row are filled by zeros. Takes the rows over, so
// that rows without gaps cost no second copy of their values.
RangeRows range_rows(SparseRows&& rows);

// out[k] = Σ_c rows_(r,c) in_c for r = rows_wanted.first + k. Four partial sums a row, always in
// the same order. `in` must be as long as the rows are wide, `out` as long as the range.
void multiply(const RangeRows& rows, IndexRange rows_wanted, const double* in, double* out);

}  // namespace porowave::solver
