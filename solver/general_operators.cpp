#include "solver/general_operators.hpp"

#include <algorithm>

#include "solver/velocity_noise.hpp"

namespace porowave::solver {

void GeneralOperators::gather(const PointValues& points, IndexRange nodes, double* nodal_velocity,
                              double* force) const {
  transfer_.to_nodes(points.velocity, {nodal_velocity, nodes.size()});
  transfer_.add_affine(points.velocity_gradient, 0, {nodal_velocity, nodes.size()});
  std::vector<double> quadrature;
  transfer_.to_quadrature(points.stress, quadrature);
  std::fill_n(force, nodes.size(), 0.0);
  transfer_.add_divergence(quadrature, -1.0, 0, {force, nodes.size()});
}

void GeneralOperators::scatter(const PointUpdate& update, IndexRange cells,
                               PointValues& points) const {
  const std::size_t nodes = cells.size() + 1;
  if (update.xpic_order > 0) {
    remove_velocity_noise(transfer_, update.xpic_order, {update.before, nodes}, points.velocity);
  }
  if (!points.velocity_gradient.empty()) {
    transfer_.gradient_at_points({update.after, nodes}, 0, points.velocity_gradient);
  }
  std::vector<double> nodal(nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    nodal[i] = update.after[i] - update.flip * update.before[i];
  }
  std::vector<double> change(points_);
  transfer_.to_points(nodal, change);
  for (std::size_t p = 0; p < points_; ++p) {
    points.velocity[p] = update.flip * points.velocity[p] + change[p];
  }
  transfer_.gradient_at_points({update.b, nodes}, 0, change);
  for (std::size_t p = 0; p < points_; ++p) points.stress[p] += update.c * change[p];
}

void GeneralOperators::to_points(const double* nodal, double* at_points) const {
  transfer_.to_points({nodal, transfer_.nodal_mass().size()}, {at_points, points_});
}

void GeneralOperators::gradient_at_points(const double* nodal, double* at_points) const {
  transfer_.gradient_at_points({nodal, transfer_.nodal_mass().size()}, 0, {at_points, points_});
}

}  // namespace porowave::solver
