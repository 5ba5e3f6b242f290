#pragma once

#include <vector>

#include "reference/problem/problem.hpp"
#include "solver/body_force.hpp"

namespace porowave::verification {

/// A manufactured motion of the saturated column, and the volume forces that make it a solution of
/// the small-strain equations (problem.hpp) with every term at work.
///
/// Both displacements are sums of modes a phi_k(x) sin(w t + c),
///
///   near = velocity, q = 0          phi_k = sin(k pi x/L): no displacement at either end
///   near = drained_traction, q = 0  phi_k = cos((k - 1/2) pi x/L): no stress and no pressure at
///                                   x = 0, no displacement at x = L
///
/// with far = rigid_sealed. With u = (u_s, u_f), v = du/dt and K = K_f/n_f,
///
///   sigma' = E u_s',  p = -K (n_s u_s' + n_f u_f')         (nothing but what the rates integrate
///   to) b_s = n_s rho_s dv_s/dt - sigma'' + n_s p' - d (v_f - v_s)       ('' the slope of sigma')
///   b_f = n_f rho_f dv_f/dt           + n_f p' + d (v_f - v_s)
class TwoPhaseMotion {
 public:
  /// `near` one of the two above, else std::invalid_argument. The relative displacement is chosen
  /// such that drag is of the size of the fluid's inertia, however stiff it is. Strains are of the
  /// size of `strain`.
  TwoPhaseMotion(const Material& material, double length, NearEnd near, double strain);

  /// Material, column and the load zero.
  const Problem& problem() const { return problem_; }
  Fields fields(double x, double t) const;
  solver::PhaseForces body_force(double x, double t) const;
  /// The time in which the slowest mode turns by one radian, s.
  double time_scale() const { return 1.0 / rate_; }

 private:
  struct Mode {
    double amplitude;  ///< m
    int number;        ///< k
    double rate;       ///< w, 1/s
    double phase;      ///< c
  };
  using Modes = std::vector<Mode>;

  /// The derivative of a displacement, `in_x` times in place and `in_t` times in time.
  double derivative(const Modes& modes, int in_x, int in_t, double x, double t) const;

  Problem problem_;
  double rate_;
  Modes solid_;
  Modes fluid_;
};

}  // namespace porowave::verification
