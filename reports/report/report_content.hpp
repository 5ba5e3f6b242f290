#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/report/comparison.hpp"
#include "reports/report/report_figures.hpp"
#include "reports/report/result_table.hpp"
#include "verification/gate/verdict.hpp"
#include "verification/store/record.hpp"

namespace porowave::reports {

/// What a report is asked for.
struct ReportOptions {
  std::string store;
  std::string output;
  std::string study;            ///< its file, for verdicts; empty: none are given
  std::string baseline;         ///< of these verdicts; may be empty
  std::string compare;          ///< another store, "after"; empty: none
  std::string measure;          ///< what figures show; empty: L2 of effective stress
  std::string junit;            ///< file for the verdicts as JUnit XML; empty: none
  double floor_seconds = 20.0;  ///< of CPU to find causes of floors, by a guess from the store
  int runs = 8;                 ///< cases that are run again for pictures of their fields, at most
  double map_seconds = 5.0;     ///< of CPU for maps of critical steps, by a guess; 0: none
  double run_seconds = 20.0;    ///< of CPU for that, by a guess (run_plan.hpp)
};

/// Figures of the fields of some cases of one problem.
struct RunSection {
  std::string heading;
  std::vector<std::string> notes;  ///< on runs without figures
  std::vector<ReportFigure> figures;
};

/// One study of the store.
struct StudyReport {
  StudyTable table;
  std::size_t measure = 0;                           ///< that of the figures
  std::vector<std::size_t> measures;                 ///< that and the L2 errors of the other fields
  std::vector<std::vector<GroupSummary>> summaries;  ///< [measure][group]
  std::vector<ReportFigure> figures;
  std::string prefix;            ///< of the names of its figures
  std::vector<RunSection> runs;  ///< of cases that were run again
  std::array<std::size_t, verification::case_status_names.size()> by_status{};
};

/// All that a report shows, before it has a form.
struct ReportContent {
  ReportOptions options;
  std::vector<StudyReport> studies;
  std::vector<verification::Provenance> provenance;
  std::optional<std::vector<verification::Verdict>> verdicts;
  std::string judged_study;  ///< name of the study that the verdicts are of
  std::optional<Comparison> comparison;
  std::vector<std::string> run_notes;  ///< cases worth a look that were not run again
};

/// Reads stores, study and baseline. Writes nothing. Throws InputError and EnvironmentError.
ReportContent read_report(const ReportOptions& options);

/// The groups of a study: values, errors at the finest level, order, cost; one row a group.
ResultTable groups_table(const ReportContent& content, std::size_t study);
/// Verdicts, those that somebody must look at first.
ResultTable verdicts_table(const ReportContent& content);
/// Cases that did not end, by reason.
ResultTable failures_table(const ReportContent& content);
/// Every case; only as a file.
ResultTable cases_table(const ReportContent& content, std::size_t study);
ResultTable comparison_table(const ReportContent& content);
ResultTable provenance_table(const ReportContent& content);
/// Pareto fronts of the problems of a study.
ResultTable front_table(const ReportContent& content, std::size_t study);

/// All tables for the page and the files, in their order; empty ones are left out.
std::vector<ResultTable> tables_of(const ReportContent& content);

}  // namespace porowave::reports
