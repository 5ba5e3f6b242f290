#pragma once

// The banded operators of both phases side by side, so that one pass over the rows serves both. If
// both phases have the same operator, its values are read once.

#include <memory>
#include <vector>

#include "solver/banded_rows.hpp"

namespace porowave::solver {

class BandedPair {
 public:
  BandedPair() = default;
  // Of the same number of rows, filled up to `rows` by zeros; pass one object twice for a shared
  // operator.
  BandedPair(const std::shared_ptr<const BandedRows>& solid,
             const std::shared_ptr<const BandedRows>& fluid, std::size_t rows);

  // How far a row reaches beyond its own number, to either side.
  std::size_t reach() const { return reach_; }
  // The rows 8 eights.first ... 8 eights.last − 1, all of one block of BandedRows::block_rows.
  // `in` belongs to row 0 and must be padded by reach(), and to a multiple of eight; `out` belongs
  // to the first row wanted.
  void multiply(IndexRange eights, const double* solid_in, const double* fluid_in,
                double* solid_out, double* fluid_out) const;

 private:
  struct Block {
    int lowest;  // column of the first diagonal minus row
    int width;
    std::size_t first_value;
  };
  void append_block(IndexRange rows, const BandedRows& solid, const BandedRows& fluid);

  bool shared_ = false;
  std::size_t reach_ = 0;
  std::vector<Block> blocks_;
  LineVector values_;  // per eight rows, per diagonal: eight of the solid, eight of the fluid
};

}  // namespace porowave::solver
