#include "reference/profile.hpp"

#include <boost/test/unit_test.hpp>

#include "reference/field_fixtures.hpp"
#include "reference/problem/problem_fixtures.hpp"
#include "reference/random_problems.hpp"

BOOST_AUTO_TEST_SUITE(profile)

using namespace porowave;
using namespace porowave::reference;

namespace {

/// Largest difference between profile and solution at random points, relative to the load.
double worst_difference(const Problem& problem, double t, double end, int points) {
  const ColumnSolution solution(problem);
  const Profile profile(solution, t, end);
  fixtures::RandomProblems random(7);
  double worst = 0.0;
  for (int i = 0; i < points; ++i) {
    const double x = random.uniform(0.0, end);
    worst = std::max(worst, fixtures::distance(problem, profile.at(x), solution.at(x, t).value));
  }
  BOOST_TEST(worst <= profile.error());
  return worst;
}

}  // namespace

BOOST_AUTO_TEST_CASE(it_repeats_the_papers_column) {
  for (const Load& load :
       {Load(LoadShape::step, 1.0), Load(LoadShape::smooth_ramp, 2.0, 1e-5),
        Load(LoadShape::sin4_pulse, 1.0, 1e-5), Load(LoadShape::block, 1.0, 1e-5),
        Load(LoadShape::ricker, 1.0, 1e-5), Load(1.0, {0.0, 5e-6, 1e-5}, {0.0, 1.0, 0.5})}) {
    for (const double t : {1e-6, 4e-5, 1.1e-4}) {
      BOOST_TEST_CONTEXT(name(load.shape()) << " at " << t) {
        BOOST_TEST(worst_difference(fixtures::paper_problem(load), t, 0.1, 100) < 1e-12);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(it_repeats_columns_of_all_kinds) {
  fixtures::RandomProblems random(3);
  for (int trial = 0; trial < 16; ++trial) {
    const Problem problem =
        random.next(random.log_uniform(0.1, 10), Load(), static_cast<NearEnd>(trial % 4),
                    static_cast<FarEnd>(trial / 4));
    const double length = problem.column.length.value_or(1.0);
    const double t = 2.3 * length / wave_speeds(problem.material).p1;
    BOOST_TEST(worst_difference(problem, t, length, 60) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(ahead_of_the_first_front_it_is_exactly_zero) {
  const Profile profile(ColumnSolution(fixtures::paper_problem()), 2e-5, 0.1);
  BOOST_TEST(profile.at(0.06).effective_stress == 0.0);
  BOOST_TEST(profile.at(0.1).solid_velocity == 0.0);
  BOOST_TEST(profile.at(0.04).effective_stress < -0.1);
}

BOOST_AUTO_TEST_CASE(the_strains_add_up_to_the_settlement) {
  const Problem problem = fixtures::paper_problem();
  const ColumnSolution solution(problem);
  for (const double t : {1e-6, 4e-5, 1.1e-4}) {
    const Profile profile(solution, t, 0.1);
    const double shortening = -profile.integral([](const Fields& f) {
      return f.effective_stress;
    }) / problem.material.constrained_modulus;
    BOOST_TEST(shortening == solution.time_integral(0.0, t).value.solid_velocity,
               boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(products_of_fields_are_integrated) {
  // The midpoint rule on many points knows nothing of the pieces.
  const ColumnSolution solution(fixtures::paper_problem(Load(LoadShape::smooth_ramp, 1.0, 1e-5)));
  const Profile profile(solution, 6e-5, 0.1);
  const auto product = [](const Fields& f) { return f.effective_stress * f.pore_pressure; };
  constexpr int points = 20000;
  double sum = 0.0;
  for (int i = 0; i < points; ++i) sum += product(profile.at(0.1 * (i + 0.5) / points));
  const double integral = profile.integral(product);
  BOOST_TEST(std::abs(integral - 0.1 * sum / points) < 1e-7 * std::abs(integral));
  BOOST_TEST(profile.integral([](const Fields&) { return 3.0; }) == 0.3,
             boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(what_the_reference_cannot_resolve_it_does_not_hide) {
  // More images than are followed.
  Problem problem = fixtures::paper_problem();
  problem.column.near = NearEnd::sealed_traction;
  problem.column.far = FarEnd::rigid_drained;
  const Profile profile(ColumnSolution(problem), 0.1, 0.1);
  BOOST_TEST(std::isnan(profile.at(0.03).effective_stress));
  BOOST_TEST(std::isinf(profile.error()));
}

BOOST_AUTO_TEST_SUITE_END()
