#include "reference/column_solution.hpp"

#include <algorithm>
#include <limits>

#include "reference/time_slice.hpp"

namespace porowave::reference {

ColumnSolution::ColumnSolution(const Problem& problem)
    : problem_(problem), modes_(problem.material) {}

BoundedFields ColumnSolution::at(double x, double t) const {
  return TimeSlice(*this, t).at(x);
}

BoundedFields ColumnSolution::time_integral(double x, double t) const {
  return TimeSlice(*this, t, TimeIntegral::once).at(x);
}

std::vector<double> ColumnSolution::fronts(double t) const {
  std::vector<double> positions;
  const double length = problem_.column.length.value_or(std::numeric_limits<double>::infinity());
  for (const double x : {0.0, problem_.column.length.value_or(0.0)}) {
    for (const Ray& ray : rays_until(problem_, modes_, x, t)) {
      const double ahead = modes_.speed(ray.mode) * (t - ray.arrival);
      const double position = ray.upwards() ? x + ahead : x - ahead;
      // A ray seen at its start; those that started at the other end are found there.
      const bool starts_here = ray.upwards() == (x == 0.0);
      if (starts_here && position >= 0.0 && position <= length) positions.push_back(position);
    }
  }
  std::sort(positions.begin(), positions.end());
  positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
  return positions;
}

}  // namespace porowave::reference
