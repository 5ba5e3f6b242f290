#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reference/problem/csv_reader.hpp"
#include "verification/field_errors.hpp"

namespace porowave::verification {

/// What a column of points may hold: x (m), t (s), volume (any unit; the weight of a row), phase
/// ("solid" or "fluid"), velocity (m/s, of the row's phase), and the four fields.
inline constexpr std::array<std::string_view, 9> point_quantities = {"x",
                                                                     "t",
                                                                     "volume",
                                                                     "phase",
                                                                     "velocity",
                                                                     "effective_stress",
                                                                     "pore_pressure",
                                                                     "solid_velocity",
                                                                     "fluid_velocity"};

/// Names of columns where they are not those of the quantities: {"effective_stress", "sigma"}.
using ColumnNames = std::map<std::string, std::string, std::less<>>;

/// Points of one time. Vectors have one entry a row.
struct PointProfile {
  double time = 0.0;           ///< s
  std::vector<double> x;       ///< m
  std::vector<double> weight;  ///< > 0; 1 without volumes
  /// In the order of field_names; NaN where the row's phase has not the field, empty without
  /// column.
  std::array<std::vector<double>, 4> fields;
};

struct PointTable {
  std::vector<PointProfile> profiles;  ///< ascending in time, at least one, none without rows
  bool has_volume = false;
  std::vector<std::string> ignored;  ///< names of columns that hold nothing known
};

struct PointReading {
  ColumnNames names = {};
  std::optional<double> time = {};    ///< s, of all rows of a file without t
  std::optional<double> length = {};  ///< of the column, m; none for a half-space
};

/// Reads points with x, t (unless a time is given) and at least one field. A column of volumes may
/// be called volume or weight. With a column `phase` (as written by `porowave solve`) a row has
/// only the fields of its phase, the others are empty; `velocity` then stands for both velocities.
///
/// Values must be finite, 0 <= x <= length (up to 1e-9 of it), t >= 0 (at most 1,000 different
/// ones), volume > 0. Throws InputError with file, line, column and value.
PointTable read_points(CsvReader& reader, const PointReading& reading);

}  // namespace porowave::verification
