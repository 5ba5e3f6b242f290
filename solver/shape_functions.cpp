#include "solver/shape_functions.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace porowave::solver {

namespace {

// N_i along one axis at one coordinate, for the nodes first, first + 1, ...
struct AxisShape {
  int first = 0;
  std::vector<double> values;
  std::vector<double> slopes;  // in 1/length
};

// Adds S of node i to the nodes of the axis, 0 to `last`; nodes beyond by linear extrapolation.
void add_node(int i, int last, double value, double slope, AxisShape& axis) {
  const auto add = [&](int node, double share) {
    const auto at = static_cast<std::size_t>(node - axis.first);
    axis.values[at] += share * value;
    axis.slopes[at] += share * slope;
  };
  if (i < 0) {
    add(0, 1.0 - i);
    add(1, i);
  } else if (i > last) {
    add(last, 1.0 + (i - last));
    add(last - 1, last - i);
  } else {
    add(i, 1.0);
  }
}

// `t` is the coordinate from the first node in units of the spacing.
template <class Shape>
void evaluate_axis(double t, double half, int cells, double spacing, AxisShape& axis) {
  if (t < 0.0 || t > cells) {  // outside: continued linearly
    axis.first = t < 0.0 ? 0 : cells - 1;
    const double share = t - axis.first;
    axis.values = {1.0 - share, share};
    axis.slopes = {-1.0 / spacing, 1.0 / spacing};
    return;
  }
  const double reach = Shape::reach(half);
  const int low = static_cast<int>(std::ceil(t - reach));
  const int high = static_cast<int>(std::floor(t + reach));
  axis.first = std::clamp(low, 0, cells - 1);  // ends need their two last nodes
  const int end = std::clamp(high, 1, cells);
  axis.values.assign(static_cast<std::size_t>(end - axis.first + 1), 0.0);
  axis.slopes.assign(axis.values.size(), 0.0);
  for (int i = low; i <= high; ++i) {
    add_node(i, cells, Shape::value(t - i, half), Shape::derivative(t - i, half) / spacing, axis);
  }
}

// The product over the axes.
template <int Dim>
void append_products(const std::array<AxisShape, Dim>& axes, const Grid<Dim>& grid,
                     LinearRows<Dim>& rows) {
  CellIndex<Dim> sizes;
  for (int a = 0; a < Dim; ++a) {
    sizes[a] = static_cast<int>(axes[static_cast<std::size_t>(a)].values.size());
  }
  for (int k = 0; k < sizes.prod(); ++k) {
    CellIndex<Dim> node;
    double value = 1.0;
    Vector<Dim> gradient = Vector<Dim>::Ones();
    for (int a = 0, rest = k; a < Dim; rest /= sizes[a], ++a) {
      const AxisShape& axis = axes[static_cast<std::size_t>(a)];
      const auto at = static_cast<std::size_t>(rest % sizes[a]);
      node[a] = axis.first + rest % sizes[a];
      value *= axis.values[at];
      for (int b = 0; b < Dim; ++b) gradient[b] *= a == b ? axis.slopes[at] : axis.values[at];
    }
    rows.values.columns.push_back(grid.node_number(node));
    rows.values.values.push_back(value);
    for (int a = 0; a < Dim; ++a) {
      rows.gradients[static_cast<std::size_t>(a)].values.push_back(gradient[a]);
    }
  }
  rows.values.row_offsets.push_back(rows.values.columns.size());
}

void check_domains(std::span<const double> domain, std::size_t points) {
  if (domain.size() != points) throw std::invalid_argument("shape rows: one domain a point");
  for (const double edge : domain) {
    if (!(edge > 0.0) || !std::isfinite(edge)) {
      throw std::invalid_argument("shape rows: a domain must be positive and finite");
    }
  }
}

template <class Shape, int Dim>
LinearRows<Dim> rows_of(std::span<const Vector<Dim>> points, std::span<const double> domain,
                        const Grid<Dim>& grid) {
  if (Shape::has_domain) check_domains(domain, points.size());
  LinearRows<Dim> rows;
  std::array<AxisShape, Dim> axes;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (!points[p].allFinite()) {
      throw std::invalid_argument("shape rows: a position is not finite");
    }
    const double half = Shape::has_domain ? 0.5 * domain[p] / grid.spacing : 0.0;
    for (int a = 0; a < Dim; ++a) {
      const double t = (points[p][a] - grid.origin[a]) / grid.spacing;
      evaluate_axis<Shape>(t, half, grid.cells[a], grid.spacing, axes[static_cast<std::size_t>(a)]);
    }
    append_products<Dim>(axes, grid, rows);
  }
  rows.values.column_count = static_cast<std::size_t>(grid.node_count());
  for (SparseRows& gradient : rows.gradients) {
    gradient.columns = rows.values.columns;
    gradient.row_offsets = rows.values.row_offsets;
    gradient.column_count = rows.values.column_count;
  }
  return rows;
}

}  // namespace

template <int Dim>
LinearRows<Dim> shape_rows(std::span<const Vector<Dim>> points, std::span<const double> domain,
                           const Grid<Dim>& grid, ShapeName shape) {
  return visit_shape(shape, [&]<class Shape>(Shape) {
    // The slope of the linear functions jumps at a node: there the upper cell decides.
    if constexpr (std::is_same_v<Shape, LinearSpline>) {
      return linear_rows<Dim>(points, grid);
    } else {
      return rows_of<Shape, Dim>(points, domain, grid);
    }
  });
}

template LinearRows<1> shape_rows<1>(std::span<const Vector<1>>, std::span<const double>,
                                     const Grid<1>&, ShapeName);
template LinearRows<2> shape_rows<2>(std::span<const Vector<2>>, std::span<const double>,
                                     const Grid<2>&, ShapeName);
template LinearRows<3> shape_rows<3>(std::span<const Vector<3>>, std::span<const double>,
                                     const Grid<3>&, ShapeName);

}  // namespace porowave::solver
