#pragma once

#include <array>
#include <vector>

#include "reference/modal_load.hpp"
#include "reference/problem/problem.hpp"

/// The column in cosines and sines.
///
/// With s^ = (sigma'/sqrt(E), -p/sqrt(K)) and v^ = (sqrt(m_s) v_s, sqrt(m_f) v_f) the governing
/// equations are s^_t = B v^_x and v^_t = B^T s^_x - (drag) v^. The singular value decomposition
/// B = X diag(c) W^T turns them, with z = X^T s^ and w = W^T v^, into
///
///   z_t = c w_x,   w_t = c z_x - g (g . w),   z(0, t) = z_0 q(t),   w(L, t) = 0
namespace porowave::reference::quarter_wave {

using Pair = std::array<double, 2>;
/// z_1, z_2 with the sines, w_1, w_2 with the cosines.
using Amplitudes = std::array<double, 4>;

class Frame {
 public:
  /// near is drained_traction or fluid_pressure.
  explicit Frame(const Problem& problem);

  const Pair& speed() const { return speed_; }        ///< c, m/s
  const Pair& drag() const { return drag_; }          ///< g, 1/sqrt(s)
  const Pair& boundary() const { return boundary_; }  ///< z_0 for a unit load
  /// The physical fields of z and w.
  std::array<double, 4> fields(const Amplitudes& amplitudes) const;

 private:
  Pair speed_;
  Pair drag_;
  Pair boundary_;
  std::array<Pair, 2> stress_;    ///< fields = stress_ z
  std::array<Pair, 2> velocity_;  ///< fields = velocity_ w
};

/// Amplitudes at the load's time t of the mode with wave number k in z - z_0 q and w, if the
/// constant 1 has the coefficient `share` in this mode's sine. The 4x4 system is solved by the
/// residues of its resolvent, where they nearly coincide by a contour around them.
Amplitudes mode_amplitudes(const Frame& frame, const SmoothLoad& load, double t, double k,
                           double share);

/// What is smooth in time in the modes falls off slowly with k only because the fields have
/// derivatives at the loaded end that no cosine or sine has there. For large k their coefficients
/// are, times the coefficient of the constant 1,
///
///   z: Z_0 - Z_1/k^2 + Z_2/k^4 - ...,   w: -W_0/k + W_1/k^3 - ...,
///   Z_0 = z_0 q,  c W_i = Z_i',  c Z_i+1 = W_i' + g (g . W_i)
///
/// Layers (1 - cosh(m (L - x))/cosh(m L))/m^2 with the coefficients 1/(k^2 + m^2), and their slopes
/// with k/(k^2 + m^2), are combined to have the same first terms. Unlike the polynomials in x that
/// these terms sum up to, they stay of the size of the load when consolidation is slow.
class EndLayers {
 public:
  EndLayers(const Frame& frame, const SmoothLoad& load, double length, double peak);

  Amplitudes at(double x) const;
  /// What the modes give for them: coefficients of z - z_0 q and w in the mode with wave number k.
  Amplitudes coefficients(double k, double share) const;
  /// Largest value of a term anywhere, of z or w.
  double size() const;
  /// Of the thinnest layer, m, 1/m: modes must be well beyond it.
  double steepest() const { return layers_.back().m; }

 private:
  struct Layer {
    double m;
    Pair stress;    ///< factors of the layer in z
    Pair velocity;  ///< factors of its slope in w
  };
  double length_;
  Pair constant_;  ///< Z_0
  std::vector<Layer> layers_;
};

}  // namespace porowave::reference::quarter_wave
