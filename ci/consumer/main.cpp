// The library's first example: exact fields of a saturated column at one point and time.
#include <cmath>
#include <iostream>

#include "reference/column_solution.hpp"
#include "reference/cross_check.hpp"

int main() {
  porowave::Problem problem;
  problem.material = {.porosity = 0.4,
                      .grain_density = 2650.0,
                      .fluid_density = 1000.0,
                      .constrained_modulus = 5.0e9,
                      .fluid_bulk_modulus = 2.2e9,
                      .intrinsic_permeability = 1.0e-11,
                      .fluid_viscosity = 1.0e-3};
  problem.column = {.length = 0.1,
                    .near = porowave::NearEnd::drained_traction,
                    .far = porowave::FarEnd::rigid_sealed};
  problem.load = porowave::Load(porowave::LoadShape::step, 1.0);  // 1 Pa from t = 0 on

  const porowave::reference::ColumnSolution column(problem);
  const auto [value, error] = column.at(0.05, 4.0e-5);  // x in m, t in s
  std::cout << "effective stress " << value.effective_stress << " Pa, error at most "
            << error.effective_stress << " Pa\n";

  // Behind the fast wave and ahead of the slow one: compressed, by less than the load.
  const bool sane = std::isfinite(value.effective_stress) && value.effective_stress > -1.0 &&
                    value.effective_stress < 0.0 && error.effective_stress < 1.0e-12;
  if (!sane) std::cerr << "expected a value between -1 and 0 and an error below 1e-12\n";

  // Independent routes to the same values; a smooth load suits all of them.
  problem.load = porowave::Load(porowave::LoadShape::smooth_ramp, 1.0, 1.0e-5);
  const auto check = porowave::reference::compare_routes(problem, {0.05}, {4.0e-5});
  for (const auto& route : check.routes) {
    std::cout << route.route << " differs by " << route.worst.difference << " of the load\n";
  }
  const bool agree = check.agree() && check.compared() == 8;
  if (!agree) std::cerr << "expected both routes to agree in all four fields\n";
  return sane && agree ? 0 : 1;
}
