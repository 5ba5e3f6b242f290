#pragma once

#include <span>
#include <vector>

#include "reference/quantities.hpp"

namespace porowave::reference {

/// Where the energy is that the load has put into a column, per unit of its cross-section (J/m^2).
/// Errors are estimates: of the quadratures, and of the fields that enter them.
struct EnergyBalance {
  double t = 0.0;      ///< s
  Bounded settlement;  ///< of the loaded end, m, positive into the column
  Bounded work;        ///< int_0^t [(n_s p - sigma') v_s + n_f p v_f] at x = 0 dt
  Bounded kinetic;     ///< 1/2 int (n_s rho_s v_s^2 + n_f rho_f v_f^2) dx
  Bounded elastic;     ///< 1/2 int (sigma'^2/E_oed + p^2/K) dx, K = K_f/n_f
  Bounded dissipated;  ///< by drag: int_0^t int d (v_f - v_s)^2 dx dt = work - kinetic - elastic
};

/// The balance at time t; all zero for t <= 0. No far end does work, so what the loaded end does is
/// all there is; it follows from the governing equations (problem/problem.hpp) times v_s and v_f.
///
/// Energies are integrals over x of the series of Profile (to the first front in a half-space),
/// work is an adaptive integral over time. Errors are mostly 1e-13 to 1e-9 of the work, and grow
/// with those of the fields: 3e-6 was seen at relaxation_rate * t = 1e8. The dissipated energy is a
/// difference: where drag has used up little, its error is still that of the others. Infinite
/// errors where the fields are not resolved, or more than 4000 waves have come back to the loaded
/// end. Throws InputError for a time that is not finite.
EnergyBalance energy_balance(const ColumnSolution& solution, double t);

/// The balances at several times, in the order given; each interval of time is integrated once.
/// Throws InputError for times that are not finite.
std::vector<EnergyBalance> energy_balances(const ColumnSolution& solution,
                                           std::span<const double> times);

}  // namespace porowave::reference
