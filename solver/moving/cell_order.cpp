#include "solver/moving/cell_order.hpp"

#include <algorithm>
#include <numeric>

namespace porowave::solver {

std::vector<std::size_t> order_along(std::span<const Vector<1>> x) {
  const auto before = [](const Vector<1>& a, const Vector<1>& b) { return a[0] < b[0]; };
  if (std::is_sorted(x.begin(), x.end(), before)) return {};
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return before(x[a], x[b]); });
  return order;
}

std::size_t CellOrder::renew(std::span<const Vector<1>> x, double spacing, long first_cell,
                             std::size_t cells) {
  // A cell that was known starts from its old bound, others from that of the nearest one known.
  std::vector<std::size_t> bounds(cells + 1, 0);
  for (std::size_t c = 1; c < cells && !first_point_.empty(); ++c) {
    const long old = first_cell + static_cast<long>(c) - first_cell_;
    const long last = static_cast<long>(first_point_.size()) - 1;
    bounds[c] = first_point_[static_cast<std::size_t>(std::clamp(old, 0L, last))];
  }
  bounds[cells] = x.size();
  std::size_t passed = 0;
  for (std::size_t c = 1; c < cells; ++c) {
    const double node = spacing * static_cast<double>(first_cell + static_cast<long>(c));
    std::size_t& bound = bounds[c];
    for (; bound < x.size() && x[bound][0] < node; ++bound) ++passed;
    for (; bound > 0 && x[bound - 1][0] >= node; --bound) ++passed;
  }
  first_point_ = std::move(bounds);
  first_cell_ = first_cell;
  return passed;
}

}  // namespace porowave::solver
