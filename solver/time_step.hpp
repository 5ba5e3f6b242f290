#pragma once

// How many steps a run has, and stable time steps by formula, without looking at the eigenvalues of
// the step: what stability/automatic_step.hpp falls back on.

#include "solver/case.hpp"

namespace porowave::solver {

// Steps of a run on cells of length `spacing` (m): the fewest equal ones that are no longer than
// the Courant number of the case allows. Throws InputError for more than 1e12.
long step_count(const Case& scene, double spacing);

// An estimate of a stable Courant number c_1 Δt/h for a case, c_1 the speed of the fast wave
// without drag; > 0 and <= 1. Drag and load have no part in it: drag is integrated exactly.
//
//   shape, apic   0.9 linear_shape_limit(scene), 0.64 for uniform points
//   mls           0.7; 0.4 with points that are random over the whole column
//   staggered4    0.8; 0.5 with points that are not uniform, unless time_order = 4
//
// The last two are measured and not proven. Moving least squares are not the adjoint of what goes
// back to the points, and with irregular ones no step is safe for every set of points: shorter
// steps are less stable, not more, because FLIP damps with the step what the points cannot see.
// Spectral radius of the step without drag, 40 columns of 30 cells with 4 stratified points each, 6
// kernels of basis order 1: above 1 in 240 of 240 columns at courant 0.02, 7 at 0.5, none at 0.7
// and again 7 (by more, 1.3) at 0.8; with recovered strains in 17, 3, 2 and 1 of 240. The growth of
// those left is below 1.004 a step. Supports far beyond the natural one were not measured.
// staggered4: solver/README.md.
double estimated_courant(const Case& scene);

// The largest Courant number at which transfer = "shape" with linear functions is stable without
// drag, for the points of the case: √min over nodes i and phases of Σ_p V_p N_i(x_p) / V_i, V_i the
// volume of points in the cells next to i (of the phase that has more of it). 1/√2 for uniform
// points; 1 at most.
//
// Why: the energy of the strains is at most λ times that of the velocities with Δt² λ = 2 at this
// step (c_1 bounds both phases of a cell, rows of the stiffness matrix the nodes of it). With FLIP,
// velocities that the points cannot see act in the strains of one step only: they are stable up to
// Δt² λ = 2, those that the points see up to 4. Wider functions and apic are more stable; measured,
// 20 columns each as above, stratified and random, 1 to 4 points a cell.
double linear_shape_limit(const Case& scene);

}  // namespace porowave::solver
