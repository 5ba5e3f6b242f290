#include <fmt/format.h>

#include <algorithm>

#include "verification/gate/gate.hpp"

namespace porowave::verification {

namespace {

GateRules::KnownFailure read_known_failure(TomlSection& section, const Study& study) {
  GateRules::KnownFailure known;
  for (const std::string& key : section.keys()) {
    if (key == "reason") continue;
    const auto axis = std::find_if(study.axes.begin(), study.axes.end(),
                                   [&](const Axis& a) { return a.name() == key; });
    const auto index = static_cast<std::size_t>(axis - study.axes.begin());
    if (axis == study.axes.end() || index == study.refine || index == study.seed) {
      section.refuse(key, "an axis of [axes] other than those of levels and seeds");
    }
    const auto value = section.value_if(key);
    if (!value || std::none_of(axis->values.begin(), axis->values.end(),
                               [&](const TomlValue& v) { return same_value(v, *value); })) {
      section.refuse(key, "a value that the axis has");
    }
    known.where.emplace_back(index, *value);
  }
  known.reason = section.text("reason");
  section.done();
  return known;
}

}  // namespace

GateRules read_gate_rules(const TomlDocument& document, const Study& study) {
  GateRules rules;
  TomlSection section = document.section("gate");
  const std::vector<std::string> all = measure_names();
  if (section.has("measures")) {
    for (const TomlValue& value : section.values("measures")) {
      const auto* name = std::get_if<std::string>(&value.value);
      const auto measure = name ? measure_index(*name) : std::nullopt;
      if (!measure) {
        section.refuse("measures",
                       fmt::format("names of errors: {}", suggestion(name ? *name : "", all)));
      }
      rules.measures.push_back(*measure);
    }
  } else {
    for (std::size_t m = 0; m < all.size(); ++m) {
      if (all[m].ends_with(study.adapter ? "_points_l2" : "_l2")) rules.measures.push_back(m);
    }
  }
  rules.order = section.number_if("order", {});
  rules.order_tolerance = section.number_or("order_tolerance", 0.25, Range::positive());
  rules.error_tolerance = section.number_or("error_tolerance", 0.01, Range::positive());
  rules.cost_tolerance = section.number_if("cost_tolerance", Range::positive());
  section.done();
  for (TomlSection& known : document.sections("known_failure")) {
    rules.known_failures.push_back(read_known_failure(known, study));
  }
  return rules;
}

}  // namespace porowave::verification
