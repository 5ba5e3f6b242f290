#pragma once

// A banded operator as the product of two others: nodes (or cells) ← points ← nodes (or cells).
// With it the points in between need not be visited.
//
// Rows come in blocks of 256. A block stores its band by diagonals, as wide as its own rows need,
// so that the loop over rows needs no index and a place with a wide support costs only there.

#include <cstddef>
#include <functional>
#include <vector>

#include "solver/range_rows.hpp"
#include "solver/simd.hpp"

namespace porowave::solver {

// Values with room before the first and after the last one that is always zero: a band may reach
// over the ends.
class PaddedValues {
 public:
  PaddedValues() = default;
  PaddedValues(std::size_t count, std::size_t padding)
      : padding_((padding + 7) / 8 * 8), values_(count + 2 * padding_, 0.0) {}
  double* data() { return values_.data() + padding_; }
  const double* data() const { return values_.data() + padding_; }

 private:
  std::size_t padding_ = 0;
  LineVector values_;
};

class BandedRows {
 public:
  static constexpr std::size_t block_rows = 256;
  static constexpr std::size_t lanes = 8;

  BandedRows() = default;
  // outer × inner; inner(p) is the row of point p.
  BandedRows(const RangeRows& outer, const std::function<PointRow(std::size_t)>& inner);

  // How far a row reaches beyond its own number, to either side.
  std::size_t reach() const { return reach_; }
  std::size_t row_count() const { return row_count_; }
  // Diagonals of a block: lowest column minus row, and how many.
  struct Band {
    int lowest;
    int width;
  };
  Band band(std::size_t block) const { return {blocks_[block].lowest, blocks_[block].width}; }
  // The value of a row on a diagonal (column minus row); zero outside the band.
  double value(std::size_t row, int diagonal) const;
  // out[k] = row (rows.first + k) times `in`, which must be padded by reach() at least.
  void multiply(IndexRange rows, const double* in, double* out) const;

 private:
  struct Block {
    int lowest;  // column of the first diagonal minus row
    int width;
    std::size_t first_value;
  };
  Block band_of(const RangeRows& outer, const std::function<PointRow(std::size_t)>& inner,
                IndexRange rows) const;

  std::vector<Block> blocks_;
  std::vector<double> values_;  // per block, per eight rows: diagonal by diagonal
  std::size_t row_count_ = 0;
  std::size_t reach_ = 0;
};

inline constexpr std::size_t lanes = BandedRows::lanes;
inline constexpr std::size_t eights_of_block = BandedRows::block_rows / lanes;

}  // namespace porowave::solver
