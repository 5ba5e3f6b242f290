#pragma once

#include "reference/column_solution.hpp"

namespace porowave::reference {

/// A number with a bound or estimate of its own error (same unit).
struct Bounded {
  double value = 0.0;
  double error = 0.0;
};

/// What is plotted besides the four fields, at one point and time.
struct DerivedFields {
  Bounded total_stress;        ///< sigma' - p, Pa; positive in tension
  Bounded seepage_velocity;    ///< Darcy velocity n_f (v_f - v_s), m/s
  Bounded solid_displacement;  ///< integral of v_s over time, m
  Bounded fluid_displacement;  ///< integral of v_f over time, m
};

/// From the fields at a point and time and their time integrals (ColumnSolution::at and
/// ::time_integral, or two TimeSlices). The bounds are those of the parts added up.
DerivedFields derived_fields(const Material& material, const BoundedFields& fields,
                             const BoundedFields& time_integral);

/// Both evaluated at 0 <= x <= length and time t. Throws as ColumnSolution::at.
DerivedFields derived_fields(const ColumnSolution& solution, double x, double t);

/// Settlement of the loaded end, u_s(0, t) in m; positive into the column.
Bounded settlement(const ColumnSolution& solution, double t);

}  // namespace porowave::reference
