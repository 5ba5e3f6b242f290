#include "reference/time_slice.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

#include "reference/problem/errors.hpp"
#include "reference/problem/problem_fixtures.hpp"
#include "reference/random_points.hpp"

BOOST_AUTO_TEST_SUITE(time_slice)

using namespace porowave;
using namespace porowave::reference;

BOOST_AUTO_TEST_CASE(contours_found_for_other_points_give_the_same_values) {
  fixtures::RandomPoints random(5);
  int compared = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const auto point = random.next();
    const ColumnSolution solution(point.problem);
    const double length = point.problem.column.length.value_or(3.0 * point.x + 1e-3);
    if (rays_until(point.problem, solution.modes(), 0.0, point.t).size() > 200) continue;
    TimeSlice slice(solution, point.t);
    for (const double share : {0.1, 0.9, 0.3, 0.29, 0.31, 0.0, 1.0}) {
      const auto one = slice.at(share * length);
      const auto other = solution.at(share * length, point.t);
      ++compared;
      BOOST_TEST_CONTEXT("trial " << trial << " at " << share << " of the length") {
        const auto agree = [](double a, double b, double bounds) {
          return !(std::abs(a - b) > bounds);
        };
        BOOST_TEST(agree(one.value.effective_stress, other.value.effective_stress,
                         one.error.effective_stress + other.error.effective_stress));
        BOOST_TEST(agree(one.value.fluid_velocity, other.value.fluid_velocity,
                         one.error.fluid_velocity + other.error.fluid_velocity));
        BOOST_TEST(one.error.effective_stress <=
                   3.0 * other.error.effective_stress + 1e-12 * point.problem.stress_scale());
      }
    }
  }
  BOOST_TEST(compared > 200);
}

BOOST_AUTO_TEST_CASE(times_and_places_outside_are_refused) {
  const ColumnSolution solution(fixtures::paper_problem());
  BOOST_CHECK_THROW(TimeSlice(solution, std::numeric_limits<double>::infinity()), InputError);
  TimeSlice slice(solution, 1e-5);
  BOOST_CHECK_THROW(slice.at(0.11), InputError);
  TimeSlice before(solution, -1.0);
  BOOST_TEST(before.at(0.05).value.pore_pressure == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
