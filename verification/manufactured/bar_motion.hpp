#pragma once

#include "solver/moving/bar.hpp"

namespace porowave::verification {

/// A manufactured motion of a bar in finite strain, and the body force that makes it a solution.
///
/// Undeformed place X in [0, L], place x = X + u(X, t), with
///
///   u = L g(t) (shift + stretch X/L + wave cos(pi X/L) + bulge sin(pi X/L)),
///   g = (1 - cos(pi t/T))/2
///
/// so the bar is undeformed and at rest at t = 0, and g(T) = 1. The stretch must stay positive:
/// stretch > -1 + pi (|wave| + |bulge|) is enough. With only `bulge` the ends stay where they are;
/// with wave and shift they move, free of stress; `stretch` puts stress on them.
///
///   F = 1 + du/dX,  v = du/dt,  sigma = sigma(F),  b = (rho_0/F) d2u/dt2 - (dsigma/dF)(dF/dX)/F
///
/// from momentum rho Dv/Dt = dsigma/dx + b and d/dx = (1/F) d/dX. SI units.
struct BarMotion {
  double length = 0.0;    ///< L, m
  double duration = 0.0;  ///< T, s
  double density = 0.0;   ///< rho_0, kg/m^3
  solver::ConstitutiveLaw law;
  double shift = 0.0;
  double stretch = 0.0;
  double wave = 0.0;
  double bulge = 0.0;

  double place(double X, double t) const;              ///< x, m
  double deformation(double X, double t) const;        ///< F
  double deformation_slope(double X, double t) const;  ///< dF/dX, 1/m
  double velocity(double X, double t) const;
  double acceleration(double X, double t) const;
  double stress(double X, double t) const;
  /// N/m^3 of the deformed bar.
  double body_force(double X, double t) const;
  /// X from x, by Newton's method to rounding; also a little beyond the ends.
  double undeformed_place(double x, double t) const;

  /// The problem for the solver, its ends held or under the stress of the solution. Throws
  /// std::invalid_argument if ends to be held move.
  solver::Bar bar(bool held) const;
  /// Largest wave speed on the grid over all X and times up to T, sampled.
  double fastest_wave() const;
};

}  // namespace porowave::verification
