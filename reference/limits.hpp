#pragma once

#include "reference/problem/problem.hpp"

/// The limits of the column problem that have a closed form of their own. They share no code with
/// the exact solution, which must tend to them at the rate given (limits_test.cpp measures it).
/// theta is the relaxation rate of the material, T the time over which the load changes. Points are
/// in the column, 0 <= x <= length, and times finite.
namespace porowave::reference {

/// theta t -> 0, no drag (permeability -> infinity): d'Alembert's solution, two waves at the frozen
/// speeds that the ends reflect and convert. Every near and far end and load; at a front the value
/// behind it. The exact solution differs by O(theta t). The cost doubles with every crossing where
/// an end converts waves: for a few crossings.
Fields undamped(const Problem& problem, double x, double t);

/// theta T -> infinity, both phases rigidly coupled (permeability -> 0): one wave at the undrained
/// speed, sigma' and p sharing the total stress as E : -K. Of two conditions at an end only that on
/// the total stress or on the solid velocity is kept. Every near and far end and load.
///
/// For a load with two continuous derivatives the exact solution differs by O(1/(theta T)) away
/// from the ends. Within some sqrt(c_v T) = O((theta T)^-1/2) of an end a diffusive layer is added
/// that meets the other condition: where pressure is prescribed it changes p and sigma' by O(1) and
/// the velocities by O((theta T)^-1/2); where v_s = v_f is prescribed, p and sigma' by O((theta
/// T)^-1/2) and the velocities by O(1/(theta T)). Fluid that enters and leaves the layer of
/// rigid_drained takes O((theta T)^-1/2) from the wave that is reflected there.
Fields rigidly_coupled(const Problem& problem, double x, double t);

}  // namespace porowave::reference
