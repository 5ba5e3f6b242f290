#include "verification/grade/point_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "verification/not_a_number.hpp"

namespace porowave::verification {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t most_times = 1000;
/// Share of the length by which a rounded x may stand outside.
constexpr double rounding = 1e-9;

bool of_solid(std::size_t field) {
  return field == 0 || field == 2;
}

/// Where the quantities stand in a row.
struct Layout {
  std::size_t x = 0;
  std::optional<std::size_t> t, volume, phase, velocity;
  std::array<std::optional<std::size_t>, 4> fields;

  bool holds(std::size_t column) const {
    const auto is = [&](const std::optional<std::size_t>& place) { return place == column; };
    return column == x || is(t) || is(volume) || is(phase) || is(velocity) ||
           std::any_of(fields.begin(), fields.end(), is);
  }
};

/// A column that the user has named must be there.
std::optional<std::size_t> place_of(const CsvReader& reader, const ColumnNames& names,
                                    std::string_view quantity) {
  const auto named = names.find(quantity);
  if (named == names.end()) return reader.find(quantity);
  return reader.require(named->second, fmt::format("a column of that name for {}", quantity));
}

void require_one_velocity(const CsvReader& reader, const Layout& layout) {
  for (const std::size_t field : {2U, 3U}) {
    if (!layout.velocity || !layout.fields[field]) continue;
    reader.refuse_line(fmt::format("{} and {}", reader.columns()[*layout.velocity],
                                   reader.columns()[*layout.fields[field]]),
                       "a velocity only once");
  }
}

Layout layout_of(const CsvReader& reader, const PointReading& reading) {
  const auto place = [&](std::string_view quantity) {
    return place_of(reader, reading.names, quantity);
  };
  Layout layout;
  layout.phase = place("phase");
  if (layout.phase) layout.velocity = place("velocity");
  for (std::size_t f = 0; f < 4; ++f) layout.fields[f] = place(field_names[f]);
  require_one_velocity(reader, layout);
  const auto x = place("x");
  if (!x) reader.require("x", "a column x, m");
  layout.x = *x;
  layout.t = place("t");
  if (!layout.t && !reading.time) reader.require("t", "a column t, or --time T");
  if (layout.t && reading.time) reader.refuse_line("a column t and a given time", "one of the two");
  layout.volume = place("volume");
  const auto weight = reading.names.contains("volume") ? std::nullopt : reader.find("weight");
  if (layout.volume && weight) reader.refuse_line("volume and weight", "one of the two");
  if (weight) layout.volume = weight;
  const bool any = layout.velocity || std::any_of(layout.fields.begin(), layout.fields.end(),
                                                  [](const auto& f) { return f.has_value(); });
  if (!any) {
    reader.refuse_line("no field", fmt::format("a column {}", fmt::join(field_names, ", or ")));
  }
  return layout;
}

enum class RowPhase { both, solid, fluid };

RowPhase phase_of(const CsvReader& reader, const Layout& layout) {
  if (!layout.phase) return RowPhase::both;
  if (reader.cell(*layout.phase) == "solid") return RowPhase::solid;
  if (reader.cell(*layout.phase) == "fluid") return RowPhase::fluid;
  reader.refuse(*layout.phase, "solid or fluid");
}

double x_of(const CsvReader& reader, const Layout& layout, const std::optional<double>& length) {
  const double end = length.value_or(infinity);
  const double margin = length ? rounding * *length : 0.0;
  const double x = reader.number(layout.x);
  if (x < -margin || x > end + margin) {
    reader.refuse(layout.x, Range::between(0.0, end).text());
  }
  return std::clamp(x, 0.0, end);
}

/// The value of a field in this row; NaN if the row's phase has not the field.
double field_of(const CsvReader& reader, const Layout& layout, RowPhase phase, std::size_t field) {
  const bool has = phase == RowPhase::both || of_solid(field) == (phase == RowPhase::solid);
  const auto column = layout.fields[field];
  if (has) return reader.number(column ? *column : *layout.velocity);
  if (column && !reader.cell(*column).empty()) {
    reader.refuse(*column,
                  fmt::format("nothing in a row of the {}", of_solid(field) ? "fluid" : "solid"));
  }
  return nan;
}

void add_row(const CsvReader& reader, const Layout& layout, const PointReading& reading,
             PointProfile& profile) {
  const RowPhase phase = phase_of(reader, layout);
  profile.x.push_back(x_of(reader, layout, reading.length));
  profile.weight.push_back(layout.volume ? reader.number(*layout.volume, Range::positive()) : 1.0);
  for (std::size_t f = 0; f < 4; ++f) {
    if (!layout.fields[f] && !(layout.velocity && f >= 2)) continue;
    profile.fields[f].push_back(field_of(reader, layout, phase, f));
  }
}

}  // namespace

PointTable read_points(CsvReader& reader, const PointReading& reading) {
  const Layout layout = layout_of(reader, reading);
  PointTable table;
  table.has_volume = layout.volume.has_value();
  for (std::size_t i = 0; i < reader.columns().size(); ++i) {
    if (!layout.holds(i) && !reader.columns()[i].empty()) {
      table.ignored.push_back(reader.columns()[i]);
    }
  }
  std::map<double, PointProfile> profiles;
  while (reader.next()) {
    const double time =
        layout.t ? reader.number(*layout.t, Range::between(0.0, infinity)) : *reading.time;
    const auto [entry, fresh] = profiles.try_emplace(time);
    if (profiles.size() > most_times) {
      reader.refuse(*layout.t, fmt::format("at most {} different times", most_times));
    }
    if (fresh) entry->second.time = time;
    add_row(reader, layout, reading, entry->second);
  }
  if (profiles.empty()) reader.refuse_line("no rows", "at least one after the header");
  for (auto& [time, profile] : profiles) table.profiles.push_back(std::move(profile));
  return table;
}

}  // namespace porowave::verification
