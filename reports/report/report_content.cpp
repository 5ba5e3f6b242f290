#include "reports/report/report_content.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reference/problem/errors.hpp"
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
  report.figures = figures_of({report.table, report.summaries.front(), report.measure, prefix});
  return report;
}

/// What the study file says of the store, as `porowave gate` does (it alone runs cases to explain
/// floors).
void judge_study(const ReportOptions& options, const TomlDocument& document,
                 const verification::Study& study, ReportContent& content) {
  const auto rules = verification::read_gate_rules(document, study);
  std::optional<verification::Baseline> baseline;
  if (!options.baseline.empty()) baseline = verification::read_baseline(options.baseline);
  const auto groups = verification::groups_of(study, Store::open(options.store));
  content.judged_study = study.name;
  content.verdicts = verification::judge(groups, rules, baseline);
}

}  // namespace

ReportContent read_report(const ReportOptions& options) {
  ReportContent content;
  content.options = options;
  const auto chosen = chosen_measure(options.measure);
  if (options.study.empty() && !options.baseline.empty()) {
    throw InputError("--baseline: expected --study FILE, which it belongs to");
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
