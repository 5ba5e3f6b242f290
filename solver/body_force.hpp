#pragma once

// Volume forces on both phases of the column, as a function of place and time: b_s and b_f in
//
//   n_s ρ_s Dv_s/Dt = ∂σ′/∂x − n_s ∂p/∂x − f_d + b_s
//   n_f ρ_f Dv_f/Dt =        − n_f ∂p/∂x + f_d + b_f
//
// For manufactured solutions. (Weight is no such case: b_s = n_s ρ_s g would need the stresses that
// carry it at t = 0.)

#include <functional>
#include <vector>

#include "reference/problem/material.hpp"
#include "solver/grid.hpp"
#include "solver/range_rows.hpp"

namespace porowave::solver {

// N/m³ of mixture.
struct PhaseForces {
  double solid;
  double fluid;
};

// Present place x in m, time t in s. Asked at nodes, at the times of the stresses, by several
// threads at once.
using BodyForce = std::function<PhaseForces(double x, double t)>;

// The volume of the nodes of a grid that each phase fills, m.
struct FilledVolumes {
  const std::vector<double>& solid;
  const std::vector<double>& fluid;
};

// Adds a share of the body force at time t to the forces −∫ ∂N_i s dx of effective stress and pore
// pressure, N, from the first node of the range on, from which f_s = effective − n_s pressure and
// f_f = −n_f pressure are made: with share 1, f_s grows by b_s V_s and f_f by b_f V_f.
void add_body_force(const BodyForce& force, double t, double share, const Material& material,
                    const Grid<1>& grid, const FilledVolumes& volumes, IndexRange nodes,
                    double* effective, double* pressure);

}  // namespace porowave::solver
