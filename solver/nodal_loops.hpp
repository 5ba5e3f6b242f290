#pragma once

// Loops over nodal values of a part of the column.

#include <cstddef>

namespace porowave::solver {

// out = a x + b y
void combine(double a, const double* x, double b, const double* y, std::size_t count, double* out);

// u ← u + dt v; whether any |u| is now above the limit (false for NaN).
bool add_displacement(double dt, const double* v, std::size_t count, double limit, double* u);

}  // namespace porowave::solver
