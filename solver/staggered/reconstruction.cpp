#include "solver/staggered/reconstruction.hpp"

#include <cstdint>
#include <map>
#include <span>

namespace porowave::solver {

namespace {

constexpr double growth = 1.1;
constexpr double largest_growth = 8.0;

std::vector<Vector<1>> vectors(const std::vector<double>& x) {
  std::vector<Vector<1>> result;
  result.reserve(x.size());
  for (const double value : x) result.emplace_back(value);
  return result;
}

struct Row {
  std::vector<std::int32_t> columns;
  std::vector<double> values;
};

Row row_of(const SparseRows& rows, std::size_t r) {
  const auto from = static_cast<std::ptrdiff_t>(rows.row_offsets[r]);
  const auto to = static_cast<std::ptrdiff_t>(rows.row_offsets[r + 1]);
  return {{rows.columns.begin() + from, rows.columns.begin() + to},
          {rows.values.begin() + from, rows.values.begin() + to}};
}

// The rows, with some of them replaced.
SparseRows replaced(const SparseRows& rows, const std::map<std::size_t, Row>& better) {
  SparseRows result;
  result.column_count = rows.column_count;
  for (std::size_t r = 0; r < rows.row_count(); ++r) {
    const auto found = better.find(r);
    const Row row = found == better.end() ? row_of(rows, r) : found->second;
    result.columns.insert(result.columns.end(), row.columns.begin(), row.columns.end());
    result.values.insert(result.values.end(), row.values.begin(), row.values.end());
    result.row_offsets.push_back(result.columns.size());
  }
  return result;
}

// Rows of a support enlarged by `factor` for the poor places that gain by it; returns the places
// that still are below the order.
std::vector<std::size_t> improve(const std::vector<std::size_t>& poor,
                                 const std::vector<Vector<1>>& places,
                                 const std::vector<Vector<1>>& points, double factor,
                                 const AdaptiveBasis& basis, std::vector<std::int8_t>& order,
                                 std::map<std::size_t, Row>& better) {
  std::vector<Vector<1>> at;
  for (const std::size_t r : poor) at.push_back(places[r]);
  MlsReport report;
  const SparseRows rows =
      mls_rows<1>(at, points, basis.kernel, factor * basis.support_radius, basis.order, report);
  std::vector<std::size_t> left;
  for (std::size_t k = 0; k < poor.size(); ++k) {
    if (report.order_used[k] > order[poor[k]]) {
      order[poor[k]] = report.order_used[k];
      better[poor[k]] = row_of(rows, k);
    }
    if (order[poor[k]] < basis.order) left.push_back(poor[k]);
  }
  return left;
}

}  // namespace

AdaptiveRows adaptive_rows(const std::vector<double>& places, const std::vector<double>& points,
                           const AdaptiveBasis& basis) {
  const std::vector<Vector<1>> at = vectors(places);
  const std::vector<Vector<1>> from = vectors(points);
  MlsReport report;
  AdaptiveRows result;
  result.rows = mls_rows<1>(at, from, basis.kernel, basis.support_radius, basis.order, report);
  std::vector<std::size_t> poor;
  for (std::size_t r = 0; r < places.size(); ++r) {
    if (report.order_used[r] < basis.order) poor.push_back(r);
  }
  result.enlarged = poor.size();
  std::map<std::size_t, Row> better;
  for (double factor = growth; !poor.empty() && factor <= largest_growth; factor *= growth) {
    poor = improve(poor, at, from, factor, basis, report.order_used, better);
  }
  for (const std::size_t r : poor) ++(report.order_used[r] < 0 ? result.empty : result.reduced);
  if (!better.empty()) result.rows = replaced(result.rows, better);
  return result;
}

BandMatrix through(const SparseRows& phi, const std::vector<double>& points, const CubicLine& line,
                   const BandShape& shape) {
  std::vector<CubicRow> cubic;
  cubic.reserve(points.size());
  for (const double x : points) cubic.push_back(line.value(x));
  BandMatrix product(phi.row_count(), shape.columns, shape.shift, shape.half_width);
  for (std::size_t r = 0; r < phi.row_count(); ++r) {
    for (std::size_t k = phi.row_offsets[r]; k < phi.row_offsets[r + 1]; ++k) {
      const CubicRow& row = cubic[static_cast<std::size_t>(phi.columns[k])];
      for (std::size_t j = 0; j < 4; ++j) {
        product.add(r, row.index[j], phi.values[k] * row.weight[j]);
      }
    }
  }
  return product;
}

}  // namespace porowave::solver
