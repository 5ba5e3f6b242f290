#include "solver/shared_strains.hpp"

#include <utility>

#include "solver/simd.hpp"

namespace porowave::solver {

namespace {

// s_p += strain + (t − 1/2) D
POROWAVE_VECTORISED void add_strains(double strain, double below, double above,
                                     const double* __restrict place, std::size_t count,
                                     double* __restrict s) {
  for (std::size_t p = 0; p < count; ++p) {
    const double t = place[p] - 0.5;
    s[p] += strain + t * (t < 0.0 ? below : above);
  }
}

// The difference of strains across an end of the cell between b[0] and b[1].
double difference_across(int end, const double* b) {
  if (end == 0) return 0.0;
  return end < 0 ? (b[1] - b[0]) - (b[0] - b[-1]) : (b[2] - b[1]) - (b[1] - b[0]);
}

}  // namespace

SharedStrains::SharedStrains(const SparseRows& strain_rows,
                             const std::vector<std::size_t>& first_point,
                             const std::vector<double>& place) {
  std::vector<Ends> ends(first_point.size() - 1);
  bool shared = false;
  for (std::size_t c = 0; c < ends.size(); ++c) {
    for (std::size_t p = first_point[c]; p < first_point[c + 1]; ++p) {
      const std::size_t entry = strain_rows.row_offsets[p];
      if (strain_rows.row_offsets[p + 1] - entry < 4) continue;  // the point's own cell alone
      const bool lower = strain_rows.columns[entry + 2] < strain_rows.columns[entry];
      (place[p] < 0.5 ? ends[c].below : ends[c].above) = lower ? -1 : 1;
      shared = true;
    }
  }
  if (shared) ends_ = std::move(ends);
}

PointRow SharedStrains::row(std::size_t cell, double place) const {
  const double t = place - 0.5;
  const int c = static_cast<int>(cell);
  const int end = empty() ? 0 : t < 0.0 ? ends_[cell].below : ends_[cell].above;
  if (end == 0) return {c, {1.0, 0.0}};
  return end < 0 ? PointRow{c - 1, {-t, 1.0 + t}} : PointRow{c, {1.0 - t, t}};
}

void SharedStrains::add(IndexRange cells, const std::vector<std::size_t>& first_point,
                        const double* place, const double* b, double factor, double* s) const {
  for (std::size_t c = cells.first; c < cells.last; ++c, ++b) {
    add_strains(factor * (b[1] - b[0]), factor * difference_across(ends_[c].below, b),
                factor * difference_across(ends_[c].above, b), place + first_point[c],
                first_point[c + 1] - first_point[c], s + first_point[c]);
  }
}

}  // namespace porowave::solver
