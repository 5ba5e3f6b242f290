#include "solver/range_rows.hpp"

#include <algorithm>
#include <utility>

#include "solver/simd.hpp"

namespace porowave::solver {

namespace {

POROWAVE_INLINE double dot(const double* a, const double* b, std::size_t count) {
  Four sums = {0.0, 0.0, 0.0, 0.0};
  std::size_t k = 0;
  for (; k + 4 <= count; k += 4) {
    Four from_a, from_b;
    read(a + k, from_a);
    read(b + k, from_b);
    sums += from_a * from_b;
  }
  double rest = 0.0;
  for (; k < count; ++k) rest += a[k] * b[k];
  return (sums[0] + sums[2]) + (sums[1] + sums[3]) + rest;
}

bool without_gaps(const SparseRows& rows) {
  for (std::size_t r = 0; r < rows.row_count(); ++r) {
    for (std::size_t k = rows.row_offsets[r] + 1; k < rows.row_offsets[r + 1]; ++k) {
      if (rows.columns[k] != rows.columns[k - 1] + 1) return false;
    }
  }
  return true;
}

void append_filled(const SparseRows& rows, std::size_t r, RangeRows& to) {
  const auto begin = rows.columns.begin() + static_cast<std::ptrdiff_t>(rows.row_offsets[r]);
  const auto end = rows.columns.begin() + static_cast<std::ptrdiff_t>(rows.row_offsets[r + 1]);
  if (begin != end) {
    const auto [low, high] = std::minmax_element(begin, end);
    to.values.resize(to.values.size() + static_cast<std::size_t>(*high - *low) + 1, 0.0);
    to.first_column.push_back(*low);
    for (std::size_t k = rows.row_offsets[r]; k < rows.row_offsets[r + 1]; ++k) {
      to.values[to.row_offsets.back() + static_cast<std::size_t>(rows.columns[k] - *low)] +=
          rows.values[k];
    }
  } else {
    to.first_column.push_back(0);
  }
  to.row_offsets.push_back(to.values.size());
}

}  // namespace

RangeRows range_rows(SparseRows&& rows) {
  RangeRows result;
  result.first_column.reserve(rows.row_count());
  if (!without_gaps(rows)) {
    result.row_offsets.reserve(rows.row_offsets.size());
    result.values.reserve(rows.values.size());
    for (std::size_t r = 0; r < rows.row_count(); ++r) append_filled(rows, r, result);
    return result;
  }
  for (std::size_t r = 0; r < rows.row_count(); ++r) {
    const bool empty = rows.row_offsets[r] == rows.row_offsets[r + 1];
    result.first_column.push_back(empty ? 0 : rows.columns[rows.row_offsets[r]]);
  }
  result.row_offsets = std::move(rows.row_offsets);
  rows.columns = {};
  result.values = std::move(rows.values);
  // Not for a little: it takes a second copy.
  if (result.values.capacity() > result.values.size() * 5 / 4) result.values.shrink_to_fit();
  return result;
}

POROWAVE_VECTORISED void multiply(const RangeRows& rows, IndexRange rows_wanted, const double* in,
                                  double* out) {
  const std::size_t* offsets = rows.row_offsets.data();
  const std::int32_t* first = rows.first_column.data();
  const double* values = rows.values.data();
  for (std::size_t r = rows_wanted.first; r < rows_wanted.last; ++r) {
    out[r - rows_wanted.first] =
        dot(values + offsets[r], in + first[r], offsets[r + 1] - offsets[r]);
  }
}

}  // namespace porowave::solver
