#include "solver/poor_place.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/problem/problem_fixtures.hpp"
#include "solver/placement.hpp"

BOOST_AUTO_TEST_SUITE(poor_place)

using namespace porowave;
using namespace porowave::solver;

namespace {

constexpr double h = 0.1 / 20;

Case scene_of(TransferName transfer, int points) {
  Case scene;
  scene.problem = fixtures::paper_problem();
  scene.discretization.elements = 20;
  scene.discretization.transfer = transfer;
  scene.discretization.kernel = kernel_name<BSpline1>;
  scene.discretization.support_radius = 1.0;
  scene.discretization.points_per_element = points;
  scene.time.end = 1e-5;
  return scene;
}

}  // namespace

BOOST_AUTO_TEST_CASE(regular_points_are_nowhere_poor) {
  for (const TransferName transfer : {TransferName::shape, TransferName::mls, TransferName::apic}) {
    for (const double x : {0.0, 0.05, 0.1}) {
      BOOST_TEST(solver::poor_place(scene_of(transfer, 4), x, 3.0 * h) == "");
    }
  }
}

// With a support of 0.6 h the middle of a cell has its own point and no other.
BOOST_AUTO_TEST_CASE(a_moment_matrix_of_one_point_carries_order_nought) {
  Case scene = scene_of(TransferName::mls, 1);
  scene.discretization.support_radius = 0.6;
  const std::string words = solver::poor_place(scene, 10.5 * h, 0.1 * h);
  BOOST_TEST(words == " (the solid points around x = 0.0525 m carry order 0 of 1)");
  scene.discretization.basis_order = 0;
  BOOST_TEST(solver::poor_place(scene, 10.5 * h, 0.1 * h) == "");
}

// The nearest points are 0.5 h + h/8 from the middle of the empty element.
BOOST_AUTO_TEST_CASE(an_empty_element_is_out_of_reach_of_a_small_support) {
  Case scene = scene_of(TransferName::mls, 4);
  scene.discretization.empty_elements = {10.5 * h};
  scene.discretization.basis_order = 0;
  scene.discretization.support_radius = 0.62;
  BOOST_TEST(solver::poor_place(scene, 11.5 * h, 1.1 * h) ==
             " (no solid point is within reach of x = 0.0525 m)");
  BOOST_TEST(solver::poor_place(scene, 11.5 * h, 0.9 * h) == "");
  scene.discretization.support_radius = 0.63;
  BOOST_TEST(solver::poor_place(scene, 11.5 * h, 1.1 * h) == "");
}

// Two points of volume h/2 a cell: a node's mass in units of its full one is half the sum of 1 − |x
// − x_i|/h.
BOOST_AUTO_TEST_CASE(a_light_node_is_named_with_its_share) {
  Case scene = scene_of(TransferName::shape, 2);
  scene.discretization.placement = Placement::stratified;
  int light = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    scene.discretization.seed = seed;
    for (int i = 1; i < 20; ++i) {
      double smallest = 1.0;
      for (const Phase phase : {Phase::solid, Phase::fluid}) {
        double share = 0.0;
        for (const double x : place_points(scene.discretization, h, phase).x) {
          share += 0.5 * std::max(0.0, 1.0 - std::abs(x - i * h) / h);
        }
        smallest = std::min(smallest, share);
      }
      const std::string words = solver::poor_place(scene, i * h, 0.1 * h);
      if (smallest > 0.46) {
        BOOST_TEST(words == "");
      } else if (smallest < 0.44) {
        ++light;
        const auto has = words.find(" has ");
        BOOST_REQUIRE(has != std::string::npos);
        BOOST_TEST(std::stod(words.substr(has + 5)) == smallest,
                   boost::test_tools::tolerance(0.051));
      }
    }
  }
  BOOST_TEST(light > 2);
}

BOOST_AUTO_TEST_SUITE_END()
