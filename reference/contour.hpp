#pragma once

#include <complex>
#include <functional>
#include <vector>

#include "reference/modes.hpp"

namespace porowave::reference {

/// An ellipse in the s plane, symmetric about the real axis, run anticlockwise. Its right end is
/// kept instead of its centre: the integrand lives near that end, often at distances from 0 that
/// are tiny compared with the ellipse, and its nodes must not be rounded to the size of the latter.
struct Ellipse {
  double rightmost;
  double real_axis;       ///< half-axis along Re s
  double imaginary_axis;  ///< half-axis along Im s

  Complex point(double angle) const;
  Complex tangent(double angle) const;  ///< ds/d(angle)
  bool encloses(Complex s) const;
};

/// The smallest of the family of confocal ellipses used here: it just encloses the cut
/// [-relaxation_rate, 0] and both branch points.
Ellipse enclosing_singularities(const WaveModes& modes);

/// The confocal ellipse whose right end lies `distance` > 0 right of that of the smallest one.
struct GrownEllipse {
  Ellipse ellipse;
  /// log of the growth g of the conformal radius: the trapezoidal rule with N nodes converges like
  /// g^-N.
  double log_growth;
};
GrownEllipse grown(const Ellipse& smallest, double distance);

}  // namespace porowave::reference
