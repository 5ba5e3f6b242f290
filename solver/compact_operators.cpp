#include "solver/compact_operators.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "solver/simd.hpp"

namespace porowave::solver {

namespace {

// Σ_p V_p s_p/h, cell by cell.
RangeRows volume_rows(const std::vector<std::size_t>& first_point,
                      const std::vector<double>& volume, double spacing) {
  RangeRows rows;
  for (std::size_t c = 0; c + 1 < first_point.size(); ++c) {
    rows.first_column.push_back(static_cast<std::int32_t>(first_point[c]));
  }
  rows.row_offsets = first_point;
  for (const double v : volume) rows.values.push_back(v / spacing);
  return rows;
}

// The points [p, last) of one cell.
POROWAVE_INLINE void scatter_to_cell(double flip, double low, double rise, double stress_rise,
                                     const double* place, IndexRange points, double* velocity,
                                     double* stress) {
  std::size_t p = points.first;
  for (; p + 4 <= points.last; p += 4) {
    Four v, s, t;
    read(velocity + p, v);
    read(stress + p, s);
    read(place + p, t);
    write(flip * v + (low + rise * t), velocity + p);
    write(s + stress_rise, stress + p);
  }
  for (; p < points.last; ++p) {
    velocity[p] = flip * velocity[p] + (low + rise * place[p]);
    stress[p] += stress_rise;
  }
}

POROWAVE_VECTORISED void scatter_to_cells(const PointUpdate& update, double per_spacing,
                                          IndexRange cells, const std::size_t* first_point,
                                          const double* place, double* velocity, double* stress) {
  const double factor = update.c * per_spacing;
  const auto change = [&](std::size_t k) {
    return update.after[k] - update.flip * update.before[k];
  };
  double low = change(0);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const std::size_t c = cells.first + k;
    const double high = change(k + 1);
    scatter_to_cell(update.flip, low, high - low, factor * (update.b[k + 1] - update.b[k]), place,
                    {first_point[c], first_point[c + 1]}, velocity, stress);
    low = high;
  }
}

}  // namespace

CompactOperators::CompactOperators(Transfer<1>&& transfer, const PointSet<1>& points,
                                   const Grid<1>& grid)
    : first_point_(static_cast<std::size_t>(grid.cell_count()) + 1, 0), spacing_(grid.spacing) {
  place_in_cell_.reserve(points.x.size());
  for (const Vector<1>& x : points.x) {
    const int cell = grid.cell_of(x)[0];
    ++first_point_[static_cast<std::size_t>(cell) + 1];
    place_in_cell_.push_back(grid.linear_shape(x).values[1]);
  }
  std::partial_sum(first_point_.begin(), first_point_.end(), first_point_.begin());

  TransferRows rows = std::move(transfer).take_rows();
  if (rows.strain.row_count() > 0) {
    shared_strains_ = SharedStrains(rows.strain, first_point_, place_in_cell_);
    rows.strain = {};
  }
  node_rows_ = range_rows(std::move(rows.to_nodes));
  if (rows.to_quadrature.row_count() > 0) {
    cell_rows_ = range_rows(std::move(rows.to_quadrature));
    reach_ = reach_of_rows();
    return;
  }
  cell_rows_ = volume_rows(first_point_, points.volume, spacing_);
  mean_factor_.resize(cell_count());
  multiply(cell_rows_, {0, cell_count()}, std::vector<double>(points.x.size(), 1.0).data(),
           mean_factor_.data());
  for (double& factor : mean_factor_) factor = factor > 0.0 ? 1.0 / factor : 0.0;
  reach_ = reach_of_rows();
}

void CompactOperators::gather(const PointValues& points, IndexRange nodes, double* nodal_velocity,
                              double* force) const {
  multiply(node_rows_, nodes, points.velocity.data(), nodal_velocity);
  const double* stress = points.stress.data();
  // Node i lies between the cells i − 1 and i; there is no stress beyond the ends.
  double before = 0.0;
  if (nodes.first > 0) multiply(cell_rows_, {nodes.first - 1, nodes.first}, stress, &before);
  const IndexRange cells{nodes.first, std::min(nodes.last, cell_count())};
  multiply(cell_rows_, cells, stress, force);
  if (cells.last < nodes.last) force[nodes.size() - 1] = 0.0;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const double cell_stress = force[k];
    force[k] -= before;
    before = cell_stress;
  }
}

void CompactOperators::scatter(const PointUpdate& update, IndexRange cells,
                               PointValues& points) const {
  PointUpdate rest = update;
  if (!shared_strains_.empty()) {
    shared_strains_.add(cells, first_point_, place_in_cell_.data(), update.b, update.c / spacing_,
                        points.stress.data());
    rest.c = 0.0;
  }
  scatter_to_cells(rest, 1.0 / spacing_, cells, first_point_.data(), place_in_cell_.data(),
                   points.velocity.data(), points.stress.data());
}

void CompactOperators::to_points(const double* nodal, double* at_points) const {
  for (std::size_t c = 0; c < cell_count(); ++c) {
    for (std::size_t p = first_point_[c]; p < first_point_[c + 1]; ++p) {
      at_points[p] = nodal[c] + (nodal[c + 1] - nodal[c]) * place_in_cell_[p];
    }
  }
}

void CompactOperators::gradient_at_points(const double* nodal, double* at_points) const {
  if (!shared_strains_.empty()) {
    std::fill_n(at_points, place_in_cell_.size(), 0.0);
    return shared_strains_.add({0, cell_count()}, first_point_, place_in_cell_.data(), nodal,
                               1.0 / spacing_, at_points);
  }
  for (std::size_t c = 0; c < cell_count(); ++c) {
    std::fill(at_points + first_point_[c], at_points + first_point_[c + 1],
              (nodal[c + 1] - nodal[c]) / spacing_);
  }
}

std::size_t CompactOperators::cell_of(std::size_t point, std::size_t near) const {
  while (point < first_point_[near]) --near;
  while (point >= first_point_[near + 1]) ++near;
  return near;
}

// A node moves the points of the cells beside it, these the nodes and cell middles whose rows touch
// them, and a cell's stress the nodes at its ends.
std::size_t CompactOperators::reach_of_rows() const {
  std::size_t reach = 0;
  for (const RangeRows* rows : {&node_rows_, &cell_rows_}) {
    for (std::size_t r = 0; r < rows->row_count(); ++r) {
      const IndexRange points = rows->columns(r);
      if (points.size() == 0) continue;
      const std::size_t near = std::min(r, cell_count() - 1);
      const std::size_t first = cell_of(points.first, near);
      const std::size_t last = cell_of(points.last - 1, near);
      reach = std::max({reach, r > first ? r - first : 0, last + 1 > r ? last + 1 - r : 0});
    }
  }
  return reach + (shared_strains_.empty() ? 1 : 2);
}

std::vector<double> CompactOperators::at_cell_centres(std::span<const double> stress) const {
  std::vector<double> values(cell_count());
  multiply(cell_rows_, {0, cell_count()}, stress.data(), values.data());
  for (std::size_t c = 0; c < mean_factor_.size(); ++c) values[c] *= mean_factor_[c];
  return values;
}

}  // namespace porowave::solver
