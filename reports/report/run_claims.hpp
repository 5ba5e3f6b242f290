#pragma once

#include <optional>
#include <string>

#include "reports/report/run_sections.hpp"

namespace porowave::reports {

/// The largest error of effective stress in the cells of all frames.
struct LargestError {
  double error = 0.0;  ///< over the load
  double x = 0.0;      ///< m
  double t = 0.0;      ///< s
  /// The nearest way of a wave at that time and how far off it is, in cells; none before any.
  struct Way {
    bool fast;
    double cells;
  };
  std::optional<Way> nearest = {};
};
LargestError largest_error(const RunHistory& history);

/// "bspline2, support_radius 3.0, 400 elements, seed 3": a run among the others of its problem.
std::string method_text(const FinishedRun& run, const StudyReport& study);

/// How it ended: "L2 error of effective stress, field: 0.0012", or that and where it broke down;
/// and if the store has something else.
std::string outcome_text(const FinishedRun& run, const StudyReport& study);

}  // namespace porowave::reports
