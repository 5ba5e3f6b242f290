#include "reports/stability_map_figure.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace porowave::reports {

namespace {

using verification::Axis;
using verification::plain_text;

/// How many of the first axes go down: as many as keep the rows fewer than the columns.
std::size_t axes_down(const std::vector<Axis>& axes) {
  std::size_t across = 1;
  for (const Axis& axis : axes) across *= axis.values.size();
  std::size_t down = 1;
  std::size_t count = 0;
  while (count + 1 < axes.size() &&
         down * axes[count].values.size() <= across / axes[count].values.size()) {
    down *= axes[count].values.size();
    across /= axes[count].values.size();
    ++count;
  }
  return count;
}

/// Place among all combinations of the axes [first, last), the last one fastest.
std::size_t place_of(const verification::Study& study, const verification::StudyCase& one,
                     std::size_t first, std::size_t last) {
  std::size_t place = 0;
  for (std::size_t a = first; a < last; ++a) {
    const auto& values = study.axes[a].values;
    const auto value = std::find_if(values.begin(), values.end(), [&](const TomlValue& v) {
      return same_value(v, one.coordinates[a]);
    });
    place = place * values.size() + static_cast<std::size_t>(value - values.begin());
  }
  return place;
}

/// One word for gnuplot.
std::string word(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == ' ' || c == '\n' || c == '\t' ? std::string("\u00a0") : std::string(1, c);
  return result.empty() ? "-" : result;
}

/// As short as can be: 2.2e7 and not 22000000.0.
std::string short_text(const TomlValue& value) {
  const auto* number = std::get_if<double>(&value.value);
  if (number == nullptr) return plain_text(value);
  std::string text = fmt::format("{:g}", *number);
  const auto e = text.find('e');
  while (e != std::string::npos && (text[e + 1] == '+' || text[e + 1] == '0')) text.erase(e + 1, 1);
  if (e != std::string::npos && text[e + 1] == '-' && text[e + 2] == '0') text.erase(e + 2, 1);
  return text;
}

/// Labels of the axes [first, last) as words, three each: centre, line, text. Line 1 is that of the
/// slowest axis.
std::string labels(const std::vector<Axis>& axes, std::size_t first, std::size_t last) {
  std::size_t span = 1;
  for (std::size_t a = first; a < last; ++a) span *= axes[a].values.size();
  std::string words;
  std::size_t repeats = 1;
  for (std::size_t a = first; a < last; ++a) {
    const std::size_t count = axes[a].values.size();
    span /= count;
    for (std::size_t k = 0; k < repeats * count; ++k) {
      const double centre = (static_cast<double>(k) + 0.5) * static_cast<double>(span) - 0.5;
      words += fmt::format("{:#} {} {} ", centre, a - first + 1,
                           word(short_text(axes[a].values[k % count])));
    }
    repeats *= count;
  }
  return words;
}

std::string names_of(const std::vector<Axis>& axes, std::size_t first, std::size_t last) {
  std::string names;
  for (std::size_t a = first; a < last; ++a) {
    names += fmt::format("{}{}", names.empty() ? "" : ", then ", axes[a].key);
  }
  return names;
}

}  // namespace

Figure stability_map_figure(const verification::Study& study,
                            const std::vector<verification::MappedStability>& map) {
  const std::size_t down = axes_down(study.axes);
  const std::size_t all = study.axes.size();
  std::string colours = "# column, row, critical courant (-1: refused)\n";
  std::string dots = "# column, row of cases with unstable steps below the critical one\n-9 -9\n";
  std::size_t rows = 1, columns = 1;
  for (std::size_t a = 0; a < down; ++a) rows *= study.axes[a].values.size();
  for (std::size_t a = down; a < all; ++a) columns *= study.axes[a].values.size();
  for (std::size_t i = 0; i < map.size(); ++i) {
    const std::size_t row = place_of(study, study.cases[i], 0, down);
    const std::size_t column = place_of(study, study.cases[i], down, all);
    const bool refused = !map[i].refused.empty();
    colours += fmt::format("{} {} {:.4f}\n", column, row, refused ? -1.0 : map[i].critical.courant);
    if (!refused && !map[i].critical.unstable_below().empty()) {
      dots += fmt::format("{} {}\n", column, row);
    }
  }
  Figure figure{"stability_map", "stability_map", {}, colours};
  figure.data += "\n\n" + dots;
  const auto text = [&](const char* variable, const std::string& value) {
    figure.texts.emplace_back(variable, value);
  };
  text("caption", fmt::format("Critical courant of the {} cases of {}", map.size(), study.name));
  text("rows", std::to_string(rows));
  text("columns", std::to_string(columns));
  text("row_lines", std::to_string(down));
  text("column_lines", std::to_string(all - down));
  text("row_labels", labels(study.axes, 0, down));
  text("column_labels", labels(study.axes, down, all));
  text("row_names", names_of(study.axes, 0, down));
  text("column_names", names_of(study.axes, down, all));
  return figure;
}

}  // namespace porowave::reports
