#pragma once

#include <string>

#include "reports/report/report_content.hpp"

namespace porowave::reports {

/// The outcome in a line: "fail: 2 fail, 6 pass" of the verdicts, or how many groups have an order.
std::string outcome_line(const ReportContent& content);

/// What a store holds: "paper: 80 cases, 78 done, 2 broke down; 16 groups".
std::string study_line(const StudyReport& report);

/// What another store changed, if one was compared: "3 better, 1 worse, 12 same".
std::string comparison_line(const ReportContent& content);

/// Why verdicts may find no cases: the store was filled by builds with other numerics than this
/// program, whose cases have other ids. Empty if that is not so, or nothing was judged.
std::string build_note(const ReportContent& content);

/// The report for a pull request: outcome, what changed, what failed, the best groups.
std::string summary_markdown(const ReportContent& content);

}  // namespace porowave::reports
