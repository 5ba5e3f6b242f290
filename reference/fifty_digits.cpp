#include "reference/fifty_digits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/digits/inversion.hpp"

namespace porowave::fixtures {

namespace {

using namespace digits;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double good_agreement = 1e-19;
constexpr double height_for_50_digits = 50.0;

FourReals scales(const Problem& problem) {
  const Real50 stress = std::abs(problem.stress_scale() / problem.load.magnitude());
  const Real50 velocity = std::abs(problem.velocity_scale() / problem.load.magnitude());
  return {stress, stress, velocity, velocity};
}

double difference(const Problem& problem, const FourReals& a, const FourReals& b) {
  const FourReals scale = scales(problem);
  double largest = 0.0;
  for (std::size_t f = 0; f < 4; ++f) {
    const double one = static_cast<double>(Real50(abs(Real50(a[f] - b[f])) / scale[f]));
    if (!(one <= largest)) largest = one;
  }
  return largest;
}

FourReals sum_of(const Point& point, const std::vector<Group>& groups, bool wide,
                 double refinement) {
  FourReals sum = {};
  for (const Group& group : groups) {
    const FourReals part = wide || group.contour.height > height_for_50_digits
                               ? invert<Real100>(point, group, refinement)
                               : invert<Real50>(point, group, refinement);
    for (std::size_t f = 0; f < 4; ++f) sum[f] += part[f];
  }
  return sum;
}

ExactFields result(const Problem& problem, const FourReals& unit, double agreement) {
  std::array<double, 4> value{};
  for (std::size_t f = 0; f < 4; ++f) {
    value[f] = static_cast<double>(Real50(unit[f] * problem.load.magnitude()));
  }
  return {{value[0], value[1], value[2], value[3]}, agreement};
}

ExactFields ricker(const Point& point) {
  const FourReals first = invert_ricker(point, 0);
  return result(point.problem, first, difference(point.problem, first, invert_ricker(point, 1)));
}

/// For one choice of where inner labels begin.
ExactFields by_images(const Point& point, double reach) {
  const auto arrivals = arrivals_of(point, reach);
  const auto first = plan(point, arrivals, 0);
  const auto second = plan(point, arrivals, 1);
  if (!first || !second) return {{}, infinity};
  ExactFields best{{}, infinity};
  for (const bool wide : {false, true}) {
    const double refinement = wide ? 1.7 : 1.0;
    const FourReals value = sum_of(point, *first, wide, refinement);
    const double agreement =
        difference(point.problem, value, sum_of(point, *second, wide, refinement));
    if (agreement < best.agreement) best = result(point.problem, value, agreement);
    if (best.agreement < good_agreement) break;
  }
  return best;
}

ExactFields by_images(const Point& point) {
  ExactFields best{{}, infinity};
  for (const double reach : {150.0, 400.0, 60.0, 1000.0}) {
    const ExactFields next = by_images(point, reach);
    if (next.agreement < best.agreement) best = next;
    if (best.agreement < good_agreement || !has_inner_labels(point.medium)) break;
  }
  return best;
}

}  // namespace

ExactFields fifty_digits(const Problem& problem, double x, double t) {
  const Medium<Real50> medium(problem.material);
  const double start =
      problem.load.shape() == LoadShape::table ? problem.load.times().front() : 0.0;
  const Real50 arrival = x / medium.speed[0] + start;
  if (t < 0.0 || arrival > Real50(t) * (1.0 + arrival_tolerance)) return {};
  // At t = 0 the front stands at x = 0; any time that is short against all others serves.
  const Point point{problem, medium, x, t > 0.0 ? t : 1e-30 / static_cast<double>(medium.rate)};
  return problem.load.shape() == LoadShape::ricker ? ricker(point) : by_images(point);
}

}  // namespace porowave::fixtures
