#pragma once

#include <string>
#include <vector>

#include "reports/report/case_table.hpp"
#include "verification/order/order_estimate.hpp"

namespace porowave::reports {

/// One level of a group over its seeds; NaN where no case has ended.
struct LevelSummary {
  double spacing = 1.0;
  std::string text;    ///< "200"
  double error = 0.0;  ///< geometric mean of the seeds
  double low = 0.0;    ///< smallest and largest error of the seeds
  double high = 0.0;
  double cpu_seconds = 0.0;        ///< medians
  double ns_per_point_step = 0.0;  ///< of the solver's CPU time
  double points = 0.0;
  std::size_t ended = 0;  ///< cases that give an error
  std::size_t cases = 0;
};

struct GroupSummary {
  std::vector<LevelSummary> levels;  ///< coarse to fine
  verification::OrderEstimate order;
  std::size_t ended = 0;  ///< cases that give an error
  std::size_t cases = 0;

  const LevelSummary& finest() const { return levels.back(); }
  /// Error of the finest level if all of its cases ended, else NaN.
  double finest_error() const;
};

/// Of one measure (an index of verification::measure_names()).
GroupSummary summary_of(const StudyTable& table, const TableGroup& group, std::size_t measure);

/// Of all groups of a table, on all cores.
std::vector<GroupSummary> summaries_of(const StudyTable& table, std::size_t measure);

/// "2.01 ± 0.02", or why there is none: "at floor 3.1e-05".
std::string order_text(const verification::OrderEstimate& order);

/// The L2 errors of the four fields: reconstructed, or at the points in a table that has no others.
std::vector<std::size_t> measures_of(const StudyTable& table);

/// "effective stress, field, L2" for "effective_stress_field_l2".
std::string measure_title(const std::string& measure);

}  // namespace porowave::reports
