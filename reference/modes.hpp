#pragma once

#include <array>
#include <complex>

#include "reference/problem/material.hpp"

namespace porowave::reference {

using Complex = std::complex<double>;
using Matrix2 = std::array<std::array<double, 2>, 2>;

/// The two wave modes at one value of the Laplace variable s; index 0 is P1, index 1 is P2.
struct ModeState {
  std::array<Complex, 2> slowness;  ///< lambda_k/s, s/m
  std::array<Complex, 2> excess;    ///< lambda_k - s/c_k, 1/m; finite at s -> infinity
  Complex mixing;                   ///< epsilon: e_1 = (1, -epsilon), e_2 = (epsilon, 1)
};

/// Modes of A V'' = s (s D + d J) V (both phases; D, J, A as in README.md of this room).
///
/// In the basis R of the frozen (drag-free) modes, R^T A R = 1 and R^T D R = diag(1/c_k^2), the
/// system is y'' = s (s diag(1/c_k^2) + h h^T) y: one symmetric 2x2 matrix, diagonal plus rank one.
/// Everything the exact solution needs follows from 1/c_k^2 and h without cancellation.
/// Singularities in s: the cut [-relaxation_rate, 0] and one pair of complex branch points where
/// the two modes meet.
class WaveModes {
 public:
  explicit WaveModes(const Material& material);

  /// Frozen speeds, m/s; speed(0) > speed(1).
  double speed(int mode) const { return speed_[static_cast<std::size_t>(mode)]; }
  /// Speed of both phases moving together, m/s.
  double undrained_speed() const { return undrained_speed_; }
  /// drag (1/m_s + 1/m_f), 1/s: the cut of the transform is [-relaxation_rate, 0].
  double relaxation_rate() const { return relaxation_rate_; }
  /// Branch point in the upper half plane, 1/s.
  Complex branch_point() const { return branch_point_; }

  /// Columns r_k: velocities (v_s, v_f) of frozen mode k.
  const Matrix2& velocity_of_mode() const { return velocity_of_mode_; }
  /// Columns A r_k: minus partial tractions (sigma' - n_s p, -n_f p) times c_k of frozen mode k.
  const Matrix2& traction_of_mode() const { return traction_of_mode_; }

  /// The modes meet at the branch points; which of them is called P1 beyond depends on where the
  /// plane is cut. Both agree at large real s. `between`: the cut joins the two branch points, so
  /// both modes are analytic outside of it. `outwards`: cuts run from them to +-i infinity, so both
  /// are analytic all along the positive real axis.
  enum class Cut { between, outwards };
  /// n_s r_sk + n_f r_fk: by how much frozen mode k squeezes the pores.
  const std::array<double, 2>& outflow_of_mode() const { return outflow_of_mode_; }

  /// Modes at s, which lies on no cut.
  ModeState at(Complex s, Cut cut = Cut::between) const;
  /// Limit s -> infinity.
  ModeState frozen() const;

 private:
  std::array<double, 2> speed_;
  std::array<double, 2> drag_;  ///< h_k, with d r^T J r = (h . y)^2
  double undrained_speed_;
  double relaxation_rate_;
  double slowness_gap_;  ///< 1/c_2^2 - 1/c_1^2
  Complex branch_point_;
  Matrix2 velocity_of_mode_;
  Matrix2 traction_of_mode_;
  std::array<double, 2> outflow_of_mode_;
};

}  // namespace porowave::reference
