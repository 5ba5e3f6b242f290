#include "reports/report/report_content.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "reference/problem/errors.hpp"
#include "verification/gate/floor_cause.hpp"
#include "verification/gate/gate.hpp"
#include "verification/store/store.hpp"

namespace porowave::reports {

namespace {

using verification::Record;
using verification::Store;

std::vector<verification::Provenance> provenance_of(const std::string& path) {
  verification::Database database(path, verification::Database::Mode::read);
  auto rows = database.prepare(
      "SELECT id, version, git, numerics, compiler, flags, cpu, host FROM provenance ORDER BY id");
  std::vector<verification::Provenance> all;
  while (rows.step()) {
    all.push_back({rows.text(0), rows.text(1), rows.text(2), rows.text(3), rows.text(4),
                   rows.text(5), rows.text(6), rows.text(7)});
  }
  return all;
}

/// The measure asked for, checked.
std::optional<std::size_t> chosen_measure(const std::string& name) {
  if (name.empty()) return std::nullopt;
  if (const auto index = verification::measure_index(name)) return index;
  throw InputError(fmt::format("--measure {}: expected one of {}", name,
                               fmt::join(verification::measure_names(), ", ")));
}

std::string slug(const std::string& name) {
  std::string text;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) text += c;
  }
  return text.substr(0, 20);
}

StudyReport study_report(StudyTable table, std::optional<std::size_t> chosen,
                         const std::string& prefix) {
  StudyReport report;
  report.table = std::move(table);
  report.measures = measures_of(report.table);
  if (chosen) {
    std::erase(report.measures, *chosen);
    report.measures.insert(report.measures.begin(), *chosen);
  }
  report.measure = report.measures.front();
  for (const Record& row : report.table.rows) {
    ++report.by_status[static_cast<std::size_t>(row.status)];
  }
  for (const std::size_t measure : report.measures) {
    report.summaries.push_back(summaries_of(report.table, measure));
  }
  report.prefix = prefix;
  report.figures = figures_of({report.table, report.summaries.front(), report.measure, prefix});
  return report;
}

/// Explains floors as the gate does, by running cases of the finest level again with other choices,
/// as long as the guessed CPU time lasts.
class FloorExplainer {
 public:
  FloorExplainer(const ReportOptions& options, const verification::Study& study)
      : options_(options), study_(study), runner_(study.name, "", study.adapter) {}

  std::string operator()(const verification::Group& group, std::size_t measure) {
    const double seconds = guessed_seconds(group);
    if (spent_ + seconds > options_.floor_seconds) {
      return fmt::format(
          "the cause of which porowave gate {} --store {} names (beyond "
          "--floor-seconds {:g})",
          options_.study, options_.store, options_.floor_seconds);
    }
    spent_ += seconds;
    return verification::cause_of_floor(study_, group, measure, runner_);
  }

 private:
  /// Twice the steps, twice the points, twice both steps and elements: eight times the cases' own.
  static double guessed_seconds(const verification::Group& group) {
    constexpr double work = 8.0;
    constexpr std::size_t most_seeds = 4;
    double seconds = 0.0;
    const auto& finest = group.records.back();
    for (std::size_t k = 0; k < std::min(most_seeds, finest.size()); ++k) {
      if (std::isfinite(finest[k].cpu_seconds)) seconds += work * finest[k].cpu_seconds;
    }
    return seconds;
  }

  const ReportOptions& options_;
  const verification::Study& study_;
  verification::CaseRunner runner_;
  double spent_ = 0.0;
};

/// What the study file says of the store, as `porowave gate` does.
void judge_study(const ReportOptions& options, const TomlDocument& document,
                 const verification::Study& study, ReportContent& content) {
  const auto rules = verification::read_gate_rules(document, study);
  std::optional<verification::Baseline> baseline;
  if (!options.baseline.empty()) baseline = verification::read_baseline(options.baseline);
  const auto groups = verification::groups_of(study, Store::open(options.store));
  content.judged_study = study.name;
  FloorExplainer explainer(options, study);
  auto verdicts = verification::judge(groups, rules, baseline,
                                      [&](const verification::Group& group, std::size_t measure) {
                                        return explainer(group, measure);
                                      });
  const auto costs = verification::judge_costs(groups, rules, baseline);
  verdicts.insert(verdicts.end(), costs.begin(), costs.end());
  content.verdicts = std::move(verdicts);
}

}  // namespace

ReportContent read_report(const ReportOptions& options) {
  ReportContent content;
  content.options = options;
  const auto chosen = chosen_measure(options.measure);
  if (options.study.empty() && !options.baseline.empty()) {
    throw InputError("--baseline: expected --study FILE, which it belongs to");
  }
  if (options.study.empty() && !options.junit.empty()) {
    throw InputError("--junit: expected --study FILE, whose verdicts it is to hold");
  }
  CaseTableOptions how;
  how.store = options.store;
  auto rows = Store::open(options.store).all();
  content.provenance = provenance_of(options.store);
  for (const auto& p : content.provenance) how.numerics[p.id] = p.numerics;
  if (!options.study.empty()) {
    const TomlDocument document = TomlDocument::load(options.study);
    const verification::Study study = verification::read_study(document);
    if (study.refine) how.refined_by = study.axes[*study.refine].name();
    judge_study(options, document, study, content);
  }
  auto tables = case_tables(std::move(rows), how);
  if (!options.compare.empty()) {
    const std::size_t measure = chosen ? *chosen
                                : tables.empty()
                                    ? *verification::measure_index("effective_stress_field_l2")
                                    : measures_of(tables.front()).front();
    content.comparison = compare(tables, Store::open(options.compare).all(), measure);
    content.comparison->after = options.compare;
  }
  for (std::size_t t = 0; t < tables.size(); ++t) {
    const std::string prefix =
        tables.size() == 1 ? "" : fmt::format("{}_{}_", t + 1, slug(tables[t].study));
    content.studies.push_back(study_report(std::move(tables[t]), chosen, prefix));
  }
  return content;
}

}  // namespace porowave::reports
