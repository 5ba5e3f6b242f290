#include "reference/cross_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace porowave::reference {

namespace {

constexpr double comparison_rounding = 1e-12;
constexpr double least_accuracy = 1e-6;
constexpr std::array<std::string_view, 4> field_names = {"effective_stress", "pore_pressure",
                                                         "solid_velocity", "fluid_velocity"};

std::array<double, 4> as_array(const Fields& f) {
  return {f.effective_stress, f.pore_pressure, f.solid_velocity, f.fluid_velocity};
}

void compare(const Problem& problem, double x, double t, const BoundedFields& main,
             const BoundedFields& other, RouteCheck& check) {
  const auto main_value = as_array(main.value);
  const auto main_error = as_array(main.error);
  const auto other_value = as_array(other.value);
  const auto other_error = as_array(other.error);
  for (std::size_t f = 0; f < 4; ++f) {
    const double unit = f < 2 ? problem.stress_scale() : problem.velocity_scale();
    const double errors = (main_error[f] + other_error[f]) / unit;
    if (!(errors < least_accuracy)) {
      ++check.too_inaccurate;
      continue;
    }
    ++check.compared;
    const Disagreement here{std::abs(main_value[f] - other_value[f]) / unit,
                            errors + comparison_rounding,
                            field_names[f],
                            x,
                            t,
                            main_value[f],
                            other_value[f]};
    // Negated, so that NaN with a small error is a disagreement.
    const bool disagrees = !(here.difference <= here.allowed);
    const auto excess = [](const Disagreement& d) { return d.difference - d.allowed; };
    const bool worse = disagrees ? check.agrees || !(excess(here) <= excess(check.worst))
                                 : check.agrees && here.difference >= check.worst.difference;
    if (worse) check.worst = here;
    if (disagrees) check.agrees = false;
  }
}

}  // namespace

bool CrossCheck::agree() const {
  return std::all_of(routes.begin(), routes.end(), [](const auto& r) { return r.agrees; });
}

std::size_t CrossCheck::compared() const {
  std::size_t sum = 0;
  for (const RouteCheck& check : routes) sum += check.compared;
  return sum;
}

CrossCheck compare_routes(const Problem& problem, const Route& main, std::span<const Route> others,
                          const std::vector<double>& x, const std::vector<double>& t) {
  CrossCheck result;
  for (const Route& other : others) {
    RouteCheck check;
    check.route = other.name;
    check.obstacle = other.obstacle;
    result.routes.push_back(check);
  }
  for (const double time : t) {
    const auto expected = main.fields(x, time);
    for (std::size_t r = 0; r < others.size(); ++r) {
      if (!others[r].obstacle.empty()) continue;
      const auto found = others[r].fields(x, time);
      for (std::size_t i = 0; i < x.size(); ++i) {
        compare(problem, x[i], time, expected[i], found[i], result.routes[r]);
      }
    }
  }
  return result;
}

CrossCheck compare_routes(const Problem& problem, const std::vector<double>& x,
                          const std::vector<double>& t) {
  const std::array<Route, 2> others = {route(Method::bromwich, problem),
                                       route(Method::modal, problem)};
  return compare_routes(problem, route(Method::contour, problem), others, x, t);
}

}  // namespace porowave::reference
