#pragma once

// The transfer of MLS-MPM (Hu et al. 2018, doi:10.1145/3197517.3201293), the affine
// particle-in-cell method of Jiang et al. (2015), doi:10.1145/2766996, with its forces:
//
//   to the nodes    m_i v_i = Σ_p m_p N_i (v_p + C_p (x_i − x_p))
//   to the points   v_p = Σ_i N_i v_i,   C_p = Σ_i G_pi v_i,   G_pi = N_i (x_i − x_p) / D_p
//   force           f_i = −Σ_p V_p G_pi s_p
//   D_p = Σ_i N_i (x_i − x_p)²: h²/4 for the quadratic and h²/3 for the cubic spline away from the
//   ends, and what the boundary functions make of it next to them
//
// per axis. Because Σ_i N_i (x_i − x_p) = 0 linear momentum is conserved by both transfers and by
// the forces; because D_p is the exact second moment, C_p is exact for linear fields up to the
// ends. With linear functions G_pi is ∂N_i.

#include <array>
#include <span>
#include <vector>

#include "solver/weights.hpp"

namespace porowave::solver {

// Replaces the gradients in the rows of shape functions by G_pi; gives D_p of every axis, in
// length². Where D_p is below 1e-8 h² (a point on the end of the grid) G_pi is its limit ∂N_i.
template <int Dim>
std::array<std::vector<double>, Dim> make_affine(std::span<const Vector<Dim>> points,
                                                 const Grid<Dim>& grid, LinearRows<Dim>& rows);

}  // namespace porowave::solver
