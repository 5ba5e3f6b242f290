#include "reference/contour.hpp"

#include <algorithm>
#include <cmath>

namespace porowave::reference {

Complex Ellipse::point(double angle) const {
  const double sine = std::sin(0.5 * angle);
  return {rightmost - 2.0 * real_axis * sine * sine, imaginary_axis * std::sin(angle)};
}

Complex Ellipse::tangent(double angle) const {
  return {-real_axis * std::sin(angle), imaginary_axis * std::cos(angle)};
}

bool Ellipse::encloses(Complex s) const {
  const double x = (s.real() - rightmost) / real_axis + 1.0;
  const double y = s.imag() == 0.0 ? 0.0 : s.imag() / imaginary_axis;
  return x * x + y * y < 1.0;
}

Ellipse enclosing_singularities(const WaveModes& modes) {
  // The right end decides about rounding, so it lies at the rightmost singularity. The left end has
  // room: e^(s t) is small there, and with room the ellipse can be flat and still pass above the
  // branch points.
  constexpr double room = 1.5;
  const Complex branch = modes.branch_point();
  const double left = room * std::min(-modes.relaxation_rate(), branch.real());
  const double right = room * std::max(0.0, branch.real());
  const double half = 0.5 * (right - left);
  const double offset = (branch.real() - right) / half + 1.0;
  return {right, half, branch.imag() / std::sqrt(1.0 - offset * offset)};
}

GrownEllipse grown(const Ellipse& smallest, double distance) {
  // (a + b) g/2 + (a - b)/(2 g) = a + distance; g is its larger root, g - 1 without cancellation.
  const double a = smallest.real_axis;
  const double b = smallest.imaginary_axis;
  const double beyond = distance * (2.0 * a + distance);
  const double root_less_b = beyond / (std::sqrt(beyond + b * b) + b);
  const double excess = (distance + root_less_b) / (a + b);
  return {{smallest.rightmost + distance, a + distance, b + root_less_b}, std::log1p(excess)};
}

}  // namespace porowave::reference
