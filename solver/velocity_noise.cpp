#include "solver/velocity_noise.hpp"

#include <vector>

namespace porowave::solver {

void remove_velocity_noise(const Transfer<1>& transfer, int order, std::span<const double> nodal,
                           std::span<double> velocity) {
  std::vector<double> at_nodes(nodal.begin(), nodal.end());
  std::vector<double> seen(velocity.size());
  std::vector<double> rest(velocity.begin(), velocity.end());
  for (int k = 1; k <= order; ++k) {
    if (k > 1) transfer.to_nodes(rest, at_nodes);
    transfer.to_points(at_nodes, seen);
    for (std::size_t p = 0; p < rest.size(); ++p) rest[p] -= seen[p];
  }
  for (std::size_t p = 0; p < rest.size(); ++p) velocity[p] -= rest[p];
}

}  // namespace porowave::solver
