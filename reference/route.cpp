#include "reference/route.hpp"

#include "reference/bromwich.hpp"
#include "reference/column_solution.hpp"
#include "reference/modal.hpp"

namespace porowave::reference {

namespace {

template <class Solution>
std::vector<BoundedFields> at_every(const std::vector<double>& points, Solution&& at) {
  std::vector<BoundedFields> fields;
  fields.reserve(points.size());
  for (const double x : points) fields.push_back(at(x));
  return fields;
}

}  // namespace

Route route(Method method, const Problem& problem) {
  using Points = std::vector<double>;
  Route result{std::string(name(method)), "", nullptr};
  switch (method) {
    case Method::contour:
      result.fields = [solution = ColumnSolution(problem)](const Points& points, double t) {
        return at_every(points, [&](double x) { return solution.at(x, t); });
      };
      break;
    case Method::bromwich:
      result.fields = [solution = BromwichSolution(problem)](const Points& points, double t) {
        return at_every(points, [&](double x) { return solution.at(x, t); });
      };
      break;
    case Method::modal:
      result.obstacle = ModalSolution::obstacle(problem);
      result.fields = [problem](const Points& points, double t) {
        const ModalSolution solution(problem, t);
        return at_every(points, [&](double x) { return solution.at(x); });
      };
      break;
  }
  return result;
}

}  // namespace porowave::reference
