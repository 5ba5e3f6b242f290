#pragma once

#include "reference/problem/problem.hpp"

namespace porowave::reference {

/// No inertia: Terzaghi's consolidation of a column that is drained at x = 0 and rigid_sealed at
/// its length, under a load that changes in time,
///
///   dp/dt = K/(E + K) dq/dt + c_v p'',   sigma' = p - q (total stress -q),
///   E v_s' = dp/dt - dq/dt,   n_f (v_f - v_s) = -kappa/mu p',
///
/// by its eigenfunctions sin((j + 1/2) pi x/L), each convolved with the load in closed form. Ends:
/// drained_traction or fluid_pressure, with rigid_sealed. Loads: step (t > 0), smooth_ramp and
/// sin4_pulse. Throws InputError for others. Pressures to 1e-11 of the load for c_v t/L^2 > 1e-6
/// under a step, and for c_v T/L^2 > 0.1 under the others.
///
/// With c_v T/L^2 fixed, the exact solution under a smooth load differs by the fraction
/// O((L/(c T))^2), c the undrained speed, which then is a fixed multiple of 1/(theta T). A step
/// also sets off an undrained wave that drag takes long to damp. Source: Terzaghi (1925); Verruijt,
/// Theory and Problems of Poroelasticity (2013), chapter 2.
Fields consolidating(const Problem& problem, double x, double t);

}  // namespace porowave::reference
