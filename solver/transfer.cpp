#include "solver/transfer.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "solver/apic.hpp"
#include "solver/shape_functions.hpp"
#include "solver/strain_recovery.hpp"

namespace porowave::solver {

namespace {

// A point at exactly the support radius weighs nothing. A support smaller by this share keeps
// rounding from giving it a tiny weight, which the normalisation would blow up to one. Coordinates
// are rounded to a share of h that grows with their size in h.
template <int Dim>
double support_margin(const Grid<Dim>& grid) {
  const Vector<Dim> upper = grid.origin + grid.spacing * grid.cells.template cast<double>();
  const double largest = grid.origin.cwiseAbs().cwiseMax(upper.cwiseAbs()).maxCoeff();
  return std::max(1e-10, 4.0 * std::numeric_limits<double>::epsilon() * largest / grid.spacing);
}

SparseRows transposed(const SparseRows& rows) {
  SparseRows result;
  result.column_count = rows.row_count();
  result.row_offsets.assign(rows.column_count + 1, 0);
  for (const std::int32_t column : rows.columns) {
    ++result.row_offsets[static_cast<std::size_t>(column) + 1];
  }
  for (std::size_t i = 0; i < rows.column_count; ++i) {
    result.row_offsets[i + 1] += result.row_offsets[i];
  }
  result.columns.resize(rows.columns.size());
  result.values.resize(rows.values.size());
  std::vector<std::size_t> next(result.row_offsets.begin(), result.row_offsets.end() - 1);
  for (std::size_t r = 0; r < rows.row_count(); ++r) {
    for (std::size_t k = rows.row_offsets[r]; k < rows.row_offsets[r + 1]; ++k) {
      const std::size_t at = next[static_cast<std::size_t>(rows.columns[k])]++;
      result.columns[at] = static_cast<std::int32_t>(r);
      result.values[at] = rows.values[k];
    }
  }
  return result;
}

template <int Dim, class Position>
std::vector<Vector<Dim>> positions(int count, Position&& position) {
  std::vector<Vector<Dim>> x;
  x.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) x.push_back(position(i));
  return x;
}

// With mls everything but the approximations goes through linear functions.
ShapeName functions_of(const Discretization& choice) {
  return choice.transfer == TransferName::mls ? shape_name<LinearSpline> : choice.shape;
}

}  // namespace

template <int Dim>
Transfer<Dim>::Transfer(const PointSet<Dim>& points, const Grid<Dim>& grid,
                        const Discretization& choice, TransferUse use)
    : cell_count_(static_cast<std::size_t>(grid.cell_count())) {
  if (use == TransferUse::all || choice.transfer != TransferName::mls) {
    linear_at_points_ = shape_rows<Dim>(points.x, points.domain, grid, functions_of(choice));
  }
  if (choice.transfer == TransferName::mls) {
    build_mls(points, grid, choice);
  } else {
    build_shape(points, grid);
  }
  if (choice.transfer == TransferName::apic) {
    affine_mass_ = make_affine<Dim>(points.x, grid, linear_at_points_);
    for (std::vector<double>& moment : affine_mass_) {
      for (std::size_t p = 0; p < moment.size(); ++p) moment[p] *= points.mass[p];
    }
  }
  if (choice.strain == Strain::recovered || choice.adaptive_support) {
    build_shared_strain(points, grid, choice);
  }
}

template <int Dim>
void Transfer<Dim>::build_shared_strain(const PointSet<Dim>& points, const Grid<Dim>& grid,
                                        const Discretization& choice) {
  if constexpr (Dim == 1) {
    const std::vector<bool> reached = reached_cells();
    std::vector<bool> is_material(cell_count_);
    for (std::size_t c = 0; c < cell_count_; ++c) {
      is_material[c] = reached[c] && nodal_mass_[c] > 0.0 && nodal_mass_[c + 1] > 0.0;
    }
    const bool recovered = choice.strain == Strain::recovered;
    strain_rows_ =
        shared_strain_rows(points.x, grid, is_material,
                           recovered ? StrainSharing::recovered : StrainSharing::lend_empty);
  } else if (choice.strain == Strain::recovered) {
    throw std::invalid_argument("transfer: strains are recovered in one dimension only");
  }
}

template <int Dim>
std::vector<bool> Transfer<Dim>::reached_cells() const {
  std::vector<bool> reached(cell_count_, false);
  for (const int cell : cell_of_point_) reached[static_cast<std::size_t>(cell)] = true;
  for (std::size_t q = 0; q < quadrature_rows_.row_count(); ++q) {
    reached[q] = quadrature_rows_.row_offsets[q + 1] > quadrature_rows_.row_offsets[q];
  }
  return reached;
}

template <int Dim>
void Transfer<Dim>::build_shape(const PointSet<Dim>& points, const Grid<Dim>& grid) {
  const auto nodes = static_cast<std::size_t>(grid.node_count());
  nodal_mass_.resize(nodes);
  nodal_volume_.resize(nodes);
  multiply_transposed(linear_at_points_.values, points.mass, nodal_mass_);
  multiply_transposed(linear_at_points_.values, points.volume, nodal_volume_);
  node_rows_ = transposed(linear_at_points_.values);
  for (std::size_t i = 0; i < nodes; ++i) {
    for (std::size_t k = node_rows_.row_offsets[i]; k < node_rows_.row_offsets[i + 1]; ++k) {
      const auto p = static_cast<std::size_t>(node_rows_.columns[k]);
      node_rows_.values[k] *= nodal_mass_[i] > 0.0 ? points.mass[p] / nodal_mass_[i] : 0.0;
    }
  }
  quadrature_weight_ = points.volume;
  for (const Vector<Dim>& x : points.x) {
    cell_of_point_.push_back(grid.cell_number(grid.cell_of(x)));
  }
}

template <int Dim>
void Transfer<Dim>::build_mls(const PointSet<Dim>& points, const Grid<Dim>& grid,
                              const Discretization& choice) {
  Support support = choice.support_radius * grid.spacing * (1.0 - support_margin(grid));
  if (choice.adaptive_support) {
    support.largest = std::max(support.radius, largest_adaptive_radius * grid.spacing);
    support.well_conditioned = well_conditioned_limit(choice.basis_order);
  }
  const auto nodes =
      positions<Dim>(grid.node_count(), [&](int i) { return grid.node_position(i); });
  const auto centres =
      positions<Dim>(grid.cell_count(), [&](int c) { return grid.cell_centre(c); });
  MlsReport report;
  node_rows_ = mls_rows<Dim>(nodes, points.x, choice.kernel, support, choice.basis_order, report,
                             choice.max_condition);
  reduced_rows_ = report.rows_of_reduced_order;
  empty_rows_ = report.rows_without_point;
  quadrature_rows_ = mls_rows<Dim>(centres, points.x, choice.kernel, support, choice.basis_order,
                                   report, choice.max_condition);
  reduced_rows_ += report.rows_of_reduced_order;
  empty_rows_ += report.rows_without_point;
  linear_at_quadrature_ = linear_rows<Dim>(centres, grid);
  double cell_volume = 1.0;
  for (int axis = 0; axis < Dim; ++axis) cell_volume *= grid.spacing;
  quadrature_weight_.assign(centres.size(), cell_volume);

  // Nodal density and filled volume: moving least squares of m_p/V_p and of 1.
  std::vector<double> density(points.x.size());
  for (std::size_t p = 0; p < density.size(); ++p) density[p] = points.mass[p] / points.volume[p];
  nodal_mass_.resize(nodes.size());
  nodal_volume_.resize(nodes.size());
  multiply(node_rows_, density, nodal_mass_);
  multiply(node_rows_, std::vector<double>(density.size(), 1.0), nodal_volume_);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodal_mass_[i] *= grid.nodal_volume(static_cast<int>(i));
    nodal_volume_[i] *= grid.nodal_volume(static_cast<int>(i));
  }
}

template <int Dim>
void Transfer<Dim>::to_nodes(std::span<const double> point_values,
                             std::span<double> nodal_values) const {
  multiply(node_rows_, point_values, nodal_values);
}

template <int Dim>
void Transfer<Dim>::add_affine(std::span<const double> point_slopes, int axis,
                               std::span<double> nodal_values) const {
  const auto a = static_cast<std::size_t>(axis);
  if (affine_mass_[a].empty()) return;
  const SparseRows& gradient = linear_at_points_.gradients[a];
  for (std::size_t p = 0; p < point_slopes.size(); ++p) {
    const double moment = affine_mass_[a][p] * point_slopes[p];
    for (std::size_t k = gradient.row_offsets[p]; k < gradient.row_offsets[p + 1]; ++k) {
      const auto i = static_cast<std::size_t>(gradient.columns[k]);
      if (nodal_mass_[i] > 0.0) nodal_values[i] += moment * gradient.values[k] / nodal_mass_[i];
    }
  }
}

template <int Dim>
void Transfer<Dim>::to_quadrature(std::span<const double> point_values,
                                  std::vector<double>& values) const {
  values.resize(quadrature_weight_.size());
  if (quadrature_rows_.row_count() == 0) {
    std::copy(point_values.begin(), point_values.end(), values.begin());
  } else {
    multiply(quadrature_rows_, point_values, values);
  }
}

template <int Dim>
void Transfer<Dim>::add_divergence(std::span<const double> quadrature_values, double factor,
                                   int axis, std::span<double> nodal_force) const {
  const LinearRows<Dim>& linear =
      quadrature_rows_.row_count() == 0 ? linear_at_points_ : linear_at_quadrature_;
  const SparseRows& gradient = linear.gradients[static_cast<std::size_t>(axis)];
  for (std::size_t q = 0; q < quadrature_weight_.size(); ++q) {
    const double share = factor * quadrature_weight_[q] * quadrature_values[q];
    for (std::size_t k = gradient.row_offsets[q]; k < gradient.row_offsets[q + 1]; ++k) {
      nodal_force[static_cast<std::size_t>(gradient.columns[k])] += share * gradient.values[k];
    }
  }
}

template <int Dim>
void Transfer<Dim>::to_points(std::span<const double> nodal_values,
                              std::span<double> point_values) const {
  multiply(linear_at_points_.values, nodal_values, point_values);
}

template <int Dim>
void Transfer<Dim>::gradient_at_points(std::span<const double> nodal_values, int axis,
                                       std::span<double> point_values) const {
  if (strain_rows_.row_count() > 0) return multiply(strain_rows_, nodal_values, point_values);
  multiply(linear_at_points_.gradients[static_cast<std::size_t>(axis)], nodal_values, point_values);
}

template <int Dim>
std::vector<double> Transfer<Dim>::at_cell_centres(std::span<const double> point_values) const {
  std::vector<double> values(cell_count_, 0.0);
  if (quadrature_rows_.row_count() > 0) {
    multiply(quadrature_rows_, point_values, values);
    return values;
  }
  std::vector<double> volume(cell_count_, 0.0);
  for (std::size_t p = 0; p < point_values.size(); ++p) {
    const auto cell = static_cast<std::size_t>(cell_of_point_[p]);
    values[cell] += quadrature_weight_[p] * point_values[p];
    volume[cell] += quadrature_weight_[p];
  }
  for (std::size_t c = 0; c < cell_count_; ++c) values[c] /= volume[c] > 0.0 ? volume[c] : 1.0;
  return values;
}

template class Transfer<1>;
template class Transfer<2>;
template class Transfer<3>;

}  // namespace porowave::solver
