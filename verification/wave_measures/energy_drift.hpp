#pragma once

#include "verification/wave_measures/grid_fields.hpp"

namespace porowave::verification {

/// By how much the energy of a solution differs from the reference's at the same time, relative to
/// the latter: kinetic 1/2 (n_s rho_s v_s^2 + n_f rho_f v_f^2) plus elastic
/// 1/2 (sigma'^2/E_oed + p^2/K), K = K_f/n_f. Negative: energy was lost.
///
/// Measured against the reference, not against the work of the load: drag uses up a part of that
/// work (reference/energy.hpp has how much), so only without drag would a solution have to keep it.
/// And not against the work that the solution's own end has done: a scheme that conserves its
/// discrete energy would be called right however wrong its fields are. What is left is the net of
/// numerical damping (negative), of noise and ringing (positive), of a wrong drag and of a load
/// that acted at a wrong velocity; a field with the right energy can still be a wrong field.
///
/// Both energies are sums over the same places with the same weights, so the quadrature adds
/// nothing: equal fields have drift zero. Where points are missing (empty elements) both miss them.
struct EnergyDrift {
  double points = 0.0;  ///< over the points, weighted by volume: what the method itself carries
  double field = 0.0;   ///< over cell middles and nodes: what it shows
};

/// NaN where the reference has no energy, or a value is not finite.
EnergyDrift energy_drift(const Material& material, const solver::Snapshot& snapshot,
                         const ReferenceValues& reference);

/// Energy of fields on a grid with cells of length `spacing` (m), J/m^2; half weight at end nodes.
double grid_energy(const Material& material, const GridFields& fields, double spacing);

}  // namespace porowave::verification
