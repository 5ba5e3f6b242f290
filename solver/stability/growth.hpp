#pragma once

// How fast states grow that are stepped on and on: the largest modulus of an eigenvalue.
//
// Undamped waves, rigid motion and what the points cannot see all have modulus 1, exactly or to
// rounding, and may grow like a power of the steps. So growth is judged against a limit above 1:
// noise is multiplied by (1 + limit) a step, or tenfold in ln 10/limit steps.

#include <complex>
#include <vector>

#include "solver/stability/step_operator.hpp"

namespace porowave::solver {

struct Growth {
  double per_step = 0.0;  // largest modulus; >= 0
  std::complex<double> eigenvalue;
  // Of unit norm; empty if no eigenvector was asked for, or none was found.
  std::vector<std::complex<double>> mode;
  // Whether per_step is that of an eigenvalue to `tolerance`; otherwise it is how fast the last
  // half of many steps grew, with nothing that stands out.
  bool settled = false;
  long steps = 0;  // applications of the map
};

struct GrowthSettings {
  double limit = 1e-3;  // growth a step that must not be missed, > 0
  bool want_mode = false;
  // States of at most so many numbers are treated as a dense matrix.
  std::size_t largest_dense = 260;
  unsigned seed = 1;  // of the noise to start from
  // A guess of the mode, such as that of another time step; may be empty.
  std::vector<std::complex<double>> guess = {};
};

// The largest growth of a map: dense_growth for small ones, else iterated_growth.
Growth growth(const LinearMap& map, const GrowthSettings& settings = {});

// All eigenvalues of the matrix, by the QR algorithm: exact to rounding (1e-7 where eigenvectors
// coincide, as with rigid motion), 10 size³ operations. Infinite growth, without an eigenvalue, if
// a number of the matrix is not finite.
Growth dense_growth(const LinearMap& map, bool want_mode);

// From noise, as many steps as a mode that grows by `limit` needs to outgrow all others by e^14,
// and on the way Arnoldi's method with powers of the step, which finds whatever grows faster much
// earlier. Ends with a mode that grows by more than the limit (`settled`), or without one.
//
// Of several growing modes it finds the largest to 1e-4, and never calls a map stable in which
// one grows by 1.2 limit a step.
Growth iterated_growth(const LinearMap& map, const GrowthSettings& settings);

}  // namespace porowave::solver
