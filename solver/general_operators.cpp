#include "solver/general_operators.hpp"

#include <algorithm>

namespace porowave::solver {

void GeneralOperators::gather(const double* velocity, const double* stress, Range nodes,
                              double* nodal_velocity, double* force) const {
  transfer_.to_nodes({velocity, points_}, {nodal_velocity, nodes.size()});
  std::vector<double> quadrature;
  transfer_.to_quadrature({stress, points_}, quadrature);
  std::fill_n(force, nodes.size(), 0.0);
  transfer_.add_divergence(quadrature, -1.0, 0, {force, nodes.size()});
}

void GeneralOperators::scatter(const PointUpdate& update, Range cells, double* velocity,
                               double* stress) const {
  const std::size_t nodes = cells.size() + 1;
  std::vector<double> nodal(nodes);
  for (std::size_t i = 0; i < nodes; ++i)
    nodal[i] = update.after[i] - update.flip * update.before[i];
  std::vector<double> change(points_);
  transfer_.to_points(nodal, change);
  for (std::size_t p = 0; p < points_; ++p) velocity[p] = update.flip * velocity[p] + change[p];
  transfer_.gradient_at_points({update.b, nodes}, 0, change);
  for (std::size_t p = 0; p < points_; ++p) stress[p] += update.c * change[p];
}

void GeneralOperators::to_points(const double* nodal, double* at_points) const {
  transfer_.to_points({nodal, transfer_.nodal_mass().size()}, {at_points, points_});
}

}  // namespace porowave::solver
