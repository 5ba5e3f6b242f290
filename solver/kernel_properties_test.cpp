// What holds for every kernel, radius and set of points, however they lie: RapidCheck looks for a
// set that breaks it and makes it small. RC_PARAMS="max_success=100000" tries that many sets.

#include <rapidcheck/boost_test.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "solver/mls.hpp"

BOOST_AUTO_TEST_SUITE(kernel_properties)

using namespace porowave::solver;

namespace {

constexpr double rounding = 1e-15;
constexpr int order_asked = 3;

using Line = std::vector<Vector<1>>;

// A multiple of 2^-20 in [low, high]: sums and differences of a few are exact. Often a multiple of
// a quarter, where points coincide and lie on knots, nodes and the edge of the support.
double place(int low, int high) {
  if (*rc::gen::inRange(0, 2) == 0) return *rc::gen::inRange(4 * low, 4 * high + 1) / 4.0;
  return *rc::gen::inRange(low << 20, (high << 20) + 1) * 0x1p-20;
}

KernelName any_kernel() {
  return KernelName{static_cast<std::size_t>(*rc::gen::inRange(0, int{kernel_count}))};
}

Line any_points() {
  Line points(static_cast<std::size_t>(*rc::gen::inRange(0, 24)));
  for (auto& x : points) x[0] = place(0, 6);
  return points;
}

struct Evaluation {
  std::vector<double> phi;
  MlsResult result;
};

Evaluation evaluate(KernelName kernel, double radius, double x, const Line& points) {
  Evaluation e{std::vector<double>(points.size()), {}};
  visit_kernel(kernel, [&](auto k) {
    const MovingLeastSquares<decltype(k), 1, order_asked> mls(radius);
    e.result = mls.evaluate(Vector<1>(x), points, e.phi);
  });
  return e;
}

double kernel_value(KernelName kernel, double offset, double radius) {
  return visit_kernel(
      kernel, [&](auto k) { return weight_value<decltype(k), 1>(Vector<1>(offset), radius); });
}

}  // namespace

RC_BOOST_PROP(a_kernel_is_even_falls_and_ends_at_its_support, ()) {
  const auto kernel = any_kernel();
  const double radius = 0.25 + place(0, 5);
  const double r = place(0, 6);
  const double further = r + place(0, 2);
  const double value = kernel_value(kernel, r, radius);
  RC_ASSERT(value == kernel_value(kernel, -r, radius));
  RC_ASSERT(value >= 0.0);
  RC_ASSERT(kernel_value(kernel, further, radius) <= value * (1.0 + rounding));
  RC_ASSERT((value > 0.0) == (r < radius) || value < 1e-20);  // high powers of the distance left
}

RC_BOOST_PROP(moving_least_squares_reproduce_the_degree_they_say, ()) {
  const auto kernel = any_kernel();
  const double radius = 0.25 + place(0, 5);
  const double x = place(0, 6);
  const Line points = any_points();
  const auto [phi, result] = evaluate(kernel, radius, x, points);
  double weights = 0.0;
  for (const auto& p : points) weights += kernel_value(kernel, p[0] - x, radius);
  RC_ASSERT((result.order_used >= 0) == (weights > 0.0));
  RC_CLASSIFY(result.order_used == order_asked);
  RC_CLASSIFY(result.order_used >= 0 && result.order_used < order_asked, "of lower degree");
  for (int degree = 0; degree <= result.order_used; ++degree) {
    double sum = 0.0;
    double size = 1.0;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const double monomial = std::pow((points[p][0] - x) / radius, degree);
      sum += phi[p] * monomial;
      size = std::max(size, std::abs(phi[p]));
    }
    RC_ASSERT(std::abs(sum - (degree == 0 ? 1.0 : 0.0)) <=
              100 * rounding * size * result.condition);
  }
}

RC_BOOST_PROP(points_all_around_carry_the_degree_asked_for, ()) {
  const auto kernel = any_kernel();
  const double radius = 0.25 + place(0, 5);
  const double x = place(0, 6);
  const double first = *rc::gen::inRange(0, 1000) / 1000.0 - 8.0;
  Line points;
  for (int k = 0; k < 16; ++k) points.push_back(Vector<1>(x + (first + k) * radius / 6.0));
  RC_ASSERT(evaluate(kernel, radius, x, points).result.order_used == order_asked);
}

RC_BOOST_PROP(points_beyond_the_support_change_nothing, ()) {
  const auto kernel = any_kernel();
  const double radius = 0.25 + place(0, 5);
  const double x = place(0, 6);
  Line points = any_points();
  const auto before = evaluate(kernel, radius, x, points);
  const double beyond = radius + place(0, 3);
  points.insert(points.begin(), Vector<1>(x - beyond));
  points.push_back(Vector<1>(x + beyond));
  const auto after = evaluate(kernel, radius, x, points);
  RC_ASSERT(after.result.order_used == before.result.order_used);
  RC_ASSERT(after.phi.front() == 0.0 && after.phi.back() == 0.0);
  RC_ASSERT(std::equal(before.phi.begin(), before.phi.end(), after.phi.begin() + 1));
}

RC_BOOST_PROP(a_column_moved_and_stretched_has_the_same_weights, ()) {
  const auto kernel = any_kernel();
  const double radius = 0.25 + place(0, 5);
  const double x = place(0, 6);
  const Line points = any_points();
  const double shift = place(-4, 4);
  const double stretch = std::ldexp(1.0, *rc::gen::inRange(-30, 31));  // exact, like the shift
  Line moved;
  for (const auto& p : points) moved.push_back(Vector<1>((p[0] + shift) * stretch));
  const auto here = evaluate(kernel, radius, x, points);
  const auto there = evaluate(kernel, radius * stretch, (x + shift) * stretch, moved);
  RC_ASSERT(here.result.order_used == there.result.order_used);
  RC_ASSERT(here.phi == there.phi);
}

BOOST_AUTO_TEST_SUITE_END()
