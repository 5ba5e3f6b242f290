#pragma once

#include <string>
#include <vector>

#include "reports/report/case_table.hpp"

namespace porowave::reports {

/// One group in two stores; of the cases that both have with the same specification.
struct ComparedGroup {
  std::string study;
  std::string group;
  std::size_t cases = 0;  ///< that both have
  double error_ratio =
      1.0;  ///< after/before, geometric mean at the finest common level; NaN if none
  double worst_ratio = 1.0;    ///< of a single case, at any level
  double cost_ratio = 1.0;     ///< of CPU time, median over the cases
  std::size_t now_broken = 0;  ///< cases that ended before and do not now
  std::size_t now_ended = 0;
  std::string verdict;  ///< "better", "worse", "same", "nothing in common"
};

struct Comparison {
  std::string after;                  ///< path of the other store
  std::vector<ComparedGroup> groups;  ///< the worst first
  std::size_t only_before = 0;        ///< cases that only one store has
  std::size_t only_after = 0;
};

/// Errors that change by less are the same.
inline constexpr double compared_tolerance = 0.01;

/// Matches cases by study and specification, not by id: that changes with the program.
Comparison compare(const std::vector<StudyTable>& before,
                   const std::vector<verification::Record>& after, std::size_t measure);

}  // namespace porowave::reports
