#pragma once

#include <array>
#include <vector>

#include "reference/modes.hpp"
#include "verification/wave_measures/grid_fields.hpp"

namespace porowave::verification {

/// Splits the fields into the four waves of the column: fast (mode 0) and slow (1), upwards (to
/// larger x) and downwards.
///
/// With the frozen modes R of reference/modes.hpp (R^T A R = 1, R^T D R = diag(1/c_k^2)) let
///   y_k = c_k^2 r_k^T D v        velocities of mode k
///   z_k = -r_k^T tau             tau = (sigma' - n_s p, -n_f p): partial tractions
/// Without drag both obey y_t = -c^2 z_x, z_t = -y_x, so (y_k/c_k + z_k)/2 runs upwards and
/// (y_k/c_k - z_k)/2 downwards with c_k, neither knowing of the other three. Their squares add up
/// to the energy: 1/2 (y^2/c^2 + z^2) = up^2 + down^2, so all amplitudes have one unit,
/// sqrt(J/m^3). Drag makes the four exchange a little; it does so in solver and reference alike.
class ModeAmplitudes {
 public:
  explicit ModeAmplitudes(const Material& material);

  struct Pair {
    double up;
    double down;
  };
  Pair at(int mode, const Fields& fields) const;

  struct Profiles {
    std::vector<double> up;
    std::vector<double> down;
  };
  /// At the middles of cells, with the mean of the velocities at their two nodes.
  Profiles of(int mode, const GridFields& fields) const;

  double speed(int mode) const { return speed_[static_cast<std::size_t>(mode)]; }

 private:
  struct Weights {  ///< of half of y/c and half of z
    double solid_velocity;
    double fluid_velocity;
    double effective_stress;
    double pore_pressure;
  };
  std::array<double, 2> speed_;
  std::array<Weights, 2> weights_;
};

}  // namespace porowave::verification
