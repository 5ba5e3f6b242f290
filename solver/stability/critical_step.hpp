#pragma once

// The largest stable time step of a scene, and the steps below it that are not stable.

#include <functional>
#include <vector>

#include "solver/stability/growth.hpp"

namespace porowave::solver {

// Growth a step at the time steps of one scene; every search starts from the mode found last.
class SceneGrowth {
 public:
  // Throws as step_operator.
  explicit SceneGrowth(const Case& scene, const GrowthSettings& settings = {});

  double time_step(double courant) const { return courant * crossing_; }  // s
  Growth at(double courant);
  const StepOperator& step() const { return *step_; }

 private:
  std::unique_ptr<const StepOperator> step_;
  GrowthSettings settings_;
  double crossing_;  // of a cell by the fast wave, s
};

struct CriticalSettings {
  double limit = 1e-3;      // growth a step from which on a time step is called unstable, > 0
  double highest = 1.0;     // Courant numbers of the scan, from the highest one a case may have
  double lowest = 0.05;     // down to this one
  double spacing = 0.05;    // by this much
  double tolerance = 2e-3;  // of the critical Courant number, relative
  bool whole_scan = true;   // otherwise it stops at the first stable one
};

struct CriticalStep {
  struct Sample {
    double courant;
    double growth;  // a step
    bool stable;
  };
  // The largest Courant number found stable: below `unstable`, which is not and closer than the
  // tolerance; the highest of the scan if that is stable (`unstable` is 0 then); 0 if none is.
  double courant = 0.0;
  double unstable = 0.0;
  std::vector<Sample> scan;  // descending

  // Samples below the critical one that are unstable: with moving least squares shorter steps can
  // be less stable. Empty without the whole scan.
  std::vector<Sample> unstable_below() const;
};

// Scans from the highest Courant number down and bisects between the first stable sample and the
// one above it. What is stable or unstable only between two samples is not seen. Throws
// std::invalid_argument for settings out of order.
CriticalStep critical_step(const std::function<double(double courant)>& growth_at,
                           const CriticalSettings& settings = {});

}  // namespace porowave::solver
