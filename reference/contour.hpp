#pragma once

#include <complex>
#include <functional>
#include <vector>

#include "reference/modes.hpp"

namespace porowave::reference {

/// An ellipse in the s plane, symmetric about the real axis, run anticlockwise.
struct Ellipse {
  double centre;
  double real_axis;       ///< half-axis along Re s
  double imaginary_axis;  ///< half-axis along Im s

  Complex point(double angle) const;
  Complex tangent(double angle) const;  ///< ds/d(angle)
  double rightmost() const { return centre + real_axis; }
};

/// The smallest of the family of confocal ellipses used here: it just encloses the cut
/// [-relaxation_rate, 0] and both branch points.
Ellipse enclosing_singularities(const WaveModes& modes);

/// The confocal ellipse `growth` > 1 times as large in the sense of its conformal map: the
/// trapezoidal rule with N nodes on it converges like growth^-N.
Ellipse grown(const Ellipse& smallest, double growth);

/// The growth that puts the right end of the ellipse at `distance` > 0 right of the smallest one.
double growth_for_distance(const Ellipse& smallest, double distance);

}  // namespace porowave::reference
