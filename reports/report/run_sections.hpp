#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/report/run_plan.hpp"
#include "reports/run_history.hpp"

namespace porowave::reports {

/// A run of the plan with its fields over time, or why there are none.
struct FinishedRun {
  PlannedRun plan;
  RunHistory history;
  double error = 0.0;   ///< in the study's measure, if that is a norm of a field; else NaN
  std::string failure;  ///< of the reference or the program; then there is no history
};

/// Runs the plan on all cores. What goes wrong in a run is told by it and not thrown.
std::vector<FinishedRun> finished_runs(const RunPlan& plan, const ReportContent& content);

/// The figures of a study's runs, a section each problem: profiles at the end of all of them under
/// each other, their error's spectra, and each over space and time. `study` is an index of
/// content.studies; file names begin with `prefix`.
std::vector<RunSection> run_sections(const std::vector<FinishedRun>& runs,
                                     const ReportContent& content, std::size_t study);

/// Plans, runs, and puts sections and notes into the content.
void add_runs(ReportContent& content);

/// By which rule the cases were chosen, in words.
std::string rule_of_runs(const ReportOptions& options);

}  // namespace porowave::reports
