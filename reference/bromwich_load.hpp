#pragma once

#include <complex>
#include <vector>

#include "reference/problem/load.hpp"

namespace porowave::reference::line {

/// A piece of a load that is 0 before `start`, and from there on the same formula for ever; the
/// load is the sum of its pieces.
struct LoadPiece {
  enum class Kind {
    powers,   ///< sum of size tau^power/power!, tau from the start on
    sine,     ///< size sin^4(pi tau/duration)
    wavelet,  ///< size times the whole ricker wavelet
  };
  struct Power {
    int power;
    double size;
  };

  Kind kind;
  double start;
  double duration;            ///< of sine and wavelet
  double size;                ///< of sine and wavelet
  std::vector<Power> powers;  ///< of powers

  /// Laplace transform, Re s > 0, tau counted from the start.
  std::complex<double> transform(std::complex<double> s) const;
  /// The piece integrated `times` times from its start to tau; for powers only.
  double integral(int times, double tau) const;
};

std::vector<LoadPiece> load_pieces(const Load& load);

/// Transform of a whole smooth_ramp, without the cancellation of its two pieces; |s| duration at
/// most 25, where a Gauss rule resolves it.
std::complex<double> ramp_transform(const Load& load, std::complex<double> s);

}  // namespace porowave::reference::line
