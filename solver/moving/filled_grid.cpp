#include "solver/moving/filled_grid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace porowave::solver {

FilledGrid::FilledGrid(double spacing, double near, double far)
    : spacing_(spacing), near_(near), far_(far) {
  if (!(spacing > 0.0) || !std::isfinite(spacing) || !(near < far) || !std::isfinite(far - near)) {
    throw std::invalid_argument("filled grid: spacing must be positive and the ends in order");
  }
  first_node_ = std::lround(std::floor(near / spacing));
  last_node_ = std::lround(std::ceil(far / spacing));
  // Read off the positions, so that an inner node lies inside whatever the rounding of near / h.
  first_inner_ = node_position(first_node_) < near ? first_node_ + 1 : first_node_;
  last_inner_ = node_position(last_node_) > far ? last_node_ - 1 : last_node_;
  if (last_inner_ - first_inner_ < 2) {
    throw std::invalid_argument("filled grid: the body has fewer than three nodes inside");
  }
}

double FilledGrid::filled_length(long cell) const {
  return std::min(node_position(cell + 1), far_) - std::max(node_position(cell), near_);
}

double FilledGrid::filled_middle(long cell) const {
  return 0.5 * (std::min(node_position(cell + 1), far_) + std::max(node_position(cell), near_));
}

std::vector<double> FilledGrid::nodal_volume() const {
  std::vector<double> volume(node_count(), 0.0);
  for (long c = first_node_; c < last_node_; ++c) {
    const double length = filled_length(c);
    const double share = (filled_middle(c) - node_position(c)) / spacing_;
    volume[at(c)] += length * (1.0 - share);
    volume[at(c + 1)] += length * share;
  }
  collect(volume);
  return volume;
}

void FilledGrid::extend(std::span<double> nodal) const {
  if (first_node_ < first_inner_) nodal[0] = 2.0 * nodal[1] - nodal[2];
  const std::size_t last = nodal.size() - 1;
  if (last_node_ > last_inner_) nodal[last] = 2.0 * nodal[last - 1] - nodal[last - 2];
}

void FilledGrid::collect(std::span<double> nodal) const {
  const auto collect_from = [&](std::size_t outer, std::size_t next, std::size_t second) {
    nodal[next] += 2.0 * nodal[outer];
    nodal[second] -= nodal[outer];
    nodal[outer] = 0.0;
  };
  if (first_node_ < first_inner_) collect_from(0, 1, 2);
  const std::size_t last = nodal.size() - 1;
  if (last_node_ > last_inner_) collect_from(last, last - 1, last - 2);
}

void FilledGrid::internal_force(std::span<const double> cell_stress, double near_stress,
                                double far_stress, std::span<double> force) const {
  for (long c = first_node_; c < last_node_; ++c) {
    const double push = cell_stress[at(c)] * filled_length(c) / spacing_;
    force[at(c)] += push;
    force[at(c + 1)] -= push;
  }
  const auto act = [&](double end, double stress) {
    const long c = cell_of(end);
    const double share = (end - node_position(c)) / spacing_;
    force[at(c)] += stress * (1.0 - share);
    force[at(c + 1)] += stress * share;
  };
  act(near_, -near_stress);
  act(far_, far_stress);
  collect(force);
}

double FilledGrid::value(std::span<const double> nodal, double x) const {
  const long c = cell_of(x);
  const double share = (x - node_position(c)) / spacing_;
  return nodal[at(c)] + share * (nodal[at(c + 1)] - nodal[at(c)]);
}

long FilledGrid::cell_of(double x) const {
  return std::clamp(std::lround(std::floor(x / spacing_)), first_node_, last_node_ - 1);
}

}  // namespace porowave::solver
