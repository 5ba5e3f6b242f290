#include "verification/cost/calibration.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <vector>

#include "verification/paper_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(calibration)

using namespace porowave;
using namespace porowave::verification;

BOOST_AUTO_TEST_CASE(a_point_of_the_stencil_takes_between_a_tenth_and_a_hundred_nanoseconds) {
  // Six operations: faster than a vector of eight at 8 GHz, or slower than a sanitized build on a
  // slow machine, would be something else than the loop.
  const double once = calibration_nanoseconds();
  BOOST_TEST(once > 0.05);
  BOOST_TEST(once < 200.0);
}

BOOST_AUTO_TEST_CASE(a_recent_value_is_kept) {
  const double first = recent_calibration_nanoseconds();
  BOOST_TEST(recent_calibration_nanoseconds() == first);
}

/// Cost of a step relative to the loop, median of several.
double relative_cost(int elements) {
  solver::Case scene = studies::papers_case(elements);
  scene.time.path = solver::StepPath::points;
  const auto exact = reference_profile(scene);
  std::vector<double> costs;
  for (int k = 0; k < 9; ++k) {
    const double loop = calibration_nanoseconds();
    costs.push_back(run_case(scene, *exact).cost.ns_per_point_step / loop);
  }
  std::nth_element(costs.begin(), costs.begin() + 4, costs.end());
  return costs[4];
}

BOOST_AUTO_TEST_CASE(the_relative_cost_of_a_step_repeats_and_does_not_depend_on_the_scenes_size) {
  // Twice the elements, four times the work: wide bounds, as other programs run beside.
  const double small = relative_cost(100);
  const double large = relative_cost(200);
  BOOST_TEST_MESSAGE("a point and step takes as long as " << small << " and " << large
                                                          << " points of the stencil");
  BOOST_TEST(small / large < 2.5);
  BOOST_TEST(large / small < 2.5);
}

BOOST_AUTO_TEST_SUITE_END()
