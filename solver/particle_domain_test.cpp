#include "solver/particle_domain.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "solver/transfer_fixtures.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(particle_domain)

namespace {

using namespace test;

// A homogeneous deformation in two steps: l = l_0 F, F the product of both.
BOOST_AUTO_TEST_CASE(domains_are_stretched_by_the_deformation) {
  auto points = scattered<1>();
  const auto grid = test_grid<1>();
  const std::vector<double> first = noise(points.x.size(), 4, 0.01, 0.06);
  points.domain = first;
  Discretization choice = shape();
  choice.shape = shape_name<GimpShape<true>>;
  for (const double strain : {-0.02, 0.015}) {
    const Transfer<1> transfer(points, grid, choice);
    const auto u = sample<1>(nodes(grid), [&](const Vector<1>& x) { return strain * x[0]; });
    std::vector<double> moved(points.x.size());
    transfer.gradient_at_points(u, 0, moved);
    stretch_domains(moved, points.domain);
    transfer.to_points(u, moved);
    for (std::size_t p = 0; p < moved.size(); ++p) points.x[p][0] += moved[p];
  }
  for (std::size_t p = 0; p < first.size(); ++p) {
    BOOST_TEST(std::abs(points.domain[p] / first[p] - 0.98 * 1.015) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(a_domain_never_turns_inside_out) {
  auto points = regular<1>();
  points.domain.assign(points.x.size(), 1.0);
  stretch_domains(std::vector<double>(points.x.size(), -3.0), points.domain);
  for (const double edge : points.domain) BOOST_TEST(edge == 0.1);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
