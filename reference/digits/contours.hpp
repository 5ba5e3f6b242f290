#pragma once

#include <optional>

#include "reference/digits/arrivals.hpp"

namespace porowave::fixtures::digits {

/// A family of contours around the singularities; only the upper half, Im s > 0, is ever used.
///   hyperbola: s = size (1 - sin(v - i u)), u >= 0; open to the left, v from 0 (vertical) to pi/2
///   circle:    s = size + e^(v + i u), 0 <= u <= pi
/// In both, v + i u is a complex variable in which the integrand is analytic, so that the
/// trapezoidal rule in u converges geometrically.
struct Family {
  bool circle = false;
  double size = 0.0;
};

/// What the rule on one contour needs.
struct Contour {
  Family family;
  double v = 0.0;
  double step = 0.0;
  double end = 0.0;     ///< of u
  double height = 0.0;  ///< log of the largest integrand, relative to the load
  int nodes() const { return static_cast<int>(end / step) + 1; }
};

/// Arrivals that are inverted on one contour.
struct Group {
  Contour contour;
  Labels labels = Labels::outer;
  std::vector<Arrival> arrivals;
};

/// Distributes all arrivals over contours that suit them. The variants 0 and 1 choose from
/// different contours. Nothing if some arrival suits none.
std::optional<std::vector<Group>> plan(const Point& point, const std::vector<Arrival>& arrivals,
                                       int variant);

}  // namespace porowave::fixtures::digits
