#include "solver/weights.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "solver/neighbours.hpp"

namespace porowave::solver {

namespace {

void check_lengths(const SparseRows& rows, std::size_t row_length, std::size_t column_length) {
  if (row_length != rows.row_count() || column_length != rows.column_count) {
    throw std::invalid_argument("multiply: the vectors do not fit the rows");
  }
}

// Calls f with the order as a compile-time constant.
template <class F>
decltype(auto) visit_order(int order, F&& f) {
  switch (order) {
    case 0:
      return f(std::integral_constant<int, 0>{});
    case 1:
      return f(std::integral_constant<int, 1>{});
    case 2:
      return f(std::integral_constant<int, 2>{});
    case 3:
      return f(std::integral_constant<int, 3>{});
    default:
      throw std::invalid_argument("moving least squares: basis order must be 0 to 3");
  }
}

void record(const MlsResult& result, int basis_order, double radius, const Support& support,
            MlsReport& report) {
  report.order_used.push_back(static_cast<std::int8_t>(result.order_used));
  if (result.order_used < 0) {
    ++report.rows_without_point;
  } else if (result.order_used < basis_order) {
    ++report.rows_of_reduced_order;
  }
  if (radius > support.radius) ++report.rows_of_enlarged_support;
  if (result.order_used >= 0) report.largest_radius = std::max(report.largest_radius, radius);
  report.worst_condition = std::max(report.worst_condition, result.condition);
}

template <class Kernel, int Dim, int Order>
void append_mls_rows(std::span<const Vector<Dim>> evaluation_points, const CellList<Dim>& cells,
                     const Support& support, double max_condition, SparseRows& rows,
                     MlsReport& report) {
  std::vector<std::int32_t> found;
  std::vector<Vector<Dim>> positions;
  std::vector<double> phi;
  for (const Vector<Dim>& x : evaluation_points) {
    MlsResult result;
    const double reach = grow_support(support, Order, [&](double radius) {
      found.clear();
      positions.clear();
      cells.for_each_in_box(x, radius, [&](std::int32_t p, const Vector<Dim>& xp) {
        found.push_back(p);
        positions.push_back(xp);
      });
      phi.resize(found.size());
      const MovingLeastSquares<Kernel, Dim, Order> mls(radius, max_condition);
      result = mls.evaluate(x, positions, phi);
      return result;
    });
    record(result, Order, reach, support, report);
    for (std::size_t k = 0; k < phi.size(); ++k) {
      if (phi[k] == 0.0) continue;  // in the box, but outside the support
      rows.columns.push_back(found[k]);
      rows.values.push_back(phi[k]);
    }
    rows.row_offsets.push_back(rows.columns.size());
  }
}

// Room for as many weights as evenly spread points would have: growing by doubling takes up to
// three times the memory of the rows.
template <int Dim>
void reserve_rows(std::span<const Vector<Dim>> evaluation_points,
                  std::span<const Vector<Dim>> points, double radius, SparseRows& rows) {
  if (points.empty()) return;
  Vector<Dim> low = points[0];
  Vector<Dim> high = points[0];
  for (const Vector<Dim>& x : points) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  double in_box = static_cast<double>(points.size());
  for (int a = 0; a < Dim; ++a) in_box *= std::min(1.0, 2.0 * radius / (high[a] - low[a]));
  const double margin = 1.02;
  const auto count =
      static_cast<std::size_t>(margin * in_box * static_cast<double>(evaluation_points.size()));
  rows.row_offsets.reserve(evaluation_points.size() + 1);
  rows.columns.reserve(count);
  rows.values.reserve(count);
}

}  // namespace

void multiply(const SparseRows& rows, std::span<const double> in, std::span<double> out) {
  check_lengths(rows, out.size(), in.size());
  for (std::size_t r = 0; r < out.size(); ++r) {
    double sum = 0.0;
    for (std::size_t k = rows.row_offsets[r]; k < rows.row_offsets[r + 1]; ++k) {
      sum += rows.values[k] * in[static_cast<std::size_t>(rows.columns[k])];
    }
    out[r] = sum;
  }
}

void multiply_transposed(const SparseRows& rows, std::span<const double> in,
                         std::span<double> out) {
  check_lengths(rows, in.size(), out.size());
  std::fill(out.begin(), out.end(), 0.0);
  for (std::size_t r = 0; r < in.size(); ++r) {
    for (std::size_t k = rows.row_offsets[r]; k < rows.row_offsets[r + 1]; ++k) {
      out[static_cast<std::size_t>(rows.columns[k])] += rows.values[k] * in[r];
    }
  }
}

template <int Dim>
SparseRows mls_rows(std::span<const Vector<Dim>> evaluation_points,
                    std::span<const Vector<Dim>> points, KernelName kernel, const Support& support,
                    int basis_order, MlsReport& report, double max_condition) {
  if (!(support.radius > 0.0) || !std::isfinite(support.largest)) {
    throw std::invalid_argument("moving least squares: support radius must be positive and finite");
  }
  if (!(support.largest >= support.radius) || !(support.well_conditioned >= 1.0)) {
    throw std::invalid_argument(
        "moving least squares: an adaptive support must grow, to a condition of at least 1");
  }
  if (!(max_condition > 1.0)) {
    throw std::invalid_argument("moving least squares: the condition limit must exceed 1");
  }
  for (const Vector<Dim>& x : evaluation_points) {
    if (!x.allFinite()) throw std::invalid_argument("mls rows: a position is not finite");
  }
  report = {};
  SparseRows rows;
  rows.column_count = points.size();
  reserve_rows<Dim>(evaluation_points, points, support.radius, rows);
  const CellList<Dim> cells(points, grid_around<Dim>(points, support.radius));
  visit_kernel(kernel, [&]<class Kernel>(Kernel) {
    visit_order(basis_order, [&]<int Order>(std::integral_constant<int, Order>) {
      append_mls_rows<Kernel, Dim, Order>(evaluation_points, cells, support, max_condition, rows,
                                          report);
    });
  });
  return rows;
}

template <int Dim>
LinearRows<Dim> linear_rows(std::span<const Vector<Dim>> points, const Grid<Dim>& grid) {
  LinearRows<Dim> rows;
  const auto reserve = [count = points.size()](SparseRows& to) {
    to.row_offsets.reserve(count + 1);
    to.columns.reserve(count * Grid<Dim>::corners);
    to.values.reserve(count * Grid<Dim>::corners);
  };
  reserve(rows.values);
  for (SparseRows& gradient : rows.gradients) reserve(gradient);
  const auto append = [](SparseRows& to, std::int32_t column, double value) {
    to.columns.push_back(column);
    to.values.push_back(value);
  };
  for (const Vector<Dim>& x : points) {
    if (!x.allFinite()) throw std::invalid_argument("linear rows: a position is not finite");
    const LinearShape<Dim> shape = grid.linear_shape(x);
    for (std::size_t c = 0; c < shape.nodes.size(); ++c) {
      append(rows.values, shape.nodes[c], shape.values[c]);
      for (std::size_t a = 0; a < Dim; ++a) {
        append(rows.gradients[a], shape.nodes[c], shape.gradients[c][static_cast<int>(a)]);
      }
    }
    rows.values.row_offsets.push_back(rows.values.columns.size());
  }
  rows.values.column_count = static_cast<std::size_t>(grid.node_count());
  for (SparseRows& gradient : rows.gradients) {
    gradient.row_offsets = rows.values.row_offsets;
    gradient.column_count = rows.values.column_count;
  }
  return rows;
}

template SparseRows mls_rows<1>(std::span<const Vector<1>>, std::span<const Vector<1>>, KernelName,
                                const Support&, int, MlsReport&, double);
template LinearRows<1> linear_rows<1>(std::span<const Vector<1>>, const Grid<1>&);
template SparseRows mls_rows<2>(std::span<const Vector<2>>, std::span<const Vector<2>>, KernelName,
                                const Support&, int, MlsReport&, double);
template LinearRows<2> linear_rows<2>(std::span<const Vector<2>>, const Grid<2>&);
template SparseRows mls_rows<3>(std::span<const Vector<3>>, std::span<const Vector<3>>, KernelName,
                                const Support&, int, MlsReport&, double);
template LinearRows<3> linear_rows<3>(std::span<const Vector<3>>, const Grid<3>&);

}  // namespace porowave::solver
