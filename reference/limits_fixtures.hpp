#pragma once

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "reference/column_solution.hpp"
#include "reference/field_fixtures.hpp"

/// How fast the exact solution tends to a limit.
namespace porowave::fixtures {

/// Deviation of the exact fields from those of a limit, in units of the load: effective stress,
/// pore pressure, solid velocity, fluid velocity.
inline Four deviation(const Problem& problem, const Fields& limit, double x, double t) {
  const reference::BoundedFields exact = reference::ColumnSolution(problem).at(x, t);
  BOOST_REQUIRE(exact.error.effective_stress < 1e-10 * problem.stress_scale());
  BOOST_REQUIRE(exact.error.fluid_velocity < 1e-10 * problem.velocity_scale());
  const Fields& v = exact.value;
  return {std::abs(v.effective_stress - limit.effective_stress) / problem.stress_scale(),
          std::abs(v.pore_pressure - limit.pore_pressure) / problem.stress_scale(),
          std::abs(v.solid_velocity - limit.solid_velocity) / problem.velocity_scale(),
          std::abs(v.fluid_velocity - limit.fluid_velocity) / problem.velocity_scale()};
}

/// Deviations at falling values of a small parameter, and the orders at which they fall with it.
struct Fall {
  std::vector<double> parameters;
  std::vector<Four> deviations;

  Fall(std::vector<double> values, const std::function<Four(double)>& deviation_at)
      : parameters(std::move(values)) {
    for (const double parameter : parameters) deviations.push_back(deviation_at(parameter));
  }

  double order(std::size_t i, std::size_t f) const {
    return std::log(deviations[i][f] / deviations[i + 1][f]) /
           std::log(parameters[i] / parameters[i + 1]);
  }
  /// Order of the last, smallest pair.
  double order(std::size_t f) const { return order(parameters.size() - 2, f); }
  double smallest(std::size_t f) const { return deviations.back()[f]; }
  /// The orders of the last pair, as text.
  std::string orders() const {
    std::string text;
    for (std::size_t f = 0; f < 4; ++f) text += " " + std::to_string(order(f));
    return text;
  }
};

inline constexpr std::size_t stress = 0;
inline constexpr std::size_t pressure = 1;
inline constexpr std::size_t solid = 2;
inline constexpr std::size_t fluid = 3;

/// A medium sand, in which the two phases move against each other more than in the paper's rock.
inline Material sand() {
  return {0.4, 2650.0, 1000.0, 8.0e8, 2.2e9, 1.0e-11, 1.0e-3};
}

/// The same with the permeability at which relaxation_rate * time has the value wanted.
inline Material with_drag(Material m, double drag, double time) {
  m.intrinsic_permeability *= m.relaxation_rate() * time / drag;
  return m;
}

}  // namespace porowave::fixtures
