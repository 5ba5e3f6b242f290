#include "reference/contour.hpp"

#include <cmath>

namespace porowave::reference {

Complex Hyperbola::point(double u) const {
  return {shift + scale * (1.0 - std::sin(angle) * std::cosh(u)),
          scale * std::cos(angle) * std::sinh(u)};
}

Complex Hyperbola::tangent(double u) const {
  return {-scale * std::sin(angle) * std::sinh(u), scale * std::cos(angle) * std::cosh(u)};
}

double Hyperbola::rightmost() const {
  return shift + scale * (1.0 - std::sin(angle));
}

double Hyperbola::clearance(Complex s) const {
  return std::asin(1.0 - (s - shift) / scale).real() - angle;
}

Hyperbola hyperbola_through(double shift, double rightmost, double angle) {
  return {shift, (rightmost - shift) / (1.0 - std::sin(angle)), angle};
}

}  // namespace porowave::reference
