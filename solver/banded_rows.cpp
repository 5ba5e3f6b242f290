#include "solver/banded_rows.hpp"

#include <algorithm>
#include <cstdlib>

namespace porowave::solver {

namespace {

// Row r of a block, one value at a time.
POROWAVE_INLINE double one_row(std::size_t width, const double* values, const double* in,
                               std::size_t r) {
  double sum = 0.0;
  const double* row = values + r / lanes * width * lanes + r % lanes;
  for (std::size_t k = 0; k < width; ++k) sum += row[k * lanes] * in[r + k];
  return sum;
}

// Rows [rows.first, rows.last) of a block; `in` and `out` belong to its row 0. Width 0 stands for
// one that is known only at run time.
template <std::size_t Width>
POROWAVE_INLINE void multiply_rows(std::size_t any_width, const double* __restrict values,
                                   const double* __restrict in, IndexRange rows,
                                   double* __restrict out) {
  const std::size_t width = Width > 0 ? Width : any_width;
  std::size_t r = rows.first;
  for (; r < rows.last && r % lanes != 0; ++r) out[r] = one_row(width, values, in, r);
  const double* row = values + r * width;
  for (; r + lanes <= rows.last; r += lanes, row += width * lanes) {
    Eight sum = {};
    for (std::size_t k = 0; k < width; ++k) {
      Eight value, there;
      read(row + k * lanes, value);
      read(in + r + k, there);
      sum += value * there;
    }
    write(sum, out + r);
  }
  for (; r < rows.last; ++r) out[r] = one_row(width, values, in, r);
}

// The sum of a row is taken in the order of its columns, whatever the form.
POROWAVE_VECTORISED void multiply_block(std::size_t width, const double* values, const double* in,
                                        IndexRange rows, double* out) {
  switch (width) {
    case 1:
      return multiply_rows<1>(width, values, in, rows, out);
    case 2:
      return multiply_rows<2>(width, values, in, rows, out);
    case 3:
      return multiply_rows<3>(width, values, in, rows, out);
    case 4:
      return multiply_rows<4>(width, values, in, rows, out);
    case 5:
      return multiply_rows<5>(width, values, in, rows, out);
    case 6:
      return multiply_rows<6>(width, values, in, rows, out);
    case 7:
      return multiply_rows<7>(width, values, in, rows, out);
    default:
      return multiply_rows<0>(width, values, in, rows, out);
  }
}

}  // namespace

BandedRows::Block BandedRows::band_of(const RangeRows& outer,
                                      const std::function<PointRow(std::size_t)>& inner,
                                      IndexRange rows) const {
  int lowest = 0;
  int highest = 0;
  for (std::size_t r = rows.first; r < rows.last; ++r) {
    const IndexRange points = outer.columns(r);
    for (std::size_t p = points.first; p < points.last; ++p) {
      const int first = inner(p).first - static_cast<int>(r);
      lowest = std::min(lowest, first);
      highest = std::max(highest, inner(p).values[1] == 0.0 ? first : first + 1);
    }
  }
  return {lowest, highest - lowest + 1, values_.size()};
}

BandedRows::BandedRows(const RangeRows& outer, const std::function<PointRow(std::size_t)>& inner)
    : row_count_(outer.row_count()) {
  for (std::size_t begin = 0; begin < outer.row_count(); begin += block_rows) {
    const IndexRange rows{begin, std::min(begin + block_rows, outer.row_count())};
    const Block block = band_of(outer, inner, rows);
    blocks_.push_back(block);
    const auto width = static_cast<std::size_t>(block.width);
    values_.resize(values_.size() + width * block_rows, 0.0);
    const auto farthest = std::max(-block.lowest, block.lowest + block.width - 1);
    reach_ = std::max(reach_, static_cast<std::size_t>(farthest));
    for (std::size_t r = rows.first; r < rows.last; ++r) {
      const IndexRange points = outer.columns(r);
      for (std::size_t p = points.first; p < points.last; ++p) {
        const double weight = outer.values[outer.row_offsets[r] + p - points.first];
        const PointRow row = inner(p);
        const auto diagonal =
            static_cast<std::size_t>(row.first - static_cast<int>(r) - block.lowest);
        const std::size_t k = r - begin;
        double* value =
            values_.data() + block.first_value + (k / lanes * width + diagonal) * lanes + k % lanes;
        value[0] += weight * row.values[0];
        if (row.values[1] != 0.0) value[lanes] += weight * row.values[1];
      }
    }
  }
}

double BandedRows::value(std::size_t row, int diagonal) const {
  const Block& block = blocks_[row / block_rows];
  if (diagonal < block.lowest || diagonal >= block.lowest + block.width) return 0.0;
  const std::size_t k = row % block_rows;
  const auto d = static_cast<std::size_t>(diagonal - block.lowest);
  const auto width = static_cast<std::size_t>(block.width);
  return values_[block.first_value + (k / lanes * width + d) * lanes + k % lanes];
}

void BandedRows::multiply(IndexRange rows, const double* in, double* out) const {
  for (std::size_t r = rows.first; r < rows.last;) {
    const std::size_t begin = r / block_rows * block_rows;
    const std::size_t end = std::min(begin + block_rows, rows.last);
    const Block& block = blocks_[r / block_rows];
    multiply_block(
        static_cast<std::size_t>(block.width), values_.data() + block.first_value,
        in + static_cast<std::ptrdiff_t>(begin) + block.lowest, {r - begin, end - begin},
        out + (static_cast<std::ptrdiff_t>(begin) - static_cast<std::ptrdiff_t>(rows.first)));
    r = end;
  }
}

}  // namespace porowave::solver
