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

#include "solver/transfer.hpp"

namespace porowave::solver {

// V ← V − r_m. `nodal` is S⁺V, with what the ends prescribe; order >= 1. One pair of transfers for
// every order beyond the first.
void remove_velocity_noise(const Transfer<1>& transfer, int order, std::span<const double> nodal,
                           std::span<double> velocity);

}  // namespace porowave::solver
