#include <fmt/format.h>

#include "verification/grade/grade.hpp"
#include "verification/norms_json.hpp"

namespace porowave::verification {

namespace {

Json one_json(const Grade& grade, bool has_volume) {
  Json errors = Json::object();
  for (std::size_t f = 0; f < field_names.size(); ++f) {
    if (!grade.errors[f]) continue;
    errors[std::string(field_names[f])] = {{"points", norms_json(*grade.errors[f])}};
  }
  return {{"errors", errors},
          {"time", grade.time},
          {"points", grade.points},
          {"weights", has_volume ? "volume" : "equal"},
          {"reference_error", number(grade.reference_error)}};
}

std::string cell(double error) {
  if (std::isnan(error)) return fmt::format("{:>12}", "none");
  return error >= 1e-3 && error < 1e4 ? fmt::format("{:>12.4f}", error)
                                      : fmt::format("{:>12.3e}", error);
}

std::string one_summary(const Grade& grade, bool has_volume) {
  std::string text =
      fmt::format("{} points at t = {:g} s, {}\n{:<18}{:>12}{:>12}{:>12}\n", grade.points,
                  grade.time, has_volume ? "weighted by their volume" : "equal weights",
                  "relative error", "l1", "l2", "linf");
  bool undefined = false;
  for (std::size_t f = 0; f < field_names.size(); ++f) {
    const auto& error = grade.errors[f];
    if (!error) continue;
    text += fmt::format("{:<18}{}{}{}\n", field_names[f], cell(error->l1), cell(error->l2),
                        cell(error->linf));
    undefined = undefined || std::isnan(error->l1);
  }
  if (undefined) text += "none: the exact field is zero at all points\n";
  for (std::size_t f = 0; f < field_names.size(); ++f) {
    if (!grade.opposite_sign[f]) continue;
    text += fmt::format(
        "{}: right with the other sign? Stress is positive in tension, pressure "
        "in compression, x and velocities point away from the loaded end\n",
        field_names[f]);
  }
  return text;
}

}  // namespace

std::string grade_json(const std::vector<Grade>& grades, bool has_volume) {
  if (grades.size() == 1) return one_json(grades.front(), has_volume).dump(2) + "\n";
  Json json;
  json["profiles"] = Json::array();
  for (const Grade& grade : grades) json["profiles"].push_back(one_json(grade, has_volume));
  return json.dump(2) + "\n";
}

std::string grade_summary(const std::vector<Grade>& grades, const PointTable& table) {
  std::string text;
  for (const Grade& grade : grades) text += one_summary(grade, table.has_volume);
  if (!table.ignored.empty()) {
    text += fmt::format("columns not used: {}\n", fmt::join(table.ignored, ", "));
  }
  return text;
}

}  // namespace porowave::verification
