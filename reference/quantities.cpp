#include "reference/quantities.hpp"

namespace porowave::reference {

DerivedFields derived_fields(const Material& material, const BoundedFields& fields,
                             const BoundedFields& time_integral) {
  const double nf = material.porosity;
  const Fields& f = fields.value;
  const Fields& e = fields.error;
  return {{f.effective_stress - f.pore_pressure, e.effective_stress + e.pore_pressure},
          {nf * (f.fluid_velocity - f.solid_velocity), nf * (e.fluid_velocity + e.solid_velocity)},
          {time_integral.value.solid_velocity, time_integral.error.solid_velocity},
          {time_integral.value.fluid_velocity, time_integral.error.fluid_velocity}};
}

DerivedFields derived_fields(const ColumnSolution& solution, double x, double t) {
  return derived_fields(solution.problem().material, solution.at(x, t),
                        solution.time_integral(x, t));
}

Bounded settlement(const ColumnSolution& solution, double t) {
  const BoundedFields integral = solution.time_integral(0.0, t);
  return {integral.value.solid_velocity, integral.error.solid_velocity};
}

}  // namespace porowave::reference
