#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "reports/report/page.hpp"
#include "reports/report/text_forms.hpp"

namespace porowave::reports {

namespace {

using nlohmann::json;
using verification::Record;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines(1);
  for (const char c : text) {
    if (c == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += c;
    }
  }
  return lines;
}

/// A specification as what differs from the group's: [[line, text], ...], or all of it.
json difference(const std::vector<std::string>& group, const std::string& specification) {
  const auto lines = lines_of(specification);
  if (lines.size() != group.size()) return specification;
  json result = json::array();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i] != group[i]) result.push_back({i, lines[i]});
  }
  return result;
}

/// [id, level, seed, status, errors, CPU seconds, ns a point and step, difference, reason]
json case_entry(const StudyReport& report, const TableLevel& level, std::size_t row,
                const std::vector<std::string>& specification) {
  const Record& record = report.table.rows[row];
  json errors = json::array();
  for (const std::size_t m : report.measures) errors.push_back(error_text(record.measures[m]));
  return json::array({record.id, level.text, report.table.seeds[row],
                      static_cast<int>(record.status), std::move(errors),
                      number_text(record.cpu_seconds), number_text(record.ns_per_point_step()),
                      difference(specification, record.specification), record.reason});
}

json group_entry(const StudyReport& report, const TableGroup& group) {
  const std::string& specification =
      report.table.rows[group.levels.front().rows.front()].specification;
  const auto lines = lines_of(specification);
  json cases = json::array();
  for (const TableLevel& level : group.levels) {
    for (const std::size_t row : level.rows) {
      cases.push_back(case_entry(report, level, row, lines));
    }
  }
  return {{"name", group.name}, {"spec", specification}, {"cases", std::move(cases)}};
}

json study_entry(const StudyReport& report) {
  json measures = json::array();
  for (const std::size_t m : report.measures) {
    measures.push_back(measure_title(verification::measure_names()[m]));
  }
  json groups = json::array();
  for (const TableGroup& group : report.table.groups) groups.push_back(group_entry(report, group));
  const std::string& key = report.table.refined_by;
  return {{"name", report.table.study},
          {"level", key.substr(key.rfind('.') + 1)},
          {"measures", std::move(measures)},
          {"groups", std::move(groups)}};
}

}  // namespace

std::string page_data(const ReportContent& content) {
  const std::string study = content.options.study.empty() ? "STUDY.toml" : content.options.study;
  json tables = json::array();
  for (const ResultTable& table : tables_of(content)) {
    tables.push_back({{"name", table.name}, {"columns", table.columns}, {"rows", table.rows}});
  }
  json studies = json::array();
  for (std::size_t s = 0; s < content.studies.size(); ++s) {
    studies.push_back(study_entry(content.studies[s]));
    studies.back()["table"] = groups_table(content, s).name;
  }
  const json data = {{"rerun", fmt::format("porowave sweep {} --store {} --case ",
                                           shell_word(study), shell_word(content.options.store))},
                     {"statuses", verification::case_status_names},
                     {"tables", std::move(tables)},
                     {"studies", std::move(studies)}};
  // Bytes that are no UTF-8 (a store may hold any) are replaced, as a browser would.
  return json_in_html(data.dump(-1, ' ', true, json::error_handler_t::replace));
}

}  // namespace porowave::reports
