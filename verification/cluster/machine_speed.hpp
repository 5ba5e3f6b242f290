#pragma once

#include <string>
#include <vector>

#include "verification/cluster/case_list.hpp"
#include "verification/study/study.hpp"

namespace porowave::verification {

/// How much longer cases take than the cost model says, on the machine where they ran.
struct MachineSpeed {
  double factor = 1.0;    ///< measured over predicted CPU time; 1 if nothing was measured
  std::size_t cases = 0;  ///< that it was measured with
  bool stored = false;    ///< rows of the study, else cases run for this alone
};

/// From the rows that stores have of a study's cases, solver's CPU time, if that of those looked at
/// is predicted to be half a second or more: of up to 2,000 cases, the first by id, which is a
/// hash. Sums of both, so that long cases count by their length.
std::optional<MachineSpeed> speed_of_rows(const Study& study, const CaseList& all,
                                          const std::vector<std::string>& stores);

/// From about `seconds` of cases that are run here and forgotten. They are taken at equal steps of
/// summed predicted time, so a case is taken with a probability as its share of all, and the mean
/// of their ratios is that of the whole study (probability proportional to size, Hansen & Hurwitz
/// 1943). Cases longer than `seconds` / 4 are left out; without others, and for another solver's,
/// nothing is run.
MachineSpeed speed_of_trial(const Study& study, const CaseList& cases, double seconds);

/// The indices of `count` of `works`: those in which the sum passes (k + 1/2)/count of all of it.
std::vector<std::size_t> equal_steps(const std::vector<double>& works, std::size_t count);

}  // namespace porowave::verification
