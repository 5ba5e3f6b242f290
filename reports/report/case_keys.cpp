#include "reports/report/case_keys.hpp"

#include <algorithm>
#include <cstdlib>

#include "reference/problem/toml_document.hpp"

namespace porowave::reports {

CaseKeys case_keys(const std::string& specification, const std::string& name) {
  const TomlDocument document = TomlDocument::parse(specification, name);
  CaseKeys keys;
  for (const char* table : {"material", "column", "load", "discretization", "time", "adapter"}) {
    TomlSection section = document.section(table);
    if (!section.present()) continue;
    for (const std::string& key : section.keys()) {
      if (auto value = section.value_if(key)) keys[std::string(table) + "." + key] = *value;
    }
  }
  return keys;
}

std::string shown(const TomlValue& value) {
  if (const auto* text = std::get_if<std::string>(&value.value)) return *text;
  return value.text();
}

bool is_of_problem(const std::string& key) {
  if (key == "discretization.empty_elements" || key == "time.end") return true;
  return key.starts_with("material.") || key.starts_with("column.") || key.starts_with("load.");
}

std::string short_name(const std::string& key) {
  return key.substr(key.rfind('.') + 1);
}

std::vector<std::string> in_natural_order(std::vector<std::string> texts) {
  const auto before = [](const std::string& a, const std::string& b) {
    char* end_a = nullptr;
    char* end_b = nullptr;
    const double number_a = std::strtod(a.c_str(), &end_a);
    const double number_b = std::strtod(b.c_str(), &end_b);
    const bool numeric_a = !a.empty() && *end_a == '\0';
    const bool numeric_b = !b.empty() && *end_b == '\0';
    if (numeric_a != numeric_b) return numeric_a;
    return numeric_a && number_a != number_b ? number_a < number_b : a < b;
  };
  std::sort(texts.begin(), texts.end(), before);
  texts.erase(std::unique(texts.begin(), texts.end()), texts.end());
  return texts;
}

}  // namespace porowave::reports
