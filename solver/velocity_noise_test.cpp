#include "solver/velocity_noise.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "solver/transfer_fixtures.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(velocity_noise)

namespace {

using namespace test;

std::vector<double> without_noise(const Transfer<1>& transfer, int order, std::vector<double> v) {
  remove_velocity_noise(transfer, order, at_nodes(transfer, v), v);
  return v;
}

std::vector<Discretization> some_choices() {
  return {shape(), mls<BSpline2>(1.5, 1), mls<WendlandC2>(2.0, 1)};
}

// S S⁺ V
std::vector<double> seen(const Transfer<1>& transfer, const std::vector<double>& v) {
  std::vector<double> values(v.size());
  transfer.to_points(at_nodes(transfer, v), values);
  return values;
}

BOOST_AUTO_TEST_CASE(order_one_is_pic) {
  for_all<1>(
      some_choices(), [](const auto& transfer, const auto& points, const auto&, const auto&) {
        const auto v = noise(points.x.size(), 6);
        BOOST_TEST(largest_difference(without_noise(transfer, 1, v), seen(transfer, v)) < 1e-14);
      });
}

// I − (I − S S⁺)^m, from its definition for m = 2: 2 S S⁺ − (S S⁺)².
BOOST_AUTO_TEST_CASE(order_two_by_its_definition) {
  for_all<1>(some_choices(),
             [](const auto& transfer, const auto& points, const auto&, const auto&) {
               const auto v = noise(points.x.size(), 6);
               const auto once = seen(transfer, v);
               const auto twice = seen(transfer, once);
               const auto result = without_noise(transfer, 2, v);
               for (std::size_t p = 0; p < v.size(); ++p) {
                 BOOST_TEST(std::abs(result[p] - (2.0 * once[p] - twice[p])) < 1e-13);
               }
             });
}

// Of what the nodes can represent less is lost with every order; the rest goes at once.
BOOST_AUTO_TEST_CASE(higher_orders_keep_the_wave_and_remove_the_noise) {
  for_all<1>(some_choices(), [](const auto& transfer, const auto& points, const auto& grid,
                                const auto&) {
    std::vector<double> wave(points.x.size());
    const double length = grid.cells[0] * grid.spacing;
    transfer.to_points(sample<1>(nodes(grid),
                                 [&](const Vector<1>& x) {
                                   return std::cos(2.0 * M_PI * (x[0] - grid.origin[0]) / length);
                                 }),
                       wave);
    double last = 1.0;
    for (const int order : {1, 2, 3, 5, 8}) {
      const double lost = largest_difference(without_noise(transfer, order, wave), wave);
      BOOST_TEST(lost < 0.8 * last);
      last = lost;
    }
    BOOST_TEST(last < 0.02);
    // Noise: what one more pass through the nodes does not see any more.
    auto v = noise(points.x.size(), 6);
    for (int pass = 0; pass < 400; ++pass) {
      const auto part = seen(transfer, v);
      for (std::size_t p = 0; p < v.size(); ++p) v[p] -= part[p];
    }
    const auto rest = without_noise(transfer, 2, v);
    BOOST_TEST(dot(rest, rest) < 1e-2 * dot(v, v));
  });
}

BOOST_AUTO_TEST_CASE(with_shape_functions_momentum_stays) {
  auto points = scattered<1>();
  points.mass = noise(points.x.size(), 3, 0.1, 2.0);
  const Transfer<1> transfer(points, test_grid<1>(), shape());
  const auto v = noise(points.x.size(), 6);
  for (int order = 1; order <= 5; ++order) {
    BOOST_TEST(std::abs(dot(points.mass, without_noise(transfer, order, v)) - dot(points.mass, v)) <
               1e-13 * sum(points.mass));
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
