#include "solver/frozen_phase.hpp"

#include <algorithm>
#include <stdexcept>

#include "solver/simd.hpp"

namespace porowave::solver {

namespace {

bool all_zero(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return v == 0.0; });
}

std::vector<int> cells_of_points(const CompactOperators& compact) {
  std::vector<int> cell(compact.points_of({0, compact.cell_count()}).last);
  for (std::size_t c = 0; c < compact.cell_count(); ++c) {
    const Range points = compact.points_of({c, c + 1});
    std::fill(cell.begin() + static_cast<std::ptrdiff_t>(points.first),
              cell.begin() + static_cast<std::ptrdiff_t>(points.last), static_cast<int>(c));
  }
  return cell;
}

POROWAVE_VECTORISED void add_to_nodes(double flip, const double* __restrict before,
                                      const double* __restrict after, std::size_t count,
                                      double* __restrict q) {
  for (std::size_t i = 0; i < count; ++i) q[i] = flip * (q[i] - before[i]) + after[i];
}

POROWAVE_VECTORISED void add_to_cells(double factor, const double* __restrict b, std::size_t count,
                                      double* __restrict e) {
  for (std::size_t c = 0; c < count; ++c) e[c] += factor * (b[c + 1] - b[c]);
}

POROWAVE_VECTORISED void difference(const double* __restrict cell_stress, std::size_t nodes,
                                    double* __restrict force) {
  for (std::size_t i = 0; i < nodes; ++i) force[i] = cell_stress[i + 1] - cell_stress[i];
}

}  // namespace

FrozenOperators::FrozenOperators(const CompactOperators& compact) : spacing(compact.spacing()) {
  const std::vector<int> cell = cells_of_points(compact);
  nodes = BandedRows(compact.node_rows(), [&](std::size_t p) {
    const double t = compact.place_in_cell(p);
    return PointRow{cell[p], {1.0 - t, t}};
  });
  cells = BandedRows(compact.cell_rows(), [&](std::size_t p) {
    return PointRow{cell[p], {1.0, 0.0}};
  });
}

bool FrozenPhase::possible(const ColumnOperators& points) {
  return dynamic_cast<const CompactOperators*>(&points) != nullptr;
}

FrozenPhase::FrozenPhase(std::shared_ptr<const ColumnOperators> points,
                         std::span<const double> velocity, std::span<const double> stress)
    : points_(std::dynamic_pointer_cast<const CompactOperators>(std::move(points))) {
  if (!points_) throw std::invalid_argument("frozen phase: the operators have no compact form");
  operators_ = std::make_shared<const FrozenOperators>(*points_);
  node_count_ = points_->cell_count() + 1;
  node_values_ = PaddedValues(node_count_, operators_->nodes.reach());
  cell_values_ = PaddedValues(node_count_ - 1, operators_->cells.reach());
  if (!all_zero(velocity)) {
    first_velocity_.resize(node_count_);
    multiply(points_->node_rows(), {0, node_count_}, velocity.data(), first_velocity_.data());
  }
  if (!all_zero(stress)) {
    first_stress_.resize(node_count_ - 1);
    multiply(points_->cell_rows(), {0, node_count_ - 1}, stress.data(), first_stress_.data());
  }
}

void FrozenPhase::gather(Range nodes, double* nodal_velocity, double* force) const {
  operators_->nodes.multiply(nodes, node_values_.data(), nodal_velocity);
  for (std::size_t k = 0; !first_velocity_.empty() && k < nodes.size(); ++k) {
    nodal_velocity[k] += kept_ * first_velocity_[nodes.first + k];
  }
  // The stresses of the cells from nodes.first − 1 on, zero beyond the ends.
  double cell_stress[BandedRows::block_rows + 1];
  for (Range part = nodes; part.first < nodes.last; part.first = part.last) {
    part.last = std::min(part.first + BandedRows::block_rows, nodes.last);
    cell_stress[0] = cell_stress[part.size()] = 0.0;
    const Range cells{part.first == 0 ? 0 : part.first - 1, std::min(part.last, node_count_ - 1)};
    double* out = cell_stress + (part.first == 0 ? 1 : 0);
    operators_->cells.multiply(cells, cell_values_.data(), out);
    for (std::size_t k = 0; !first_stress_.empty() && k < cells.size(); ++k) {
      out[k] += first_stress_[cells.first + k];
    }
    difference(cell_stress, part.size(), force + (part.first - nodes.first));
  }
}

void FrozenPhase::scatter(const PointUpdate& update, Range cells) {
  // A part owns the nodes at the lower ends of its cells; the last one also the column's end.
  const bool at_end = cells.last + 1 == node_count_;
  add_to_nodes(update.flip, update.before, update.after, cells.size() + (at_end ? 1 : 0),
               node_values_.data() + cells.first);
  add_to_cells(update.c / operators_->spacing, update.b, cells.size(),
               cell_values_.data() + cells.first);
}

void FrozenPhase::settle(std::span<double> velocity, std::span<double> stress) const {
  const double* q = node_values_.data();
  for (std::size_t c = 0; c + 1 < node_count_; ++c) {
    const Range points = points_->points_of({c, c + 1});
    for (std::size_t p = points.first; p < points.last; ++p) {
      velocity[p] = kept_ * velocity[p] + (q[c] + (q[c + 1] - q[c]) * points_->place_in_cell(p));
      stress[p] += cell_values_.data()[c];
    }
  }
}

}  // namespace porowave::solver
