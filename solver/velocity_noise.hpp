#pragma once

// The extended particle-in-cell update of order m, XPIC(m): Hammerquist & Nairn (2017),
// doi:10.1016/j.cma.2017.01.035.
//
// With S from nodes to points and S⁺ from points to nodes, FLIP keeps whatever S⁺ does not see of
// the points' velocities V; PIC removes it, and with it (I − S S⁺) V, of second order in h, in
// every step. XPIC removes
//
//   r_m = (I − S S⁺)^m V,   V ← V − r_m + S Δv
//
// m = 1 is PIC; m → ∞ leaves all that the nodes can represent and removes the noise alone. From
// m = 2 on what is lost of smooth fields is of higher order than the scheme.

#include <span>
#include <vector>

#include "solver/transfer.hpp"

namespace porowave::solver {

// V ← V − r_m. `nodal` is S⁺V, with what the ends prescribe; order >= 1. One pair of transfers for
// every order beyond the first.
void remove_velocity_noise(const Transfer<1>& transfer, int order, std::span<const double> nodal,
                           std::span<double> velocity);

// The same for any pair of transfers, to_nodes(points, nodes) = S⁺ and to_points(nodes, points) =
// S.
template <class ToNodes, class ToPoints>
void remove_velocity_noise(ToNodes&& to_nodes, ToPoints&& to_points, int order,
                           std::span<const double> nodal, std::span<double> velocity) {
  std::vector<double> at_nodes(nodal.begin(), nodal.end());
  std::vector<double> seen(velocity.size());
  std::vector<double> rest(velocity.begin(), velocity.end());
  for (int k = 1; k <= order; ++k) {
    if (k > 1) to_nodes(std::span<const double>(rest), std::span<double>(at_nodes));
    to_points(std::span<const double>(at_nodes), std::span<double>(seen));
    for (std::size_t p = 0; p < rest.size(); ++p) rest[p] -= seen[p];
  }
  for (std::size_t p = 0; p < rest.size(); ++p) velocity[p] -= rest[p];
}

}  // namespace porowave::solver
