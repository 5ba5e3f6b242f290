#include "solver/nodal_loops.hpp"

#include <cmath>

#include "solver/simd.hpp"

namespace porowave::solver {

POROWAVE_VECTORISED void combine(double a, const double* __restrict x, double b,
                                 const double* __restrict y, std::size_t count,
                                 double* __restrict out) {
  for (std::size_t i = 0; i < count; ++i) out[i] = a * x[i] + b * y[i];
}

POROWAVE_VECTORISED bool add_displacement(double dt, const double* __restrict v, std::size_t count,
                                          double limit, double* __restrict u) {
  long above = 0;  // as wide as a double: then the comparison vectorises
  for (std::size_t i = 0; i < count; ++i) {
    u[i] += dt * v[i];
    above |= std::abs(u[i]) > limit ? 1L : 0L;
  }
  return above != 0;
}

}  // namespace porowave::solver
