#include "verification/faults/plain_column.hpp"

#include <boost/test/unit_test.hpp>

#include "verification/paper_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(plain_column)

using namespace porowave;
using namespace porowave::verification;
using namespace porowave::verification::faults;

namespace {

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  BOOST_REQUIRE(a.size() == b.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace

BOOST_AUTO_TEST_CASE(with_all_its_pieces_right_it_is_the_solver) {
  for (const auto transfer : {solver::TransferName::mls, solver::TransferName::shape}) {
    for (const auto strain : {solver::Strain::cell, solver::Strain::recovered}) {
      for (const double flip : {1.0, 0.9}) {
        solver::Case scene = studies::papers_case(60);
        scene.discretization.transfer = transfer;
        scene.discretization.strain = strain;
        scene.discretization.placement = solver::Placement::stratified;
        scene.time.flip = flip;
        const auto exact = reference_profile(scene);
        const solver::Snapshot a = run_case(scene, *exact).snapshot;
        const solver::Snapshot b = run_plain(scene, *exact).snapshot;
        const double stress = 1e-12 * scene.problem.stress_scale();
        const double velocity = 1e-12 * scene.problem.velocity_scale();
        BOOST_TEST(largest_difference(a.solid.x, b.solid.x) < 1e-9);  // b's do not move
        BOOST_TEST(largest_difference(a.solid.stress, b.solid.stress) < stress);
        BOOST_TEST(largest_difference(a.fluid.stress, b.fluid.stress) < stress);
        BOOST_TEST(largest_difference(a.solid.velocity, b.solid.velocity) < velocity);
        BOOST_TEST(largest_difference(a.fluid.velocity, b.fluid.velocity) < velocity);
        BOOST_TEST(largest_difference(a.effective_stress, b.effective_stress) < stress);
        BOOST_TEST(largest_difference(a.solid_velocity, b.solid_velocity) < velocity);
        BOOST_TEST(largest_difference(a.fluid_velocity, b.fluid_velocity) < velocity);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
