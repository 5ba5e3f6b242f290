#include "solver/staggered/band_matrix.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace porowave::solver {

BandMatrix::BandMatrix(std::size_t rows, std::size_t columns, std::size_t shift,
                       std::size_t half_width)
    : rows_(rows), columns_(columns), shift_(shift), half_width_(half_width) {
  if (half_width < 2 || half_width > 5) {
    throw std::invalid_argument("band matrix: half width must be 2 to 5");
  }
  first_ = std::min(rows, half_width > shift ? half_width - shift : 0);
  const std::size_t beyond = shift + half_width;
  last_ = std::max(first_, std::min(rows, columns > beyond ? columns - beyond : 0));
  diagonals_.assign((2 * half_width + 1) * rows, 0.0);
}

void BandMatrix::add(std::size_t row, std::size_t column, double value) {
  if (row >= rows_ || column >= columns_) {
    throw std::invalid_argument("band matrix: an entry is outside");
  }
  const std::size_t diagonal = column + half_width_ - row - shift_;  // wraps if left of all
  if (row >= first_ && row < last_ && diagonal <= 2 * half_width_) {
    diagonals_[diagonal * rows_ + row] += value;
    return;
  }
  const auto place = std::lower_bound(
      strays_.begin(), strays_.end(), std::pair(row, column),
      [](const Entry& e, const auto& at) { return std::pair(e.row, e.column) < at; });
  if (place != strays_.end() && place->row == row && place->column == column) {
    place->value += value;
  } else {
    strays_.insert(place, {row, column, value});
  }
}

template <std::size_t HalfWidth>
void BandMatrix::multiply_diagonals(const double* __restrict in, double* __restrict out,
                                    std::size_t end) const {
  constexpr std::size_t width = 2 * HalfWidth + 1;
  const double* __restrict a = diagonals_.data();
  for (std::size_t r = first_; r < end; ++r) {
    const double* x = in + (r + shift_ - HalfWidth);
    double sum = 0.0;
    for (std::size_t d = 0; d < width; ++d) sum += a[d * rows_ + r] * x[d];
    out[r] = sum;
  }
}

void BandMatrix::multiply(std::span<const double> in, std::span<double> out,
                          std::size_t end) const {
  end = std::min(end, rows_);
  for (std::size_t r = 0; r < std::min(first_, end); ++r) out[r] = 0.0;
  for (std::size_t r = last_; r < end; ++r) out[r] = 0.0;
  const std::size_t inner_end = std::min(last_, end);
  switch (half_width_) {
    case 2:
      multiply_diagonals<2>(in.data(), out.data(), inner_end);
      break;
    case 3:
      multiply_diagonals<3>(in.data(), out.data(), inner_end);
      break;
    case 4:
      multiply_diagonals<4>(in.data(), out.data(), inner_end);
      break;
    default:
      multiply_diagonals<5>(in.data(), out.data(), inner_end);
  }
  for (const Entry& e : strays_) {
    if (e.row >= end) break;
    out[e.row] += e.value * in[e.column];
  }
}

}  // namespace porowave::solver
