#include "verification/stability/observed_growth.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/problem/problem_fixtures.hpp"
#include "verification/stability/random_scene.hpp"

BOOST_AUTO_TEST_SUITE(observed_growth)

using namespace porowave;
using namespace porowave::verification;
namespace tt = boost::test_tools;

namespace {

solver::Case one_point_column(solver::TransferName transfer) {
  solver::Case scene;
  scene.problem = fixtures::paper_problem();
  scene.problem.material.intrinsic_permeability = 1.0;
  scene.discretization.elements = 60;
  scene.discretization.transfer = transfer;
  scene.discretization.shape = solver::shape_name<solver::LinearSpline>;
  scene.discretization.points_per_element = 1;
  return scene;
}

}  // namespace

// One point in the middle of every cell does not see the shortest wave: its stresses are multiplied
// by 1 − (2 courant)² a step (solver/stability/growth_test.cpp).
BOOST_AUTO_TEST_CASE(noise_grows_as_it_must) {
  const auto scene = one_point_column(solver::TransferName::shape);
  for (const double courant : {0.75, 0.9}) {
    const ObservedGrowth found = verification::observed_growth(scene, courant, 4000, 1e-3);
    BOOST_TEST(found.per_step == 4.0 * courant * courant - 1.0, tt::tolerance(1.5e-2));
    BOOST_TEST(found.steps < 1000);
  }
}

BOOST_AUTO_TEST_CASE(noise_of_a_stable_run_does_not_grow) {
  const auto scene = one_point_column(solver::TransferName::shape);
  const ObservedGrowth found = verification::observed_growth(scene, 0.6, 4000, 1e-3);
  BOOST_TEST(std::abs(found.per_step - 1.0) < 2e-4);
  BOOST_TEST(found.steps == 4000);
}

// Both start from a jump of the load.
BOOST_AUTO_TEST_CASE(apic_and_staggered4_are_observed_as_well) {
  auto scene = one_point_column(solver::TransferName::apic);
  scene.discretization.points_per_element = 4;
  scene.time.flip = 0.0;
  BOOST_TEST(std::abs(verification::observed_growth(scene, 0.6, 2000, 1e-3).per_step - 1.0) < 1e-2);
  BOOST_TEST(verification::observed_growth(scene, 1.5, 2000, 1e-3).per_step > 1.1);

  scene.time.flip = 1.0;
  scene.discretization.scheme = solver::Scheme::staggered4;
  scene.discretization.transfer = solver::TransferName::mls;
  scene.discretization.basis_order = 2;
  scene.discretization.kernel = solver::kernel_name<solver::WendlandC2>;
  scene.discretization.support_radius = 2.0;
  BOOST_TEST(std::abs(verification::observed_growth(scene, 0.8, 2000, 1e-3).per_step - 1.0) < 1e-3);
  BOOST_TEST(verification::observed_growth(scene, 1.1, 2000, 1e-3).per_step > 1.1);
}

BOOST_AUTO_TEST_CASE(random_scenes_repeat_and_reach_every_choice) {
  std::array<int, 3> transfers{};
  std::array<int, 4> placements{}, near{};
  std::array<int, 3> far{};
  int staggered = 0, gaps = 0, recovered = 0, adaptive = 0, xpic = 0;
  double lowest = 1.0, highest = 0.0;
  for (std::uint64_t number = 1; number <= 400; ++number) {
    const solver::Case scene = random_scene(number);
    const solver::Discretization& d = scene.discretization;
    BOOST_TEST(described(random_scene(number)) == described(scene));
    if (d.scheme == solver::Scheme::staggered4) {
      ++staggered;
    } else {
      ++transfers[static_cast<std::size_t>(d.transfer)];
    }
    ++placements[static_cast<std::size_t>(d.placement)];
    ++near[static_cast<std::size_t>(scene.problem.column.near)];
    ++far[static_cast<std::size_t>(scene.problem.column.far)];
    gaps += d.empty_elements.empty() ? 0 : 1;
    recovered += d.strain == solver::Strain::recovered ? 1 : 0;
    adaptive += d.adaptive_support ? 1 : 0;
    xpic += scene.time.xpic_order > 0 ? 1 : 0;
    const double permeability = scene.problem.material.intrinsic_permeability;
    lowest = std::min(lowest, permeability);
    highest = std::max(highest, permeability);
    BOOST_TEST((permeability >= 1e-16 && permeability <= 1e-6));
    const bool apic =
        d.scheme == solver::Scheme::galerkin && d.transfer == solver::TransferName::apic;
    BOOST_TEST(apic == (scene.time.flip == 0.0));
    if (scene.time.xpic_order > 0) BOOST_TEST(scene.time.flip == 1.0);
  }
  for (const int count : transfers) BOOST_TEST(count > 20);
  for (const int count : placements) BOOST_TEST(count > 60);
  for (const int count : near) BOOST_TEST(count > 60);
  for (const int count : far) BOOST_TEST(count > 80);
  for (const int count : {staggered, gaps, recovered, adaptive, xpic}) BOOST_TEST(count > 10);
  BOOST_TEST(lowest < 1e-15);
  BOOST_TEST(highest > 1e-7);
}

BOOST_AUTO_TEST_SUITE_END()
