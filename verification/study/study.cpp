#include "verification/study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "reference/problem/errors.hpp"
#include "verification/parallel.hpp"
#include "verification/study/case_identity.hpp"

namespace porowave::verification {

namespace {

constexpr std::size_t most_cases = 10'000'000;
constexpr auto seed_axis = "discretization.seed";

/// "section.key"
std::optional<std::pair<std::string, std::string>> split(const std::string& name) {
  const auto dot = name.find('.');
  if (dot == std::string::npos || dot == 0 || dot + 1 == name.size()) return std::nullopt;
  return std::pair(name.substr(0, dot), name.substr(dot + 1));
}

/// The place of a key of a case, given by its name in a table of the study.
std::pair<std::string, std::string> place_in_case(const TomlSection& section,
                                                  const std::string& name) {
  static const std::vector<std::string> tables = {"material", "column", "load", "discretization",
                                                  "time"};
  const auto place = split(name);
  if (!place || std::find(tables.begin(), tables.end(), place->first) == tables.end()) {
    section.refuse(name, "a key of a case, such as \"discretization.kernel\"");
  }
  return *place;
}

Axis read_methods(const TomlDocument& document) {
  const auto of_axes = document.section("axes").keys();
  Axis axis{"", "method", {}, {}};
  for (TomlSection& section : document.sections("method")) {
    const std::string name = section.text("name");
    const auto same = [&](const TomlValue& v) { return std::get<std::string>(v.value) == name; };
    if (name.empty() || std::any_of(axis.values.begin(), axis.values.end(), same)) {
      section.refuse("name", "a name that no other [[method]] has");
    }
    std::vector<Setting> settings;
    for (const std::string& key : section.keys()) {
      if (key == "name") continue;
      const auto [table, of_case] = place_in_case(section, key);
      if (std::find(of_axes.begin(), of_axes.end(), key) != of_axes.end()) {
        section.refuse(key, "a key that is no axis of [axes]");
      }
      const auto value = section.value_if(key);
      if (!value) section.refuse(key, "a value that this key of a case may have");
      settings.push_back({table, of_case, *value});
    }
    axis.values.push_back({name});
    axis.methods.push_back(std::move(settings));
  }
  return axis;
}

std::vector<Axis> read_axes(const TomlDocument& document) {
  std::vector<Axis> axes;
  Axis methods = read_methods(document);
  if (!methods.values.empty()) axes.push_back(std::move(methods));
  TomlSection section = document.section("axes");
  for (const std::string& name : section.keys()) {
    const auto [table, key] = place_in_case(section, name);
    axes.push_back({table, key, section.values(name)});
  }
  return axes;
}

TomlDocument with_value(const TomlDocument& document, const Axis& axis, std::size_t value) {
  if (axis.methods.empty()) return document.with(axis.section, axis.key, axis.values[value]);
  TomlDocument result = document;
  for (const Setting& s : axis.methods[value]) result = result.with(s.section, s.key, s.value);
  return result;
}

std::optional<std::size_t> axis_named(const std::vector<Axis>& axes, const std::string& name) {
  const auto found =
      std::find_if(axes.begin(), axes.end(), [&](const Axis& a) { return a.name() == name; });
  if (found == axes.end()) return std::nullopt;
  return static_cast<std::size_t>(found - axes.begin());
}

std::optional<std::size_t> read_refinement(const TomlDocument& document,
                                           const std::vector<Axis>& axes) {
  TomlSection section = document.section("refine");
  if (!section.present()) return std::nullopt;
  const auto axis = axis_named(axes, section.text("by"));
  section.done();
  if (!axis) section.refuse("by", "the name of an axis of [axes]");
  for (const TomlValue& value : axes[*axis].values) {
    const bool number = std::holds_alternative<std::int64_t>(value.value) ||
                        std::holds_alternative<double>(value.value);
    if (!number) section.refuse("by", "an axis whose values are numbers");
  }
  return axis;
}

/// One [[exclude]]: for some axes, the values that are left out together.
using Exclusion = std::map<std::size_t, std::vector<TomlValue>>;

std::vector<Exclusion> read_exclusions(const TomlDocument& document,
                                       const std::vector<Axis>& axes) {
  std::vector<Exclusion> exclusions;
  for (TomlSection& section : document.sections("exclude")) {
    Exclusion& exclusion = exclusions.emplace_back();
    for (const std::string& name : section.keys()) {
      const auto axis = axis_named(axes, name);
      if (!axis) section.refuse(name, "a key that is an axis of [axes]");
      const auto known = [&](const TomlValue& value) {
        return std::any_of(axes[*axis].values.begin(), axes[*axis].values.end(),
                           [&](const TomlValue& v) { return same_value(v, value); });
      };
      const auto one = section.value_if(name);
      const auto values = one && known(*one) ? std::vector{*one} : section.values(name);
      if (!std::all_of(values.begin(), values.end(), known)) {
        section.refuse(name, "values that the axis has");
      }
      exclusion[*axis] = values;
    }
    if (exclusion.empty()) throw InputError(document.path() + ": [[exclude]] without a key");
  }
  return exclusions;
}

bool excluded(const std::vector<Exclusion>& exclusions, const std::vector<TomlValue>& at) {
  return std::any_of(exclusions.begin(), exclusions.end(), [&](const Exclusion& exclusion) {
    return std::all_of(exclusion.begin(), exclusion.end(), [&](const auto& entry) {
      return std::any_of(entry.second.begin(), entry.second.end(),
                         [&](const TomlValue& v) { return same_value(v, at[entry.first]); });
    });
  });
}

std::string described(const std::vector<Axis>& axes, const std::vector<TomlValue>& at) {
  std::string text;
  for (std::size_t a = 0; a < axes.size(); ++a) {
    text += fmt::format("{}{} = {}", a == 0 ? "" : ", ", axes[a].name(), at[a].text());
  }
  return text;
}

StudyCase make_case(const TomlDocument& document, const Study& study, std::vector<TomlValue> at) {
  StudyCase result;
  result.specification =
      document.canonical({"material", "column", "load", "discretization", "time"});
  try {
    result.scene = solver::read_case(document);
  } catch (const InputError& error) {
    if (study.axes.empty()) throw;
    throw InputError(fmt::format("{}; in the case {}: correct it, or leave it out by [[exclude]]",
                                 error.what(), described(study.axes, at)));
  }
  result.coordinates = std::move(at);
  result.id =
      case_id(study.adapter ? result.specification + study.adapter->identity : result.specification,
              result.scene);
  return result;
}

/// Values of the first axes, and the document with them.
struct Branch {
  TomlDocument document;
  std::vector<TomlValue> at;

  Branch with(const Axis& axis, std::size_t value) const {
    Branch longer{with_value(document, axis, value), at};
    longer.at.push_back(axis.values[value]);
    return longer;
  }
};

/// All combinations of a branch with the axes that follow, which share the documents on their way.
void expand(const Branch& branch, const std::vector<Exclusion>& exclusions, const Study& study,
            std::vector<StudyCase>& cases) {
  if (branch.at.size() == study.axes.size()) {
    if (!excluded(exclusions, branch.at)) {
      cases.push_back(make_case(branch.document, study, branch.at));
    }
    return;
  }
  const Axis& axis = study.axes[branch.at.size()];
  for (std::size_t v = 0; v < axis.values.size(); ++v) {
    expand(branch.with(axis, v), exclusions, study, cases);
  }
}

/// The beginnings of all combinations: enough of them that every core gets its share.
std::vector<Branch> branches_of(const TomlDocument& document, const std::vector<Axis>& axes) {
  constexpr std::size_t enough = 64;
  constexpr std::size_t most = 4096;  // each holds a document
  std::vector<Branch> branches = {{document, {}}};
  for (const Axis& axis : axes) {
    if (branches.size() >= enough || branches.size() * axis.values.size() > most) break;
    std::vector<Branch> longer;
    for (const Branch& branch : branches) {
      for (std::size_t v = 0; v < axis.values.size(); ++v) longer.push_back(branch.with(axis, v));
    }
    branches = std::move(longer);
  }
  return branches;
}

std::vector<StudyCase> all_cases(const TomlDocument& document,
                                 const std::vector<Exclusion>& exclusions, const Study& study) {
  const std::vector<Branch> branches = branches_of(document, study.axes);
  std::vector<std::vector<StudyCase>> parts(branches.size());
  parallel_for(branches.size(),
               [&](std::size_t b) { expand(branches[b], exclusions, study, parts[b]); });
  std::vector<StudyCase> cases;
  for (auto& part : parts) std::move(part.begin(), part.end(), std::back_inserter(cases));
  return cases;
}

void require_distinct(const Study& study) {
  std::map<std::string, const StudyCase*> seen;
  for (const StudyCase& one : study.cases) {
    const auto [other, fresh] = seen.emplace(one.id, &one);
    if (fresh) continue;
    throw InputError(fmt::format("{}: [axes]: the case {} appears twice: expected distinct values",
                                 study.path, described(study.axes, one.coordinates)));
  }
}

}  // namespace

Study read_study(const TomlDocument& document) {
  document.only({"material", "column", "load", "discretization", "time", "study", "axes", "method",
                 "refine", "exclude", "gate", "known_failure", "adapter"});
  Study study;
  study.path = document.path();
  TomlSection section = document.section("study");
  study.name = section.text("name");
  section.done();
  if (study.name.empty()) section.refuse("name", "a word");
  study.adapter = read_adapter(document);
  study.axes = read_axes(document);
  study.refine = read_refinement(document, study.axes);
  study.seed = axis_named(study.axes, seed_axis);
  std::size_t count = 1;
  for (const Axis& axis : study.axes) {
    count *= axis.values.size();
    if (count <= most_cases) continue;
    throw InputError(fmt::format("{}: [axes]: {} cases or more: expected at most {}", study.path,
                                 count, most_cases));
  }
  const TomlDocument alone = document.without(
      {"study", "axes", "method", "refine", "exclude", "gate", "known_failure", "adapter"});
  study.cases = all_cases(alone, read_exclusions(document, study.axes), study);
  require_distinct(study);
  if (study.cases.empty()) {
    throw InputError(study.path + ": [[exclude]] leaves no case: expected at least one");
  }
  return study;
}

Study load_study(const std::string& path) {
  return read_study(TomlDocument::load(path));
}

}  // namespace porowave::verification
