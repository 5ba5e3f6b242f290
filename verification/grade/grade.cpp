#include "verification/grade/grade.hpp"

#include <algorithm>
#include <cmath>

#include "verification/run.hpp"

namespace porowave::verification {

namespace {

/// The rows that have a value of one field.
struct Samples {
  std::vector<double> x;
  std::vector<double> value;
  std::vector<double> weight;
};

Samples samples_of(const PointProfile& points, std::size_t field) {
  Samples samples;
  const std::vector<double>& values = points.fields[field];
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) continue;
    samples.x.push_back(points.x[i]);
    samples.value.push_back(values[i]);
    samples.weight.push_back(points.weight[i]);
  }
  return samples;
}

/// With the other sign, an error above 1.5 would be below 0.5.
bool has_opposite_sign(const PointProfile& points, const reference::Profile& reference,
                       std::size_t field, const Norms& norms) {
  if (!(norms.l1 > 1.5)) return false;
  Samples samples = samples_of(points, field);
  for (double& value : samples.value) value = -value;
  return compare_at(reference, field, samples.x, samples.value, samples.weight).l1 < 0.5;
}

}  // namespace

PointErrors point_errors(const PointProfile& points, const reference::Profile& reference) {
  PointErrors errors;
  for (std::size_t f = 0; f < errors.size(); ++f) {
    const Samples samples = samples_of(points, f);
    if (samples.x.empty()) continue;
    errors[f] = compare_at(reference, f, samples.x, samples.value, samples.weight);
  }
  return errors;
}

std::vector<Grade> grade(const Problem& problem, const PointTable& table) {
  std::vector<Grade> grades;
  for (const PointProfile& points : table.profiles) {
    const double farthest = *std::max_element(points.x.begin(), points.x.end());
    const double end = problem.column.length.value_or(farthest);
    const auto reference = reference_profile(problem, points.time, end);
    Grade& one = grades.emplace_back();
    one.time = points.time;
    one.points = points.x.size();
    one.errors = point_errors(points, *reference);
    one.reference_error = reference->error();
    for (std::size_t f = 0; f < one.errors.size(); ++f) {
      one.opposite_sign[f] =
          one.errors[f] && has_opposite_sign(points, *reference, f, *one.errors[f]);
    }
  }
  return grades;
}

}  // namespace porowave::verification
