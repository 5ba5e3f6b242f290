#include "reports/report/group_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verification/not_a_number.hpp"
#include "verification/parallel.hpp"

namespace porowave::reports {

namespace {

using verification::OrderStatus;
using verification::Record;

using verification::nan;

double median(std::vector<double> values) {
  if (values.empty()) return nan;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

LevelSummary level_of(const StudyTable& table, const TableLevel& level, std::size_t measure) {
  LevelSummary result;
  result.spacing = level.spacing;
  result.text = level.text;
  result.cases = level.rows.size();
  std::vector<double> logs;
  std::vector<double> cpu;
  std::vector<double> ns;
  std::vector<double> points;
  for (const std::size_t i : level.rows) {
    const Record& row = table.rows[i];
    const double error = row.measures[measure];
    if (row.status != verification::CaseStatus::done || !(error > 0.0) || !std::isfinite(error)) {
      continue;
    }
    logs.push_back(std::log(error));
    cpu.push_back(row.cpu_seconds);
    points.push_back(static_cast<double>(row.points));
    if (std::isfinite(row.ns_per_point_step())) ns.push_back(row.ns_per_point_step());
  }
  result.ended = logs.size();
  double sum = 0.0;
  for (const double l : logs) sum += l;
  const bool any = !logs.empty();
  result.error = any ? std::exp(sum / static_cast<double>(logs.size())) : nan;
  result.low = any ? std::exp(*std::min_element(logs.begin(), logs.end())) : nan;
  result.high = any ? std::exp(*std::max_element(logs.begin(), logs.end())) : nan;
  result.cpu_seconds = median(cpu);
  result.ns_per_point_step = median(ns);
  result.points = median(points);
  return result;
}

}  // namespace

double GroupSummary::finest_error() const {
  return finest().ended == finest().cases ? finest().error : nan;
}

GroupSummary summary_of(const StudyTable& table, const TableGroup& group, std::size_t measure) {
  GroupSummary result;
  for (const TableLevel& level : group.levels) {
    result.levels.push_back(level_of(table, level, measure));
    result.ended += result.levels.back().ended;
    result.cases += result.levels.back().cases;
  }
  result.order = verification::estimate_order(errors_of(table, group, measure));
  return result;
}

std::vector<GroupSummary> summaries_of(const StudyTable& table, std::size_t measure) {
  std::vector<GroupSummary> result(table.groups.size());
  verification::parallel_for(result.size(), [&](std::size_t g) {
    result[g] = summary_of(table, table.groups[g], measure);
  });
  return result;
}

std::string order_text(const verification::OrderEstimate& order) {
  switch (order.status) {
    case OrderStatus::observed: {
      const double half = 0.5 * (order.high - order.low);
      return fmt::format("{0:.{2}f} ± {1:.{2}f}", order.order, half, half < 0.005 ? 3 : 2);
    }
    case OrderStatus::at_floor:
      return fmt::format("at floor {:.2g}", order.floor);
    case OrderStatus::too_few_levels:
      return "too few levels";
    case OrderStatus::not_asymptotic:
      return "not asymptotic";
    default:
      return "errors missing";
  }
}

std::vector<std::size_t> measures_of(const StudyTable& table) {
  const auto named = [](const char* where) {
    std::vector<std::size_t> list;
    for (const char* field :
         {"effective_stress", "pore_pressure", "solid_velocity", "fluid_velocity"}) {
      list.push_back(*verification::measure_index(fmt::format("{}_{}_l2", field, where)));
    }
    return list;
  };
  const auto has = [&](const std::vector<std::size_t>& list) {
    return std::any_of(table.rows.begin(), table.rows.end(), [&](const Record& row) {
      return std::any_of(list.begin(), list.end(),
                         [&](std::size_t m) { return std::isfinite(row.measures[m]); });
    });
  };
  const auto points = named("points");
  const auto field = named("field");
  return !has(field) && has(points) ? points : field;
}

std::string measure_title(const std::string& measure) {
  std::string text = measure;
  for (const auto& [from, to] :
       {std::pair("_field_", ", field, "), std::pair("_points_", ", points, "),
        std::pair("linf", "L∞"), std::pair("l1", "L1"), std::pair("l2", "L2")}) {
    const auto at = text.find(from);
    if (at != std::string::npos) text.replace(at, std::string_view(from).size(), to);
  }
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

}  // namespace porowave::reports
