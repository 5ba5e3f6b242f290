#pragma once

#include <string>
#include <vector>

#include "reports/report/chosen_runs.hpp"
#include "reports/report/report_content.hpp"
#include "solver/case.hpp"

namespace porowave::reports {

/// Times at which a run is looked at.
inline constexpr int frames_of_run = 64;

struct PlannedRun {
  std::size_t study;
  ChosenRun chosen;
  solver::Case scene;
};

struct RunPlan {
  std::vector<PlannedRun> runs;    ///< in the order of choose_runs, study by study in a role
  std::vector<std::string> notes;  ///< what is left out, why, and the command that draws it
};

/// Which of the chosen cases of all studies are run: at most options.runs of them, and as many as
/// options.run_seconds of CPU allow by a guess that knows the case and its row only, so that a
/// store always gives the same report. Cases of other programs and those that this one cannot read
/// are left out.
RunPlan plan_runs(const ReportContent& content);

/// The guess: CPU time of a run and of the reference at frames_of_run times, s.
double guessed_seconds(const solver::Case& scene, const verification::Record& row);

/// "porowave report results --output report REST".
std::string report_command(const ReportOptions& options, const std::string& rest);

}  // namespace porowave::reports
