#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "reference/problem/problem.hpp"

/// What tests of the reference do with the four fields at a point.
namespace porowave::fixtures {

/// Effective stress, pore pressure, solid velocity, fluid velocity.
using Four = std::array<double, 4>;

inline Four as_array(const Fields& f) {
  return {f.effective_stress, f.pore_pressure, f.solid_velocity, f.fluid_velocity};
}

/// The fields in units of the load.
inline Four shares(const Problem& problem, const Fields& f) {
  const double stress = problem.stress_scale();
  const double velocity = problem.velocity_scale();
  return {f.effective_stress / stress, f.pore_pressure / stress, f.solid_velocity / velocity,
          f.fluid_velocity / velocity};
}

/// Largest of the four differences in units of the load; infinite if one is not a number.
inline double distance(const Problem& problem, const Fields& a, const Fields& b) {
  const Four p = shares(problem, a);
  const Four q = shares(problem, b);
  double worst = 0.0;
  for (std::size_t f = 0; f < 4; ++f) {
    const double size = std::abs(p[f] - q[f]);
    if (std::isnan(size)) return std::numeric_limits<double>::infinity();
    worst = std::max(worst, size);
  }
  return worst;
}

/// Largest of the four fields in units of the load.
inline double largest_share(const Problem& problem, const Fields& f) {
  return distance(problem, f, Fields());
}

/// Difference quotient of fourth order of fields_at around 0, field by field.
template <class Function>
Four derivative(Function&& fields_at, double step) {
  const Four a = as_array(fields_at(-2 * step));
  const Four b = as_array(fields_at(-step));
  const Four c = as_array(fields_at(step));
  const Four d = as_array(fields_at(2 * step));
  Four result;
  for (std::size_t f = 0; f < 4; ++f) {
    result[f] = (a[f] - 8 * b[f] + 8 * c[f] - d[f]) / (12 * step);
  }
  return result;
}

/// The largest of something, and where it is. What is not a number counts as the largest.
struct Worst {
  double size = 0.0;
  std::string where = "none";
  void see(double value, const std::string& place) {
    if (value <= size) return;
    size = value;
    where = place;
  }
};

}  // namespace porowave::fixtures
