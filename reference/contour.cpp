#include "reference/contour.hpp"

#include <algorithm>
#include <cmath>

namespace porowave::reference {

Complex Ellipse::point(double angle) const {
  return {centre + real_axis * std::cos(angle), imaginary_axis * std::sin(angle)};
}

Complex Ellipse::tangent(double angle) const {
  return {-real_axis * std::sin(angle), imaginary_axis * std::cos(angle)};
}

Ellipse enclosing_singularities(const WaveModes& modes) {
  const Complex branch = modes.branch_point();
  const double left = std::min(-modes.relaxation_rate(), branch.real());
  const double right = std::max(0.0, branch.real());
  Ellipse ellipse{0.5 * (left + right), 0.5 * (right - left), 0.0};
  // A branch point near the left or right end needs room beyond that end.
  const double offset = std::abs(branch.real() - ellipse.centre);
  constexpr double steepest = 0.7;
  if (branch.imag() > 0.0) ellipse.real_axis = std::max(ellipse.real_axis, offset / steepest);
  const double share = offset / ellipse.real_axis;
  ellipse.imaginary_axis = branch.imag() / std::sqrt(std::max(1e-300, 1.0 - share * share));
  if (branch.imag() == 0.0) ellipse.imaginary_axis = 0.0;
  return ellipse;
}

Ellipse grown(const Ellipse& smallest, double growth) {
  const double outer = 0.5 * (smallest.real_axis + smallest.imaginary_axis) * growth;
  const double inner = 0.5 * (smallest.real_axis - smallest.imaginary_axis) / growth;
  return {smallest.centre, outer + inner, outer - inner};
}

double growth_for_distance(const Ellipse& smallest, double distance) {
  // (a + b) g/2 + (a - b)/(2 g) = a + distance; its larger root, less 1 without cancellation.
  const double a = smallest.real_axis;
  const double b = smallest.imaginary_axis;
  const double end = a + distance;
  const double root = std::sqrt(distance * (2.0 * a + distance) + b * b);
  // g = (end + root)/(a + b)
  return (end + root) / (a + b);
}

}  // namespace porowave::reference
