#pragma once

#include <filesystem>
#include <vector>

#include "reports/report/report_content.hpp"

namespace porowave::reports {

/// What a store shows: figures (SVG, PDF, PNG, each with its script and data), a page (index.html),
/// a summary for pull requests (summary.md), every table as CSV and LaTeX. Returns what it wrote.
///
/// All input is read and judged before anything is written. Throws InputError for a store, study or
/// baseline that is none, EnvironmentError for a directory that cannot be written and if figures
/// are needed and gnuplot is missing.
std::vector<std::filesystem::path> write_report(const ReportOptions& options);

}  // namespace porowave::reports
