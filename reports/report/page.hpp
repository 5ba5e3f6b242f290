#pragma once

#include <filesystem>
#include <string>

#include "reports/report/report_content.hpp"

namespace porowave::reports {

/// The report as one page of HTML that needs no server, no network and no other file: pictures are
/// in it (read from `directory`, where they have been drawn), links lead to the files beside it.
std::string page_html(const ReportContent& content, const std::filesystem::path& directory);

/// What the page's script knows: tables and cases, as JSON.
std::string page_data(const ReportContent& content);

}  // namespace porowave::reports
