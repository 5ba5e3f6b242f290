#include "solver/stability/run_growth.hpp"

#include <boost/test/unit_test.hpp>

#include "solver/stability/automatic_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(run_growth)

using namespace porowave;
using namespace porowave::solver;
using namespace porowave::solver::test;

namespace {

Case irregular(std::uint64_t seed) {
  Case scene = undamped_column(30, Placement::stratified, 2, 20.0);
  scene.discretization.kernel = kernel_name<BSpline1>;
  scene.discretization.support_radius = 1.0;
  scene.discretization.seed = seed;
  return scene;
}

}  // namespace

BOOST_AUTO_TEST_CASE(it_is_the_growth_of_a_step_to_the_power_of_the_steps) {
  const Case scene = irregular(1);
  RunGrowth growth(scene, scene.time.end);
  BOOST_TEST(growth.steps(0.5) == std::ceil(20.0 * 30.0 / 0.5));
  SceneGrowth of_step(scene);
  const double per_step = of_step.at(1.0).per_step;
  BOOST_TEST(per_step > 1.01);
  BOOST_TEST(growth.at(1.0) == std::pow(per_step, 600.0), boost::test_tools::tolerance(1e-6));
}

// Undamped waves have modulus 1 to rounding, which a long run must not make a growth of.
BOOST_AUTO_TEST_CASE(rounding_does_not_grow) {
  Case scene = undamped_column(20, Placement::uniform, 2, 1e9);
  use_linear_shape(scene.discretization);
  RunGrowth growth(scene, scene.time.end);
  BOOST_TEST(growth.at(0.6) <= 1.0);
  BOOST_TEST(growth.at(0.9) > 1e6);
}

// Where a run that explodes is largest, the mode is said to be, unless another grows nearly as
// fast: in five of six columns at least.
BOOST_AUTO_TEST_CASE(the_mode_is_where_runs_explode) {
  int there = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Case scene = irregular(seed);
    scene.time.courant = 1.0;
    RunGrowth growth(scene, scene.time.end);
    const FastestMode mode = growth.fastest(1.0);
    BOOST_TEST_CONTEXT("seed " << seed) {
      BOOST_REQUIRE(mode.per_step > 1.01);
      const StressPeak peak = peak_at_end(scene);
      BOOST_TEST(peak.share > 1e6);
      there += std::abs(peak.x - mode.x) < 2.0 * 0.1 / 30.0 ? 1 : 0;
    }
  }
  BOOST_TEST(there >= 5);
}

BOOST_AUTO_TEST_SUITE_END()
