#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "reports/report/figure_parts.hpp"
#include "reports/report/report_content.hpp"

namespace porowave::reports {

namespace {

using verification::CaseStatus;
using verification::OrderStatus;
using verification::Record;

std::string numbered(const ReportContent& content, const char* name, std::size_t study) {
  return content.studies.size() == 1 ? name : fmt::format("{}_{}", name, study + 1);
}

std::string of_study(const ReportContent& content, std::size_t study) {
  return content.studies.size() == 1
             ? std::string()
             : fmt::format(" of the study {}", content.studies[study].table.study);
}

std::string levels_text(const GroupSummary& summary) {
  const std::string& first = summary.levels.front().text;
  const std::string& last = summary.levels.back().text;
  if (summary.levels.size() == 1) return last.empty() ? "1" : last;
  return fmt::format("{} … {} ({})", first, last, summary.levels.size());
}

/// "effective stress": the field of a measure.
std::string field_of(std::size_t measure) {
  const std::string title = measure_title(verification::measure_names()[measure]);
  return title.substr(0, title.find(','));
}

std::vector<std::string> order_cells(const verification::OrderEstimate& order) {
  const bool has = order.status == OrderStatus::observed || order.status == OrderStatus::at_floor;
  return {has ? fmt::format("{:.2f}", order.order) : "–",
          has ? fmt::format("{:.2f}", order.low) : "–",
          has ? fmt::format("{:.2f}", order.high) : "–",
          std::string(verification::order_status_names[static_cast<std::size_t>(order.status)]),
          order.floor > 0.0 ? error_text(order.floor) : "–"};
}

/// How urgent a verdict is: those that somebody must look at come first.
int rank(verification::VerdictKind kind) {
  using verification::VerdictKind;
  switch (kind) {
    case VerdictKind::fail:
      return 0;
    case VerdictKind::xpass:
      return 1;
    case VerdictKind::inconclusive:
      return 2;
    case VerdictKind::xfail:
      return 3;
    default:
      return 4;
  }
}

}  // namespace

ResultTable groups_table(const ReportContent& content, std::size_t study) {
  const StudyReport& report = content.studies[study];
  const StudyTable& table = report.table;
  ResultTable result{numbered(content, "groups", study),
                     "Groups" + of_study(content, study) +
                         ": cases that differ only in level and seed; errors are relative, at the "
                         "finest level, means over the seeds",
                     {},
                     {}};
  for (const TableAxis& axis : table.axes) result.columns.push_back(axis.title);
  if (table.axes.empty()) result.columns.push_back("group");
  for (const std::size_t m : report.measures) result.columns.push_back(field_of(m));
  for (const char* column : {"order", "low", "high", "order status", "floor", "levels", "cases",
                             "ended", "CPU (s)", "ns/point/step"}) {
    result.columns.push_back(column);
  }
  for (std::size_t g = 0; g < table.groups.size(); ++g) {
    const GroupSummary& summary = report.summaries.front()[g];
    std::vector<std::string> row;
    for (std::size_t a = 0; a < table.axes.size(); ++a) {
      row.push_back(table.value(table.groups[g], a));
    }
    if (table.axes.empty()) row.push_back("all cases");
    for (const auto& of_measure : report.summaries) {
      row.push_back(error_text(of_measure[g].finest_error()));
    }
    for (auto& cell : order_cells(summary.order)) row.push_back(std::move(cell));
    row.push_back(levels_text(summary));
    row.push_back(fmt::format("{}", summary.cases));
    row.push_back(fmt::format("{}", summary.ended));
    row.push_back(number_text(summary.finest().cpu_seconds));
    row.push_back(number_text(summary.finest().ns_per_point_step));
    result.add(std::move(row));
  }
  return result;
}

ResultTable verdicts_table(const ReportContent& content) {
  ResultTable result{"verdicts",
                     fmt::format("Verdicts of the study {}", content.judged_study),
                     {"verdict", "group", "measure", "reason"},
                     {}};
  if (!content.verdicts) return result;
  auto verdicts = *content.verdicts;
  std::stable_sort(verdicts.begin(), verdicts.end(),
                   [](const auto& a, const auto& b) { return rank(a.kind) < rank(b.kind); });
  for (const auto& v : verdicts) {
    result.add({std::string(to_string(v.kind)), v.group, v.measure, v.reason});
  }
  return result;
}

ResultTable failures_table(const ReportContent& content) {
  ResultTable result{"failures",
                     "Cases that did not end, by group and reason",
                     {"study", "group", "status", "cases", "reason of the first", "its id"},
                     {}};
  for (const StudyReport& report : content.studies) {
    for (const TableGroup& group : report.table.groups) {
      std::map<CaseStatus, std::vector<const Record*>> by_status;
      for (const TableLevel& level : group.levels) {
        for (const std::size_t row : level.rows) {
          const Record& record = report.table.rows[row];
          if (record.status != CaseStatus::done) by_status[record.status].push_back(&record);
        }
      }
      for (const auto& [status, rows] : by_status) {
        result.add({report.table.study, group.name,
                    std::string(verification::case_status_names[static_cast<std::size_t>(status)]),
                    fmt::format("{}", rows.size()), rows.front()->reason, rows.front()->id});
      }
    }
  }
  return result;
}

ResultTable cases_table(const ReportContent& content, std::size_t study) {
  const StudyReport& report = content.studies[study];
  ResultTable result{numbered(content, "cases", study), "Every case", {}, {}};
  result.columns = {"id", "group", report.table.refined_by, "seed", "status", "reason"};
  for (const std::size_t m : report.measures) {
    result.columns.push_back(verification::measure_names()[m]);
  }
  for (const char* c : {"steps", "points", "cpu_seconds", "ns_per_point_step"}) {
    result.columns.push_back(c);
  }
  for (const TableGroup& group : report.table.groups) {
    for (const TableLevel& level : group.levels) {
      for (const std::size_t i : level.rows) {
        const Record& record = report.table.rows[i];
        std::vector<std::string> row = {
            record.id,
            group.name,
            level.text,
            report.table.seeds[i],
            std::string(verification::case_status_names[static_cast<std::size_t>(record.status)]),
            record.reason};
        for (const std::size_t m : report.measures) {
          row.push_back(error_text(record.measures[m]));
        }
        row.push_back(fmt::format("{}", record.steps));
        row.push_back(fmt::format("{}", record.points));
        row.push_back(number_text(record.cpu_seconds));
        row.push_back(number_text(record.ns_per_point_step()));
        result.add(std::move(row));
      }
    }
  }
  return result;
}

ResultTable comparison_table(const ReportContent& content) {
  ResultTable result{"comparison",
                     "",
                     {"change", "study", "group", "error after/before", "worst case",
                      "CPU after/before", "cases", "now broken", "now ended"},
                     {}};
  if (!content.comparison) return result;
  result.caption = fmt::format("From {} to {}: ratios after/before, the error at the finest level",
                               content.options.store, content.comparison->after);
  for (const ComparedGroup& g : content.comparison->groups) {
    result.add({g.verdict, g.study, g.group, number_text(g.error_ratio), number_text(g.worst_ratio),
                number_text(g.cost_ratio), fmt::format("{}", g.cases),
                fmt::format("{}", g.now_broken), fmt::format("{}", g.now_ended)});
  }
  return result;
}

ResultTable provenance_table(const ReportContent& content) {
  ResultTable result{"provenance",
                     "What the cases were run with",
                     {"version", "commit", "numerics", "compiler", "flags", "processor", "host"},
                     {}};
  for (const auto& p : content.provenance) {
    result.add({p.version, p.git, p.numerics.substr(0, 8), p.compiler, p.flags, p.cpu, p.host});
  }
  return result;
}

ResultTable front_table(const ReportContent& content, std::size_t study) {
  const StudyReport& report = content.studies[study];
  const StudyTable& table = report.table;
  ResultTable result{numbered(content, "pareto", study),
                     "Pareto fronts" + of_study(content, study) +
                         ": no other group and level is both cheaper and more precise",
                     {"problem", "method", "level", "CPU (s)", "error"},
                     {}};
  const auto axes = problem_axes(table);
  std::vector<std::size_t> methods(table.axes.size() - axes.size());
  std::iota(methods.begin(), methods.end(), std::size_t{0});  // those of the problem come last
  for (const FigurePart& part : parts_of(table, axes)) {
    const std::string problem = described(table, axes, part.at);
    for (const FrontMember& m : pareto_front(report.summaries.front(), part.groups)) {
      const std::string method = described(table, methods, table.groups[m.group].at);
      result.add({problem.empty() ? "the only one" : problem,
                  method.empty() ? "the only one" : method,
                  table.groups[m.group].levels[m.level].text, number_text(m.cpu_seconds),
                  error_text(m.error)});
    }
  }
  return result;
}

std::vector<ResultTable> tables_of(const ReportContent& content) {
  std::vector<ResultTable> tables;
  if (content.verdicts) tables.push_back(verdicts_table(content));
  if (content.comparison) tables.push_back(comparison_table(content));
  for (std::size_t s = 0; s < content.studies.size(); ++s) {
    tables.push_back(groups_table(content, s));
    tables.push_back(front_table(content, s));
  }
  tables.push_back(failures_table(content));
  tables.push_back(provenance_table(content));
  std::erase_if(tables, [](const ResultTable& table) { return table.rows.empty(); });
  return tables;
}

}  // namespace porowave::reports
