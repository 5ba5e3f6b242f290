#include "reports/report/run_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/report/figure_parts.hpp"
#include "reports/report/result_table.hpp"

namespace porowave::reports {

namespace {

/// Runs of one build are the same to the last digit, of others nearly.
constexpr double same_error = 1e-6;

std::optional<double> place_of(const Characteristic& way, double t) {
  if (t < way.t_begin || t > way.t_end || way.t_end <= way.t_begin) return std::nullopt;
  return way.x_begin + (t - way.t_begin) / (way.t_end - way.t_begin) * (way.x_end - way.x_begin);
}

std::string end_text(const RunHistory& history) {
  if (history.frames.empty()) return "nothing to show before that";
  return fmt::format("shown at t = {:.4g} µs, before that",
                     1e6 * history.frames.back().snapshot.time);
}

}  // namespace

LargestError largest_error(const RunHistory& history) {
  LargestError found;
  const double load = history.scene.problem.stress_scale();
  for (const auto& frame : history.frames) {
    for (std::size_t c = 0; c < frame.reference.size(); ++c) {
      const double error =
          std::abs(frame.snapshot.effective_stress[c] - frame.reference[c].effective_stress) / load;
      if (error <= found.error) continue;
      found = {error, frame.snapshot.cell_x[c], frame.snapshot.time};
    }
  }
  const double h =
      solver::ColumnSolver::grid_length(history.scene) / history.scene.discretization.elements;
  for (const Characteristic& way : characteristics(history.scene.problem, found.t)) {
    const auto x = place_of(way, found.t);
    if (!x) continue;
    const double cells = std::abs(*x - found.x) / h;
    if (!found.nearest || cells < found.nearest->cells) found.nearest = {way.fast, cells};
  }
  return found;
}

std::string method_text(const FinishedRun& run, const StudyReport& study) {
  const StudyTable& table = study.table;
  const auto& levels = table.groups[run.plan.chosen.group].levels;
  const auto level = std::find_if(levels.begin(), levels.end(), [&](const TableLevel& l) {
    return std::find(l.rows.begin(), l.rows.end(), run.plan.chosen.row) != l.rows.end();
  });
  std::string text =
      method_name(table, run.plan.chosen.group, static_cast<std::size_t>(level - levels.begin()));
  const std::string& seed = table.seeds[run.plan.chosen.row];
  if (!seed.empty()) text += fmt::format("{}seed {}", text.empty() ? "" : ", ", seed);
  return text.empty() ? "the only one" : text;
}

std::string outcome_text(const FinishedRun& run, const StudyReport& study) {
  const verification::Record& row = study.table.rows[run.plan.chosen.row];
  const bool broke = row.status == verification::CaseStatus::broke_down;
  if (!run.failure.empty()) return "cannot be run: " + run.failure;
  if (run.history.breakdown) {
    return fmt::format("breaks down{}: {} ({})", broke ? "" : " here, while it ended in the store",
                       run.history.breakdown->reason, end_text(run.history));
  }
  if (broke) return fmt::format("ends here, while it broke down in the store: {}", row.reason);
  const double stored = row.measures[study.measure];
  const std::string measure = measure_title(verification::measure_names()[study.measure]);
  if (std::isnan(run.error) || std::abs(run.error - stored) <= same_error * stored) {
    return fmt::format("{}: relative error {}", measure, error_text(stored));
  }
  return fmt::format("{}: relative error {} here, {} in the store, which another build has filled",
                     measure, error_text(run.error), error_text(stored));
}

}  // namespace porowave::reports
