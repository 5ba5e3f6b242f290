#pragma once

#include <array>
#include <complex>
#include <optional>
#include <vector>

#include "solver/case.hpp"

namespace porowave::verification {

/// Rates λ of e^(i k x + λ t), 1/s: the imaginary part is the frequency, minus the real one the
/// damping. Four of a wave number: two waves, either way, or what they become under strong drag.
using Rates = std::array<std::complex<double>, 4>;

/// Of the equations of motion and both laws themselves, with drag (Verruijt 2010, waves in
/// saturated soil), for wave number k > 0, 1/m.
Rates exact_rates(const Material& material, double wave_number);

/// Of a scheme in an endless grid of uniform points: one step takes e^(i k x) to a 4 × 4 matrix
/// times e^(i k x), for whatever it does far from the ends is the same at every node.
///
/// The matrix comes from the step operator itself (solver/stability/step_operator.hpp): what one
/// step makes of a single value amid a column of 64 cells, of either phase's velocity and of either
/// stress, and the Fourier series of that.
class SchemeDispersion {
 public:
  /// The transfer, kernel, support and points of a case with its material and its time step
  /// `courant` h/c_1 (> 0); its column, end and load have no part in it. Throws
  /// std::invalid_argument for points that are not uniform, empty elements and time_order = 4
  /// (which carries more than velocities and stresses).
  SchemeDispersion(const solver::Case& scene, double courant);

  /// For 0 < wave number < π/h.
  Rates rates(double wave_number) const;
  double spacing() const { return spacing_; }      // h, m
  double time_step() const { return time_step_; }  // s

 private:
  struct Response {
    double distance;  ///< m, from where the value stood
    double value;
  };
  Material material_;
  double spacing_;
  double time_step_;
  /// [of][from]: v_s, v_f, σ′, p
  std::array<std::array<std::vector<Response>, 4>, 4> responses_;
};

/// The waves among four rates that run to smaller x (positive frequency): first the fast one. The
/// slow one does not exist where drag lets it only diffuse.
struct TravellingWaves {
  std::complex<double> fast;
  std::optional<std::complex<double>> slow;
};
TravellingWaves travelling(const Rates& rates);

}  // namespace porowave::verification
