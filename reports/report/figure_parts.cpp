#include "reports/report/figure_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

namespace porowave::reports {

namespace {

/// More curves than this cannot be told apart.
constexpr std::size_t most_curves = 16;

bool numeric(const TableAxis& axis) {
  return std::all_of(axis.values.begin(), axis.values.end(), [](const std::string& value) {
    char* end = nullptr;
    std::strtod(value.c_str(), &end);
    return !value.empty() && *end == '\0';
  });
}

}  // namespace

FigureAxes figure_axes(const StudyTable& table) {
  std::vector<std::size_t> left;
  for (std::size_t a = 0; a < table.axes.size(); ++a) left.push_back(a);
  const auto of_method = [&](std::size_t a) { return !table.axes[a].of_problem; };
  const bool methods = std::any_of(left.begin(), left.end(), of_method);
  const auto take = [&](auto better) -> std::optional<std::size_t> {
    auto best = left.end();
    for (auto a = left.begin(); a != left.end(); ++a) {
      if (methods && !of_method(*a)) continue;
      if (best == left.end() || better(table.axes[*a], table.axes[*best])) best = a;
    }
    if (best == left.end()) return std::nullopt;
    const std::size_t axis = *best;
    left.erase(best);
    return axis;
  };
  const auto weight = [](const TableAxis& axis) {
    return axis.values.size() > most_curves ? std::size_t{1} : axis.values.size();
  };
  FigureAxes axes;
  axes.curve = take([&](const TableAxis& a, const TableAxis& b) {
    return std::pair(weight(a), !numeric(a)) > std::pair(weight(b), !numeric(b));
  });
  axes.panel = take([&](const TableAxis& a, const TableAxis& b) {
    return std::pair(numeric(a), weight(a)) > std::pair(numeric(b), weight(b));
  });
  axes.rest = left;
  return axes;
}

std::vector<FigurePart> parts_of(const StudyTable& table, const std::vector<std::size_t>& axes) {
  std::map<std::vector<std::size_t>, FigurePart> parts;
  for (std::size_t g = 0; g < table.groups.size(); ++g) {
    std::vector<std::size_t> at;
    at.reserve(axes.size());
    for (const std::size_t a : axes) at.push_back(table.groups[g].at[a]);
    FigurePart& part = parts[at];
    part.at = at;
    part.groups.push_back(g);
  }
  std::vector<FigurePart> result;
  result.reserve(parts.size());
  for (auto& [at, part] : parts) result.push_back(std::move(part));
  return result;
}

std::vector<std::size_t> problem_axes(const StudyTable& table) {
  std::vector<std::size_t> axes;
  for (std::size_t a = 0; a < table.axes.size(); ++a) {
    if (table.axes[a].of_problem) axes.push_back(a);
  }
  return axes;
}

std::string described(const StudyTable& table, const std::vector<std::size_t>& axes,
                      const std::vector<std::size_t>& at) {
  std::string text;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    text += fmt::format("{}{} = {}", i == 0 ? "" : ", ", table.axes[axes[i]].title,
                        table.axes[axes[i]].values[at[i]]);
  }
  return text;
}

std::string name_on(const StudyTable& table, const std::vector<std::size_t>& axes,
                    const TableGroup& group) {
  std::vector<std::size_t> at;
  at.reserve(axes.size());
  for (const std::size_t a : axes) at.push_back(group.at[a]);
  return axes.empty() ? "all cases" : described(table, axes, at);
}

std::string method_name(const StudyTable& table, std::size_t group, std::size_t level) {
  std::string name;
  for (std::size_t a = 0; a < table.axes.size(); ++a) {
    if (table.axes[a].of_problem) continue;
    const std::string value = table.value(table.groups[group], a);
    const bool word = !value.empty() && std::isalpha(static_cast<unsigned char>(value[0])) != 0;
    name += fmt::format("{}{}", name.empty() ? "" : ", ",
                        word ? value : table.axes[a].title + " " + value);
  }
  const std::string& text = table.groups[group].levels[level].text;
  if (text.empty()) return name;
  const std::string key = table.refined_by.substr(table.refined_by.rfind('.') + 1);
  return fmt::format("{}{}{} {}", name, name.empty() ? "" : ", ", text, key);
}

std::size_t place_on(const TableGroup& group, std::optional<std::size_t> axis) {
  return axis ? group.at[*axis] : 0;
}

std::size_t size_of(const StudyTable& table, std::optional<std::size_t> axis) {
  return axis ? table.axes[*axis].values.size() : 1;
}

std::string value_on(const StudyTable& table, std::optional<std::size_t> axis, std::size_t value) {
  return axis ? table.axes[*axis].values[value] : std::string();
}

std::string real_text(double value) {
  return fmt::format("{:#.6g}", value);
}

void PositiveRange::see(double value) {
  if (!(value > 0.0) || !std::isfinite(value)) return;
  low = empty() ? value : std::min(low, value);
  high = std::max(high, value);
}

std::size_t most_seeds(const std::vector<GroupSummary>& summaries,
                       const std::vector<std::size_t>& groups) {
  std::size_t most = 0;
  for (const std::size_t g : groups) {
    for (const LevelSummary& level : summaries[g].levels) most = std::max(most, level.cases);
  }
  return most;
}

std::optional<std::size_t> extreme_group(const std::vector<GroupSummary>& summaries,
                                         const std::vector<std::size_t>& groups, bool worst) {
  std::optional<std::size_t> found;
  for (const std::size_t g : groups) {
    const double error = summaries[g].finest_error();
    if (std::isnan(error)) continue;
    const bool further = !found || (worst ? error > summaries[*found].finest_error()
                                          : error < summaries[*found].finest_error());
    if (further) found = g;
  }
  return found;
}

void add_text(Figure& figure, const std::string& variable, const std::string& value) {
  figure.texts.emplace_back(variable, value);
}

}  // namespace porowave::reports
