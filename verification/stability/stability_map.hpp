#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "solver/stability/critical_step.hpp"
#include "verification/study/study.hpp"

namespace porowave::verification {

/// The critical step of one case of a study.
struct MappedStability {
  solver::CriticalStep critical;
  double crossing = 0.0;  ///< h/c_1, s: Courant numbers times it are time steps
  std::string refused;    ///< why the case cannot be run; then nothing else is known
};

/// Critical steps of all cases of a study, in their order; `jobs` threads (0: one a core).
/// `progress` (may be empty) is called with the number of cases done, from any thread but by one at
/// a time. Times and errors of the cases have no part in it.
std::vector<MappedStability> stability_map(const Study& study,
                                           const solver::CriticalSettings& settings, int jobs = 0,
                                           const std::function<void(std::size_t)>& progress = {});

/// One row a case: the study's axes, then critical_courant (0: unstable at every sample),
/// unstable_courant (empty if the highest sample is stable), critical_time_step, unstable_below
/// (samples below the critical one that are unstable), growth_below (the largest of these less 1,
/// 0 if none), refused (the reason, in quotes; then the rest is empty).
void write_map_csv(const Study& study, const std::vector<MappedStability>& map, std::ostream& out);

/// A text as one field of a CSV line: in quotes where it must be.
std::string in_csv(const std::string& text);

/// The value of an axis for people and tables: words without their quotes.
std::string plain_text(const TomlValue& value);

}  // namespace porowave::verification
