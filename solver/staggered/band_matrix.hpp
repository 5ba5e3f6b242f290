#pragma once

// A matrix whose entries are nearly all within a few diagonals, stored by diagonals so that a
// product runs straight through memory; the few others (rows at the ends, rows of enlarged support)
// are kept one by one.

#include <cstddef>
#include <span>
#include <vector>

namespace porowave::solver {

class BandMatrix {
 public:
  BandMatrix() = default;
  // Zero. The diagonals are c − r − shift = −half_width ... half_width, 2 <= half_width <= 5;
  // std::invalid_argument otherwise.
  BandMatrix(std::size_t rows, std::size_t columns, std::size_t shift, std::size_t half_width);

  // Adds to an entry; std::invalid_argument outside.
  void add(std::size_t row, std::size_t column, double value);

  std::size_t rows() const { return rows_; }
  // How many entries are not on the diagonals.
  std::size_t strays() const { return strays_.size(); }

  // out_r = Σ_c a_rc in_c for the rows before `end`. in and out must not overlap, and hold all
  // columns and at least those rows: unchecked.
  void multiply(std::span<const double> in, std::span<double> out, std::size_t end) const;

 private:
  struct Entry {
    std::size_t row;
    std::size_t column;
    double value;
  };
  template <std::size_t HalfWidth>
  void multiply_diagonals(const double* __restrict in, double* __restrict out,
                          std::size_t end) const;

  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::size_t shift_ = 0;
  std::size_t half_width_ = 2;
  std::size_t first_ = 0;  // rows first_ ... last_ − 1 have all their diagonals inside
  std::size_t last_ = 0;
  std::vector<double> diagonals_;  // one after the other, `rows` long
  std::vector<Entry> strays_;      // ascending in row, then column
};

}  // namespace porowave::solver
