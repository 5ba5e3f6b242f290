#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "reference/problem/problem.hpp"
#include "verification/grade/point_table.hpp"

namespace porowave::verification {

/// Errors at given points, in the order of field_names; none for a field without values.
using PointErrors = std::array<std::optional<Norms>, 4>;

/// Relative norms of the fields of points against the reference at the same time. The points must
/// lie within the profile.
PointErrors point_errors(const PointProfile& points, const reference::Profile& reference);

/// The judgement on the points of one time.
struct Grade {
  double time = 0.0;  ///< s
  std::size_t points = 0;
  PointErrors errors;
  /// Fields that are wrong as they are and nearly right with the other sign.
  std::array<bool, 4> opposite_sign{};
  double reference_error = 0.0;  ///< bound of the reference, relative to the load
};

/// Judges every profile of a table, in its order. Throws InputError if the reference cannot resolve
/// the problem at one of the times to 1e-6 of the load.
std::vector<Grade> grade(const Problem& problem, const PointTable& table);

/// For one time {"errors": {field: {"points": {"l1","l2","linf"}}}, "time", "points", "weights",
/// "reference_error"}; for several {"profiles": [such objects]}. Fields without values are left
/// out; a number that is not finite becomes null.
std::string grade_json(const std::vector<Grade>& grades, bool has_volume);

/// The errors as a table for people.
std::string grade_summary(const std::vector<Grade>& grades, const PointTable& table);

}  // namespace porowave::verification
