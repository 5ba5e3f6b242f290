#pragma once

// What becomes of noise in a whole run, by the eigenvalues of its step.

#include "solver/stability/critical_step.hpp"

namespace porowave::solver {

struct FastestMode {
  double per_step;  // factor
  double x;         // where its energy density is largest, m
};

class RunGrowth {
 public:
  // A run of the case up to `end`, s. All eigenvalues are computed: for up to some 50 elements.
  // Throws as step_operator.
  RunGrowth(const Case& scene, double end);

  double end() const { return end_; }
  double steps(double courant) const;
  // The factor of noise in the run at a Courant number; 1 for growth within the rounding of
  // eigenvalues that coincide (1e-6 a step).
  double at(double courant);
  FastestMode fastest(double courant) const;

 private:
  Case scene_;
  double end_;
  SceneGrowth growth_;
};

// From courant 1 down by tenths to the first stable step: noise grows less than tenfold in the run.
CriticalSettings run_scan();

}  // namespace porowave::solver
