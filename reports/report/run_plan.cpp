#include "reports/report/run_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/problem/errors.hpp"
#include "reports/report/text_forms.hpp"
#include "verification/cost/cost_model.hpp"
#include "verification/sweep/case_runner.hpp"

namespace porowave::reports {

namespace {

/// Notes on single cases; the rest is counted.
constexpr std::size_t most_notes = 4;

struct Candidate {
  std::size_t study;
  ChosenRun chosen;
};

std::vector<Candidate> candidates_of(const ReportContent& content) {
  std::vector<Candidate> all;
  for (std::size_t s = 0; s < content.studies.size(); ++s) {
    const StudyReport& study = content.studies[s];
    for (const ChosenRun& chosen :
         choose_runs(study.table, study.summaries.front(), study.measure)) {
      all.push_back({s, chosen});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
    return a.chosen.role < b.chosen.role;
  });
  return all;
}

class Planner {
 public:
  explicit Planner(const ReportContent& content) : content_(content) {}

  RunPlan plan() {
    const auto candidates = candidates_of(content_);
    const auto most = static_cast<std::size_t>(std::max(0, content_.options.runs));
    std::size_t beyond = 0;
    for (const Candidate& candidate : candidates) {
      if (plan_.runs.size() < most) {
        consider(candidate);
      } else {
        ++beyond;
      }
    }
    if (dropped_ > 0) {
      plan_.notes.push_back(fmt::format("{} more cases are left out for such reasons.", dropped_));
    }
    if (beyond > 0) {
      plan_.notes.push_back(fmt::format(
          "{} more are beyond --runs {}. All of them: {}", beyond, most,
          report_command(content_.options, fmt::format("--runs {}", candidates.size()))));
    }
    return std::move(plan_);
  }

 private:
  void leave_out(const Candidate& candidate, const std::string& why) {
    const auto& row = content_.studies[candidate.study].table.rows[candidate.chosen.row];
    if (plan_.notes.size() == most_notes) {
      ++dropped_;
      return;
    }
    plan_.notes.push_back(fmt::format("Left out: {}, case {}: {}", name(candidate.chosen.role),
                                      row.id.substr(0, 12), why));
  }

  void consider(const Candidate& candidate) {
    const auto& row = content_.studies[candidate.study].table.rows[candidate.chosen.row];
    const auto& options = content_.options;
    try {
      const TomlDocument document = TomlDocument::parse(row.specification, "its specification");
      if (document.section("adapter").present()) {
        return leave_out(candidate,
                         "run by another program, whose fields no store holds; to run it "
                         "again, sweep its study into a new store");
      }
      const solver::Case scene = solver::read_case(document);
      const double seconds = guessed_seconds(scene, row);
      if (seconds_ + seconds > options.run_seconds) {
        const std::string command = report_command(
            options, fmt::format("--run-seconds {:.0f}", std::ceil(seconds_ + seconds)));
        return leave_out(candidate,
                         fmt::format("it would take about {:.2g} s of CPU, beyond --run-seconds "
                                     "{:g} with those before it. It is drawn by: {}",
                                     seconds, options.run_seconds, command));
      }
      seconds_ += seconds;
      plan_.runs.push_back({candidate.study, candidate.chosen, scene});
    } catch (const std::exception& error) {
      leave_out(candidate, fmt::format("this program cannot run it: {}", error.what()));
    }
  }

  const ReportContent& content_;
  RunPlan plan_;
  double seconds_ = 0.0;
  std::size_t dropped_ = 0;
};

}  // namespace

double guessed_seconds(const solver::Case& scene, const verification::Record& row) {
  // A profile of the reference with its values in the cells; measured 1 to 4 ms where waves are
  // few.
  constexpr double seconds_per_frame = 5e-3;
  const double run = std::isfinite(row.cpu_seconds) ? row.cpu_seconds : 0.0;
  return std::max(run, verification::predicted_seconds(scene)) + frames_of_run * seconds_per_frame;
}

std::string report_command(const ReportOptions& options, const std::string& rest) {
  std::string command = fmt::format("porowave report {} --output {}", shell_word(options.store),
                                    shell_word(options.output));
  if (!options.study.empty()) command += " --study " + shell_word(options.study);
  return command + " " + rest;
}

RunPlan plan_runs(const ReportContent& content) {
  return Planner(content).plan();
}

}  // namespace porowave::reports
