#include "verification/gate/observation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

namespace porowave::verification {

namespace {

double number_of(const TomlValue& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value.value)) {
    return static_cast<double>(*integer);
  }
  return std::get<double>(value.value);
}

/// Elements are counted, other axes of refinement are lengths, times or numbers that fall.
double spacing_of(const Study& study, const TomlValue& level) {
  const bool counted = study.axes[*study.refine].key == "elements" ||
                       study.axes[*study.refine].key == "points_per_element";
  return counted ? 1.0 / number_of(level) : number_of(level);
}

std::string words(const Study& study, const std::vector<TomlValue>& at, bool whole) {
  std::string text;
  for (std::size_t a = 0; a < study.axes.size(); ++a) {
    if (!whole && (a == study.refine || a == study.seed)) continue;
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", study.axes[a].name(), at[a].text());
  }
  return text.empty() ? "all cases" : text;
}

std::size_t place_of(const std::vector<TomlValue>& values, const TomlValue& value) {
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](const TomlValue& v) { return same_value(v, value); });
  return static_cast<std::size_t>(found - values.begin());
}

Group empty_group(const Study& study, const std::vector<TomlValue>& at) {
  Group group;
  group.name = words(study, at, false);
  group.coordinates = at;
  if (study.refine) {
    group.levels = study.axes[*study.refine].values;
    std::sort(group.levels.begin(), group.levels.end(), [&](const auto& a, const auto& b) {
      return spacing_of(study, a) > spacing_of(study, b);
    });
    for (const TomlValue& level : group.levels) group.spacing.push_back(spacing_of(study, level));
  } else {
    group.levels = {TomlValue{}};
    group.spacing = {1.0};
  }
  if (study.seed) {
    for (const TomlValue& seed : study.axes[*study.seed].values) group.seeds.push_back(seed.text());
  } else {
    group.seeds = {""};
  }
  Record none;
  none.status = CaseStatus::failed;
  none.measures.assign(measure_names().size(), std::numeric_limits<double>::quiet_NaN());
  group.records.assign(group.levels.size(), std::vector<Record>(group.seeds.size(), none));
  return group;
}

}  // namespace

std::vector<Group> groups_of(const Study& study, const Store& store) {
  std::map<std::string, Record> rows;
  for (Record& row : store.all()) rows.emplace(row.id, std::move(row));
  std::vector<Group> groups;
  std::map<std::string, std::size_t> index;
  for (const StudyCase& one : study.cases) {
    const auto [entry, fresh] = index.emplace(words(study, one.coordinates, false), groups.size());
    if (fresh) groups.push_back(empty_group(study, one.coordinates));
    Group& group = groups[entry->second];
    ++group.cases;
    const auto row = rows.find(one.id);
    if (row == rows.end() || row->second.status == CaseStatus::failed) {
      const std::string why = row == rows.end() ? "" : ": " + row->second.reason;
      group.missing.push_back(words(study, one.coordinates, true) + why);
      continue;
    }
    if (row->second.status != CaseStatus::done) {
      group.broken.push_back(
          fmt::format("{}: {}", words(study, one.coordinates, true), row->second.reason));
    }
    const auto level = study.refine ? place_of(group.levels, one.coordinates[*study.refine]) : 0;
    const auto seed =
        study.seed ? place_of(study.axes[*study.seed].values, one.coordinates[*study.seed]) : 0;
    group.records[level][seed] = row->second;
  }
  return groups;
}

ErrorTable errors_of(const Group& group, std::size_t measure) {
  ErrorTable table{group.spacing, {}};
  for (const auto& level : group.records) {
    std::vector<double>& row = table.errors.emplace_back();
    for (const Record& record : level) row.push_back(record.measures[measure]);
  }
  return table;
}

}  // namespace porowave::verification
