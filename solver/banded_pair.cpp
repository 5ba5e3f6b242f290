#include "solver/banded_pair.hpp"

#include <algorithm>

#include "solver/simd.hpp"

namespace porowave::solver {

namespace {

struct Pair {
  const double* solid;
  const double* fluid;
};

POROWAVE_INLINE void add_product(const double* values, const double* in, bool first, Eight& sum) {
  Eight value, there;
  read(values, value);
  read(in, there);
  if (first) {
    sum = value * there;
  } else {
    sum += value * there;
  }
}

// Width 0 stands for one that is known only at run time.
template <std::size_t Width, bool Shared>
POROWAVE_INLINE void multiply_rows(std::size_t any_width, const double* __restrict values, Pair in,
                                   std::size_t eights, double* __restrict solid,
                                   double* __restrict fluid) {
  const std::size_t width = Width > 0 ? Width : any_width;
  for (std::size_t r = 0; r < eights * lanes; r += lanes) {
    Eight of_solid = {};
    Eight of_fluid = {};
    for (std::size_t k = 0; k < width; ++k) {
      add_product(values, in.solid + r + k, k == 0, of_solid);
      if (!Shared) values += lanes;
      add_product(values, in.fluid + r + k, k == 0, of_fluid);
      values += lanes;
    }
    write(of_solid, solid + r);
    write(of_fluid, fluid + r);
  }
}

template <bool Shared>
POROWAVE_INLINE void multiply_any(std::size_t width, const double* values, Pair in,
                                  std::size_t eights, double* solid, double* fluid) {
  switch (width) {
    case 1:
      return multiply_rows<1, Shared>(width, values, in, eights, solid, fluid);
    case 2:
      return multiply_rows<2, Shared>(width, values, in, eights, solid, fluid);
    case 3:
      return multiply_rows<3, Shared>(width, values, in, eights, solid, fluid);
    case 4:
      return multiply_rows<4, Shared>(width, values, in, eights, solid, fluid);
    case 5:
      return multiply_rows<5, Shared>(width, values, in, eights, solid, fluid);
    case 6:
      return multiply_rows<6, Shared>(width, values, in, eights, solid, fluid);
    case 7:
      return multiply_rows<7, Shared>(width, values, in, eights, solid, fluid);
    default:
      return multiply_rows<0, Shared>(width, values, in, eights, solid, fluid);
  }
}

// The sum of a row is taken in the order of its columns, whatever the form.
POROWAVE_VECTORISED void multiply_both(std::size_t width, const double* values, Pair in,
                                       std::size_t eights, double* solid, double* fluid) {
  multiply_any<false>(width, values, in, eights, solid, fluid);
}
POROWAVE_VECTORISED void multiply_shared(std::size_t width, const double* values, Pair in,
                                         std::size_t eights, double* solid, double* fluid) {
  multiply_any<true>(width, values, in, eights, solid, fluid);
}

}  // namespace

BandedPair::BandedPair(const std::shared_ptr<const BandedRows>& solid,
                       const std::shared_ptr<const BandedRows>& fluid, std::size_t rows)
    : shared_(solid == fluid), reach_(std::max(solid->reach(), fluid->reach())) {
  for (std::size_t first = 0; first < rows; first += BandedRows::block_rows) {
    append_block({first, std::min(first + BandedRows::block_rows, rows)}, *solid, *fluid);
  }
}

void BandedPair::append_block(IndexRange rows, const BandedRows& solid, const BandedRows& fluid) {
  const bool filled = rows.first < solid.row_count();
  const std::size_t block = rows.first / BandedRows::block_rows;
  const BandedRows::Band s = filled ? solid.band(block) : BandedRows::Band{0, 1};
  const BandedRows::Band f = filled ? fluid.band(block) : BandedRows::Band{0, 1};
  const int lowest = std::min(s.lowest, f.lowest);
  const int width = std::max(s.lowest + s.width, f.lowest + f.width) - lowest;
  blocks_.push_back({lowest, width, values_.size()});
  for (std::size_t first = rows.first; first < rows.last; first += lanes) {
    for (int d = lowest; d < lowest + width; ++d) {
      for (const BandedRows* phase : {&solid, &fluid}) {
        for (std::size_t r = first; r < first + lanes; ++r) {
          values_.push_back(r < phase->row_count() ? phase->value(r, d) : 0.0);
        }
        if (shared_) break;
      }
    }
  }
}

void BandedPair::multiply(IndexRange eights, const double* solid_in, const double* fluid_in,
                          double* solid_out, double* fluid_out) const {
  const Block& block = blocks_[eights.first / eights_of_block];
  const auto width = static_cast<std::size_t>(block.width);
  const std::size_t skipped = eights.first % eights_of_block * width * lanes * (shared_ ? 1 : 2);
  const auto column = static_cast<std::ptrdiff_t>(eights.first * lanes) + block.lowest;
  const Pair in{solid_in + column, fluid_in + column};
  const auto product = shared_ ? multiply_shared : multiply_both;
  product(width, values_.data() + block.first_value + skipped, in, eights.size(), solid_out,
          fluid_out);
}

}  // namespace porowave::solver
