#include "reports/report/critical_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "reference/problem/errors.hpp"
#include "reports/report/run_plan.hpp"
#include "reports/report/text_forms.hpp"
#include "reports/stability_map_figure.hpp"

namespace porowave::reports {

namespace {

/// Rows and columns of more scenes cannot be read.
constexpr std::size_t most_scenes = 1000;
constexpr std::size_t name_width = 60;

/// What the eigenvalues of a step do not know.
bool without_part(const TableAxis& axis) {
  return std::all_of(axis.keys.begin(), axis.keys.end(), [](const std::string& key) {
    return key.starts_with("load.") || key == "time.end" || key == "time.courant" ||
           key == "program.numerics";
  });
}

/// CPU time for all samples of a scene, s. Measured with 4 points a cell: 0.12 with 25 elements,
/// 2.3 with 100.
double guessed_seconds(const solver::Case& scene) {
  const auto& choice = scene.discretization;
  return 1.2e-4 * std::pow(choice.elements, 2.15) * std::max(1.0, choice.points_per_element / 4.0);
}

/// The scenes as a study whose axes are those of the table that matter.
verification::Study scenes_of(const StudyTable& table) {
  verification::Study study;
  study.name = shortened(table.study, name_width);
  std::vector<std::size_t> axes;
  for (std::size_t a = 0; a < table.axes.size(); ++a) {
    if (without_part(table.axes[a])) continue;
    axes.push_back(a);
    std::vector<TomlValue> values;
    for (const std::string& value : table.axes[a].values) values.push_back(TomlValue{value});
    study.axes.push_back({"", table.axes[a].title, values});
  }
  std::map<std::vector<std::size_t>, std::size_t> places;
  for (const TableGroup& group : table.groups) {
    std::vector<std::size_t> at;
    verification::StudyCase one;
    for (std::size_t k = 0; k < axes.size(); ++k) {
      at.push_back(group.at[axes[k]]);
      one.coordinates.push_back(study.axes[k].values[at.back()]);
    }
    const auto& row = table.rows[group.levels.front().rows.front()];
    try {
      one.scene = solver::read_case(TomlDocument::parse(row.specification, row.id));
    } catch (const std::exception&) {
      continue;
    }
    const auto [place, is_new] = places.try_emplace(at, study.cases.size());
    if (is_new) {
      study.cases.push_back(std::move(one));
      continue;
    }
    // Groups that differ in what has no part in the map: the longest step is held against it.
    double& courant = study.cases[place->second].scene.time.courant;
    courant = std::max(courant, one.scene.time.courant);
  }
  return study;
}

std::string scene_name(const verification::Study& study, const verification::StudyCase& one) {
  std::string name;
  for (std::size_t a = 0; a < study.axes.size(); ++a) {
    name += fmt::format("{}{} = {}", a == 0 ? "" : ", ", study.axes[a].key,
                        verification::plain_text(one.coordinates[a]));
  }
  return name;
}

std::string claim_of_map(const verification::Study& study,
                         const std::vector<verification::MappedStability>& map) {
  std::size_t above = 0;
  std::size_t stable = 0;
  std::optional<std::size_t> lowest;
  std::set<int> elements;
  for (std::size_t i = 0; i < map.size(); ++i) {
    elements.insert(study.cases[i].scene.discretization.elements);
    if (!map[i].refused.empty()) continue;
    const double critical = map[i].critical.courant;
    if (study.cases[i].scene.time.courant > critical) ++above;
    if (map[i].critical.unstable == 0.0) ++stable;
    if (!lowest || critical < map[*lowest].critical.courant) lowest = i;
  }
  std::string claim = fmt::format(
      "Critical Courant numbers by the eigenvalues of a step, for the coarsest case of every group "
      "({} elements) with its first seed; load and end have no part in it. Of {} scenes {} are "
      "stable up to courant 1; {} have a case beyond its critical step",
      *elements.begin() == *elements.rbegin()
          ? fmt::format("{}", *elements.begin())
          : fmt::format("{} to {}", *elements.begin(), *elements.rbegin()),
      map.size(), stable, above);
  if (lowest) {
    claim += fmt::format(". Lowest: {:.2f}, {}", map[*lowest].critical.courant,
                         scene_name(study, study.cases[*lowest]));
  }
  return claim + ".";
}

RunSection section_of(const verification::Study& study, const std::string& prefix) {
  const auto map = verification::stability_map(study, {});
  Figure figure = stability_map_figure(study, map);
  figure.name = prefix + "stability_map";
  figure.as_pdf = true;
  const std::string claim = claim_of_map(study, map);
  return {"Stability", {}, {{figure, "", claim, "A table of colours. " + claim}}};
}

}  // namespace

void add_critical_maps(ReportContent& content) {
  double spent = 0.0;
  for (StudyReport& report : content.studies) {
    const verification::Study study = scenes_of(report.table);
    if (study.cases.size() < 2 || study.cases.size() > most_scenes) continue;
    double seconds = 0.0;
    for (const auto& one : study.cases) seconds += guessed_seconds(one.scene);
    if (spent + seconds > content.options.map_seconds) {
      content.run_notes.push_back(fmt::format(
          "Left out: the map of critical Courant numbers of the {} scenes of {}. It would take "
          "about {:.2g} s of CPU, beyond --map-seconds {:g}. It is drawn by: {}",
          study.cases.size(), report.table.study, seconds, content.options.map_seconds,
          report_command(content.options,
                         fmt::format("--map-seconds {:.0f}", std::ceil(spent + seconds)))));
      continue;
    }
    spent += seconds;
    report.runs.push_back(section_of(study, report.prefix));
  }
}

}  // namespace porowave::reports
