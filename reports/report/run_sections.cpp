#include "reports/report/run_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/figures.hpp"
#include "reports/history_figures.hpp"
#include "reports/progress.hpp"
#include "reports/report/figure_parts.hpp"
#include "reports/report/run_claims.hpp"
#include "reports/report/text_forms.hpp"
#include "reports/wave_figures.hpp"
#include "verification/field_errors.hpp"
#include "verification/not_a_number.hpp"
#include "verification/parallel.hpp"
#include "verification/run.hpp"

namespace porowave::reports {

namespace {

/// Characters of a title that a picture's width holds.
constexpr std::size_t row_width = 120;
constexpr std::size_t panel_width = 68;
constexpr std::size_t caption_width = 90;
/// Points of a phase; a panel is not wider in pixels than half of them.
constexpr std::size_t most_points = 600;
/// Marks that a profile holds; after many reflections there are more.
constexpr std::size_t most_fronts = 8;

using Runs = std::vector<const FinishedRun*>;

/// The error of the last frame in a measure that is a norm of a field.
double error_of(const RunHistory& history, std::size_t measure) {
  constexpr std::size_t norms = 3;
  if (history.breakdown || measure >= 2 * norms * verification::field_names.size()) {
    return verification::nan;
  }
  const solver::Snapshot& end = history.frames.back().snapshot;
  const auto profile = verification::reference_profile(
      history.scene.problem, end.time, solver::ColumnSolver::grid_length(history.scene));
  const auto errors =
      verification::field_errors(end, verification::reference_values(end, *profile));
  const verification::FieldError& field = errors[measure / (2 * norms)];
  const verification::Norms& where = measure / norms % 2 == 0 ? field.points : field.field;
  return std::array{where.l1, where.l2, where.linf}[measure % norms];
}

FinishedRun finished(const PlannedRun& plan, std::size_t measure) {
  FinishedRun run{plan, {plan.scene, {}}, verification::nan, ""};
  try {
    run.history = watched_run(plan.scene, frames_of_run);
    run.error = error_of(run.history, measure);
  } catch (const std::exception& error) {
    run.history.frames.clear();
    run.failure = error.what();
  }
  return run;
}

/// "best method, finest level: bspline2, 400 elements".
std::string title_of(const FinishedRun& run, const StudyReport& study) {
  return fmt::format("{}: {}", name(run.plan.chosen.role), method_text(run, study));
}

std::string time_text(const FinishedRun& run) {
  return fmt::format("t = {:.4g} µs", 1e6 * run.history.frames.back().snapshot.time);
}

Figure for_report(Figure figure) {
  figure.as_pdf = true;
  return figure;
}

ReportFigure profiles(const Runs& runs, const StudyReport& study, const std::string& name,
                      const std::string& problem) {
  std::vector<ProfileRow> rows;
  std::string claim =
      "Profiles at the material points over the reference, each at the end of its run; dashed: how "
      "far the beginning of the load has got with the fast wave (P1) and with the slow one (P2)";
  std::string separator = ". From the top: ";
  for (const FinishedRun* run : runs) {
    const auto& end = run->history.frames.back().snapshot;
    auto fronts = fronts_at(run->plan.scene.problem, end.time);
    if (fronts.size() > most_fronts) fronts.clear();
    const std::string title = title_of(*run, study);
    rows.push_back({shortened(fmt::format("{}, {}", title, time_text(*run)), row_width),
                    run->plan.scene, end, fronts, most_points});
    claim +=
        separator + fmt::format("{}, {}: {}", title, time_text(*run), outcome_text(*run, study));
    separator = "; ";
  }
  claim += ".";
  const std::string caption = shortened("Profiles" + problem, caption_width);
  return {for_report(profile_figure(name, caption, rows)), "", claim,
          "Effective stress and pore pressure against x, points over curves. " + claim};
}

SpectrumPanel panel_of(const FinishedRun& run, const std::string& method) {
  const auto& frame = run.history.frames.back();
  const double load = run.plan.scene.problem.stress_scale();
  SpectrumPanel panel{std::string(name(run.plan.chosen.role)), {}, {}, method};
  for (std::size_t c = 0; c < frame.reference.size(); ++c) {
    const double exact = frame.reference[c].effective_stress;
    panel.reference.push_back(exact / load);
    panel.error.push_back((frame.snapshot.effective_stress[c] - exact) / load);
  }
  return panel;
}

ReportFigure spectra(const Runs& runs, const StudyReport& study, const std::string& name,
                     const std::string& problem) {
  std::vector<SpectrumPanel> panels;
  std::string claim =
      "In which waves the error of effective stress stands. Half of its square is in waves of at "
      "least";
  std::string separator = ": ";
  for (const FinishedRun* run : runs) {
    const std::string role(reports::name(run->plan.chosen.role));
    const std::string method = method_text(*run, study);
    panels.push_back(panel_of(*run, shortened(method, panel_width)));
    const double cells = median_wavelength(panels.back());
    claim += separator + fmt::format("{} ({}): {}", role, method,
                                     std::isfinite(cells) ? fmt::format("{:.3g} cells", cells)
                                     : std::isinf(cells)  ? std::string("none, it is the mean")
                                                          : std::string("no error"));
    separator = "; ";
  }
  claim += ". Grey: shorter than four cells, which no grid resolves.";
  const std::string caption = shortened("Spectrum of the error" + problem, caption_width);
  return {for_report(error_spectrum_figure(name, caption, std::span<const SpectrumPanel>(panels))),
          "", claim,
          "Amplitudes of the effective stress and of its error over cells in a wavelength, on "
          "logarithmic axes. " +
              claim};
}

ReportFigure space_time(const FinishedRun& run, const StudyReport& study, const std::string& name) {
  const std::string title = title_of(run, study);
  const LargestError largest = largest_error(run.history);
  std::string claim = fmt::format(
      "{}: {}. Largest error of effective stress: {:.2g} of the load at "
      "x = {:.3g} m, t = {:.3g} µs",
      title, outcome_text(run, study), largest.error, largest.x, 1e6 * largest.t);
  if (largest.nearest) {
    claim += fmt::format(", {:.1f} cells from the way of the {} wave", largest.nearest->cells,
                         largest.nearest->fast ? "fast" : "slow");
  }
  claim += ".";
  return {for_report(space_time_figure(name, shortened(title, caption_width), run.history)), "",
          claim,
          "Effective stress and pore pressure as colours over x and t, below them their errors, "
          "crossed by the ways of both waves. " +
              claim};
}

RunSection section_of(const Runs& all, const StudyReport& study, const std::string& name,
                      const std::string& problem) {
  RunSection section;
  section.heading = problem.empty() ? "Runs" : "Runs: " + problem;
  Runs shown;
  for (const FinishedRun* run : all) {
    if (!run->history.frames.empty()) {
      shown.push_back(run);
    } else {
      section.notes.push_back(
          fmt::format("{}: {}", title_of(*run, study), outcome_text(*run, study)));
    }
  }
  if (shown.empty()) return section;
  const std::string where = problem.empty() ? "" : ": " + problem;
  section.figures.push_back(profiles(shown, study, name + "profiles", where));
  section.figures.push_back(spectra(shown, study, name + "spectra", where));
  std::size_t number = 0;
  for (const FinishedRun* run : shown) {
    ++number;
    if (run->history.frames.size() < 2) continue;
    section.figures.push_back(
        space_time(*run, study, fmt::format("{}space_time_{}", name, number)));
  }
  return section;
}

}  // namespace

std::vector<FinishedRun> finished_runs(const RunPlan& plan, const ReportContent& content) {
  std::vector<FinishedRun> runs(plan.runs.size());
  verification::parallel_for(runs.size(), [&](std::size_t i) {
    runs[i] = finished(plan.runs[i], content.studies[plan.runs[i].study].measure);
  });
  return runs;
}

std::vector<RunSection> run_sections(const std::vector<FinishedRun>& runs,
                                     const ReportContent& content, std::size_t study) {
  const StudyReport& report = content.studies[study];
  const auto axes = problem_axes(report.table);
  const auto problems = parts_of(report.table, axes);
  std::vector<RunSection> sections;
  for (std::size_t p = 0; p < problems.size(); ++p) {
    Runs here;
    for (const FinishedRun& run : runs) {
      if (run.plan.study == study && run.plan.chosen.problem == p) here.push_back(&run);
    }
    if (here.empty()) continue;
    sections.push_back(section_of(here, report, fmt::format("{}run_{}_", report.prefix, p + 1),
                                  described(report.table, axes, problems[p].at)));
  }
  return sections;
}

void add_runs(ReportContent& content) {
  const RunPlan plan = plan_runs(content);
  const auto runs = finished_runs(plan, content);
  for (std::size_t s = 0; s < content.studies.size(); ++s) {
    content.studies[s].runs = run_sections(runs, content, s);
  }
  content.run_notes = plan.notes;
}

std::string rule_of_runs(const ReportOptions& options) {
  return fmt::format(
      "A store holds no fields, so some cases were run again for this page. Of each problem: the "
      "groups with the smallest and with the largest error at the finest level, there and at the "
      "middle level, of the seeds the one with the median error; and a case that broke down. At "
      "most {} cases (--runs) and {:g} s of CPU (--run-seconds) in all.",
      options.runs, options.run_seconds);
}

}  // namespace porowave::reports
