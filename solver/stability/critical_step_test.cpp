#include "solver/stability/critical_step.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/problem/problem_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(critical_step)

using namespace porowave;
using namespace porowave::solver;
namespace tt = boost::test_tools;

namespace {

Case uniform_column(int elements) {
  Case scene;
  scene.problem = fixtures::paper_problem();
  scene.problem.material.intrinsic_permeability = 1.0;
  scene.discretization.elements = elements;
  scene.discretization.transfer = TransferName::shape;
  scene.discretization.shape = shape_name<LinearSpline>;
  scene.discretization.points_per_element = 2;
  return scene;
}

}  // namespace

BOOST_AUTO_TEST_CASE(it_is_found_to_the_tolerance) {
  for (const double limit : {0.9871, 0.7071, 0.5, 0.1234}) {
    for (const double tolerance : {1e-2, 1e-4}) {
      CriticalSettings settings;
      settings.tolerance = tolerance;
      const auto found = solver::critical_step(
          [&](double courant) { return courant > limit ? 1.3 : 1.0; }, settings);
      BOOST_TEST(found.courant <= limit);
      BOOST_TEST(found.unstable > limit);
      BOOST_TEST(found.unstable - found.courant <= tolerance * found.courant);
      BOOST_TEST(found.unstable_below().empty());
    }
  }
}

BOOST_AUTO_TEST_CASE(growth_below_the_limit_is_stable) {
  CriticalSettings settings;
  settings.limit = 0.01;
  const auto found =
      solver::critical_step([](double courant) { return 1.0 + 0.02 * courant; }, settings);
  BOOST_TEST(found.courant == 0.5, tt::tolerance(2.0 * settings.tolerance));
}

BOOST_AUTO_TEST_CASE(the_highest_that_is_stable_has_nothing_above_it) {
  const auto found = solver::critical_step([](double) { return 1.0; });
  BOOST_TEST(found.courant == 1.0);
  BOOST_TEST(found.unstable == 0.0);
  BOOST_TEST(found.scan.size() == 20u);
  BOOST_TEST(found.scan.back().courant == 0.05, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(without_a_stable_step_it_is_zero) {
  const auto found = solver::critical_step([](double) { return 1.1; });
  BOOST_TEST(found.courant == 0.0);
  BOOST_TEST(found.unstable == 0.05, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(unstable_steps_below_are_told) {
  const auto growth_at = [](double courant) {
    return courant > 0.82 || (courant > 0.27 && courant < 0.41) ? 1.01 : 1.0;
  };
  auto found = solver::critical_step(growth_at);
  BOOST_TEST(found.courant == 0.82, tt::tolerance(2e-3));
  const auto below = found.unstable_below();
  BOOST_TEST_REQUIRE(below.size() == 3u);  // 0.40, 0.35, 0.30
  BOOST_TEST(below.front().courant == 0.40, tt::tolerance(1e-12));
  BOOST_TEST(below.back().courant == 0.30, tt::tolerance(1e-12));
  BOOST_TEST(below.back().growth == 1.01);

  CriticalSettings settings;
  settings.whole_scan = false;
  found = solver::critical_step(growth_at, settings);
  BOOST_TEST(found.courant == 0.82, tt::tolerance(2e-3));
  BOOST_TEST(found.scan.size() == 5u);  // 1, 0.95, 0.9, 0.85, 0.8
}

BOOST_AUTO_TEST_CASE(a_growth_that_is_not_a_number_is_not_stable) {
  const auto found =
      solver::critical_step([](double courant) { return courant > 0.6 ? NAN : 1.0; });
  BOOST_TEST(found.courant == 0.6, tt::tolerance(2e-3));
}

BOOST_AUTO_TEST_CASE(settings_out_of_order_are_refused) {
  const auto refuses = [](auto change) {
    CriticalSettings settings;
    change(settings);
    BOOST_CHECK_THROW(solver::critical_step([](double) { return 1.0; }, settings),
                      std::invalid_argument);
  };
  refuses([](CriticalSettings& s) { s.limit = 0.0; });
  refuses([](CriticalSettings& s) { s.lowest = 2.0; });
  refuses([](CriticalSettings& s) { s.spacing = -0.1; });
  refuses([](CriticalSettings& s) { s.tolerance = NAN; });
}

// 1/√(2 − w), w = 1/4 for two points (growth_test.cpp), by the matrix and by iteration.
BOOST_AUTO_TEST_CASE(columns_have_their_known_limit) {
  for (const std::size_t largest_dense : {1000, 0}) {
    GrowthSettings settings;
    settings.largest_dense = largest_dense;
    SceneGrowth growth(uniform_column(60), settings);
    CriticalSettings search;
    search.lowest = 0.6;
    const auto found =
        solver::critical_step([&](double courant) { return growth.at(courant).per_step; }, search);
    BOOST_TEST(found.courant == 1.0 / std::sqrt(1.75), tt::tolerance(5e-3));
    BOOST_TEST(
        growth.time_step(1.0) == 0.1 / 60.0 / wave_speeds(uniform_column(60).problem.material).p1,
        tt::tolerance(1e-14));
  }
}

BOOST_AUTO_TEST_SUITE_END()
