#include "solver/velocity_noise.hpp"

namespace porowave::solver {

void remove_velocity_noise(const Transfer<1>& transfer, int order, std::span<const double> nodal,
                           std::span<double> velocity) {
  remove_velocity_noise([&](std::span<const double> points,
                            std::span<double> nodes) { transfer.to_nodes(points, nodes); },
                        [&](std::span<const double> nodes, std::span<double> points) {
                          transfer.to_points(nodes, points);
                        },
                        order, nodal, velocity);
}

}  // namespace porowave::solver
