#include "reports/report/case_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <set>

#include "reports/report/case_keys.hpp"
#include "reports/report/table_axes.hpp"

namespace porowave::reports {

namespace {

using verification::Record;

constexpr auto seed_key = "discretization.seed";

/// Counts are refined upwards, anything else downwards.
bool counted(const std::string& key) {
  return key == "discretization.elements" || key == "discretization.points_per_element";
}

double spacing_of(const CaseKeys& keys, const std::string& key, bool as_length) {
  const auto found = keys.find(key);
  const double value =
      found == keys.end() ? 1.0 : std::strtod(shown(found->second).c_str(), nullptr);
  if (!(value > 0.0)) return 1.0;
  const double spacing = counted(key) ? 1.0 / value : value;
  return as_length ? spacing * std::strtod(shown(keys.at("column.length")).c_str(), nullptr)
                   : spacing;
}

std::string text_of_key(const CaseKeys& keys, const std::string& key) {
  const auto found = keys.find(key);
  return found == keys.end() ? std::string() : shown(found->second);
}

/// Builds of the program count as a key where one specification has rows of several.
void tell_builds_apart(const StudyTable& table, const CaseTableOptions& options,
                       std::vector<CaseKeys>& keys) {
  std::set<std::string> seen;
  const bool repeated = std::any_of(table.rows.begin(), table.rows.end(), [&](const Record& row) {
    return !seen.insert(row.specification).second;
  });
  if (!repeated) return;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto known = options.numerics.find(table.rows[i].provenance);
    const std::string& build =
        known == options.numerics.end() ? table.rows[i].provenance : known->second;
    keys[i]["program.numerics"] = TomlValue{build.substr(0, 8)};
  }
}

std::string name_of(const StudyTable& table, const TableGroup& group) {
  std::string name;
  for (std::size_t a = 0; a < table.axes.size(); ++a) {
    name += fmt::format("{}{} = {}", name.empty() ? "" : ", ", table.axes[a].title,
                        table.value(group, a));
  }
  return name.empty() ? "all cases" : name;
}

void add_row(TableGroup& group, std::size_t row, double spacing, const std::string& text) {
  auto level = std::find_if(group.levels.begin(), group.levels.end(),
                            [&](const TableLevel& l) { return l.spacing == spacing; });
  if (level == group.levels.end()) {
    group.levels.push_back({spacing, text, {}});
    level = std::prev(group.levels.end());
  }
  level->rows.push_back(row);
}

void sort_levels(const StudyTable& table, TableGroup& group) {
  std::sort(group.levels.begin(), group.levels.end(),
            [](const auto& a, const auto& b) { return a.spacing > b.spacing; });
  for (TableLevel& level : group.levels) {
    std::sort(level.rows.begin(), level.rows.end(), [&](std::size_t a, std::size_t b) {
      const double seed_a = std::strtod(table.seeds[a].c_str(), nullptr);
      const double seed_b = std::strtod(table.seeds[b].c_str(), nullptr);
      return seed_a != seed_b ? seed_a < seed_b : table.rows[a].id < table.rows[b].id;
    });
  }
}

StudyTable table_of(std::vector<Record> rows, const CaseTableOptions& options) {
  StudyTable table;
  table.study = rows.front().study;
  table.rows = std::move(rows);
  table.refined_by = options.refined_by;
  std::vector<CaseKeys> keys;
  for (const Record& row : table.rows) {
    keys.push_back(case_keys(row.specification, fmt::format("{}: row {}", options.store, row.id)));
    table.seeds.push_back(text_of_key(keys.back(), seed_key));
    table.spacing_is_length = table.spacing_is_length && keys.back().contains("column.length");
  }
  table.spacing_is_length =
      table.spacing_is_length && table.refined_by == "discretization.elements";
  tell_builds_apart(table, options, keys);
  const AxesOfTable found = axes_of(keys, {seed_key, table.refined_by});
  table.axes = found.axes;
  table.constants = found.constants;
  std::map<std::vector<std::size_t>, TableGroup> groups;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    TableGroup& group = groups[found.places[i]];
    group.at = found.places[i];
    add_row(group, i, spacing_of(keys[i], table.refined_by, table.spacing_is_length),
            text_of_key(keys[i], table.refined_by));
  }
  for (auto& [at, group] : groups) {
    group.name = name_of(table, group);
    sort_levels(table, group);
    table.groups.push_back(std::move(group));
  }
  return table;
}

}  // namespace

std::vector<StudyTable> case_tables(std::vector<Record> rows, const CaseTableOptions& options) {
  std::map<std::string, std::vector<Record>> by_study;
  for (Record& row : rows) by_study[row.study].push_back(std::move(row));
  std::vector<StudyTable> tables;
  tables.reserve(by_study.size());
  for (auto& [study, of_study] : by_study) tables.push_back(table_of(std::move(of_study), options));
  return tables;
}

verification::ErrorTable errors_of(const StudyTable& table, const TableGroup& group,
                                   std::size_t measure) {
  std::vector<std::string> seeds;
  for (const TableLevel& level : group.levels) {
    for (const std::size_t row : level.rows) seeds.push_back(table.seeds[row]);
  }
  seeds = in_natural_order(std::move(seeds));
  verification::ErrorTable errors;
  for (const TableLevel& level : group.levels) {
    errors.spacing.push_back(level.spacing);
    auto& of_level =
        errors.errors.emplace_back(seeds.size(), std::numeric_limits<double>::quiet_NaN());
    for (const std::size_t row : level.rows) {
      if (table.rows[row].status != verification::CaseStatus::done) continue;
      const auto place = std::find(seeds.begin(), seeds.end(), table.seeds[row]) - seeds.begin();
      of_level[static_cast<std::size_t>(place)] = table.rows[row].measures[measure];
    }
  }
  return errors;
}

}  // namespace porowave::reports
