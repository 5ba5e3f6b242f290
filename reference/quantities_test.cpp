#include "reference/quantities.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/problem/errors.hpp"
#include "reference/problem/problem_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(quantities)

using namespace porowave;
using namespace porowave::reference;

BOOST_AUTO_TEST_CASE(they_are_made_of_the_fields) {
  const ColumnSolution solution(fixtures::paper_problem());
  const double x = 0.03;
  const double t = 4e-5;
  const auto fields = solution.at(x, t);
  const DerivedFields derived = derived_fields(solution, x, t);
  BOOST_TEST(derived.total_stress.value ==
             fields.value.effective_stress - fields.value.pore_pressure);
  BOOST_TEST(derived.total_stress.error >= fields.error.effective_stress);
  BOOST_TEST(derived.seepage_velocity.value ==
             0.4 * (fields.value.fluid_velocity - fields.value.solid_velocity));
  BOOST_TEST(derived.solid_displacement.value == solution.time_integral(x, t).value.solid_velocity);
  BOOST_TEST(derived.fluid_displacement.value == solution.time_integral(x, t).value.fluid_velocity);
  BOOST_CHECK_THROW(derived_fields(solution, 0.2, t), InputError);
}

BOOST_AUTO_TEST_CASE(a_piston_feels_the_load_and_lets_nothing_through) {
  Problem problem = fixtures::paper_problem(Load(LoadShape::smooth_ramp, 2.0, 1e-5));
  problem.column.near = NearEnd::sealed_traction;
  const ColumnSolution solution(problem);
  for (const double t : {3e-6, 5e-5}) {
    const DerivedFields derived = derived_fields(solution, 0.0, t);
    BOOST_TEST(std::abs(derived.total_stress.value + problem.load.value(t)) <=
               derived.total_stress.error);
    BOOST_TEST(std::abs(derived.seepage_velocity.value) <= derived.seepage_velocity.error);
    BOOST_TEST(std::abs(derived.solid_displacement.value - derived.fluid_displacement.value) <=
               derived.solid_displacement.error + derived.fluid_displacement.error);
  }
}

BOOST_AUTO_TEST_CASE(the_loaded_end_settles_into_the_column) {
  const ColumnSolution solution(fixtures::paper_problem());
  const Bounded after = settlement(solution, 4e-5);
  BOOST_TEST(after.value > 1e-13);
  BOOST_TEST(after.error < 1e-12 * after.value);
  BOOST_TEST(settlement(solution, 0.0).value == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
