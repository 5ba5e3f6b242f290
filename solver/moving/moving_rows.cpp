#include "solver/moving/moving_rows.hpp"

#include <algorithm>
#include <utility>

namespace porowave::solver {

MovedPoints::MovedPoints(const std::vector<bool>& moved) : before_(1, 0) {
  before_.reserve(moved.size() + 1);
  for (const bool m : moved) before_.push_back(before_.back() + (m ? 1 : 0));
}

IndexRange MovingRows::reach_of(double place, std::span<const Vector<1>> points) const {
  const auto left_of = [](const Vector<1>& x, double bound) { return x[0] < bound; };
  const auto low = std::lower_bound(points.begin(), points.end(), place - radius_, left_of);
  auto high = low;
  while (high != points.end() && (*high)[0] <= place + radius_) ++high;
  return {static_cast<std::size_t>(low - points.begin()),
          static_cast<std::size_t>(high - points.begin())};
}

// Points are the same and in the same order, so a point that has come or gone is in one of the two
// reaches, and has moved.
bool MovingRows::is_still_good(const Row& row, const Row& wanted, const MovedPoints& moved) const {
  return row.place == wanted.place && row.reach.first == wanted.reach.first &&
         row.reach.last == wanted.reach.last && !moved.any(wanted.reach);
}

void MovingRows::renew(long first, std::span<const double> places,
                       std::span<const Vector<1>> points, const MovedPoints& moved) {
  std::vector<Row> old = std::exchange(rows_, std::vector<Row>(places.size()));
  const long old_first = std::exchange(first_, first);
  std::vector<bool> stale(places.size(), true);
  for (std::size_t r = 0; r < places.size(); ++r) {
    rows_[r].place = places[r];
    rows_[r].reach = reach_of(places[r], points);
    const long known = first + static_cast<long>(r) - old_first;
    if (known < 0 || known >= static_cast<long>(old.size())) continue;
    Row& before = old[static_cast<std::size_t>(known)];
    if (!is_still_good(before, rows_[r], moved)) continue;
    rows_[r] = std::move(before);
    stale[r] = false;
  }
  renewed_ = static_cast<std::size_t>(std::count(stale.begin(), stale.end(), true));
  for (std::size_t r = 0; r < rows_.size();) {
    std::size_t end = r;
    while (end < rows_.size() && stale[end]) ++end;
    if (end > r) make({rows_.data() + r, end - r}, points);
    r = std::max(end, r + 1);
  }
}

void MovingRows::make(std::span<Row> rows, std::span<const Vector<1>> points) const {
  std::vector<Vector<1>> places;
  std::size_t last = 0;
  for (const Row& row : rows) {
    places.emplace_back(row.place);
    last = std::max(last, row.reach.last);
  }
  const std::size_t offset = rows.front().reach.first;
  MlsReport report;
  const SparseRows made = mls_rows<1>(places, points.subspan(offset, last - offset), kernel_,
                                      radius_, basis_order_, report);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    rows[r].order_used = report.order_used[r];
    rows[r].first_column = offset;
    if (made.row_offsets[r] == made.row_offsets[r + 1]) continue;
    // Sorted points come sorted; a weight that happens to be zero has been left out.
    const auto column = [&](std::size_t k) { return static_cast<std::size_t>(made.columns[k]); };
    const std::size_t low = column(made.row_offsets[r]);
    rows[r].first_column += low;
    rows[r].values.assign(column(made.row_offsets[r + 1] - 1) - low + 1, 0.0);
    for (std::size_t k = made.row_offsets[r]; k < made.row_offsets[r + 1]; ++k) {
      rows[r].values[column(k) - low] = made.values[k];
    }
  }
}

void MovingRows::multiply(std::span<const double> point_values, std::span<double> at_places) const {
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const double* value = point_values.data() + rows_[r].first_column;
    double sum = 0.0;
    for (std::size_t k = 0; k < rows_[r].values.size(); ++k) sum += rows_[r].values[k] * value[k];
    at_places[r] = sum;
  }
}

std::size_t MovingRows::reduced() const {
  return static_cast<std::size_t>(std::count_if(rows_.begin(), rows_.end(), [&](const Row& row) {
    return row.order_used >= 0 && row.order_used < basis_order_;
  }));
}

std::size_t MovingRows::empty() const {
  return static_cast<std::size_t>(
      std::count_if(rows_.begin(), rows_.end(), [](const Row& row) { return row.order_used < 0; }));
}

}  // namespace porowave::solver
