#pragma once

#include "reference/modes.hpp"

namespace porowave::reference {

/// A hyperbola open to the left, s(u) = shift + scale (1 - sin(angle - i u)), -inf < u < inf; the
/// Bromwich line is bent to it. Its right end is s(0); far out it runs at `angle` from the
/// vertical. Nodes at equal steps of u crowd towards the right end, so that one rule resolves all
/// scales of s from 1/t to the relaxation rate; nodes are rounded relative to their distance from
/// `shift`. Source: Weideman & Trefethen, Math. Comp. 76 (2007) 1341, eq. (3.1).
struct Hyperbola {
  double shift;  ///< 1/s
  double scale;  ///< 1/s, > 0
  double angle;  ///< between 0 (vertical) and pi/2 (all to the left)

  Complex point(double u) const;
  Complex tangent(double u) const;  ///< ds/du
  double rightmost() const;

  /// How far, as an angle, the hyperbola may be opened (> 0: s lies inside, to the left of it) or
  /// must be closed (< 0) to run through s. Its size is the width of the strip of u in which an
  /// integrand with a singularity at s is analytic, which sets the rate of convergence.
  double clearance(Complex s) const;
};

/// The hyperbola of that angle with its right end at `rightmost` > shift.
Hyperbola hyperbola_through(double shift, double rightmost, double angle);

}  // namespace porowave::reference
