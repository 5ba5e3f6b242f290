#include "reference/smooth_pieces.hpp"

#include <boost/test/unit_test.hpp>

#include "reference/problem/problem_fixtures.hpp"
#include "reference/profile.hpp"
#include "reference/random_points.hpp"

BOOST_AUTO_TEST_SUITE(smooth_pieces)

using namespace porowave;
using namespace porowave::reference;

BOOST_AUTO_TEST_CASE(pieces_end_at_all_fronts_of_the_load) {
  const ColumnSolution solution(fixtures::paper_problem(Load(LoadShape::block, 1.0, 1e-5)));
  const double t = 6e-5;
  const auto ends = reference::smooth_pieces(solution, t, 0.1);
  BOOST_TEST(ends.front() == 0.0);
  BOOST_TEST(ends.back() == 0.1);
  BOOST_TEST(std::is_sorted(ends.begin(), ends.end()));
  for (const double time : {0.0, 1e-5}) {
    for (const double front : solution.fronts(t - time)) {
      BOOST_TEST(std::count_if(ends.begin(), ends.end(),
                               [&](double x) { return std::abs(x - front) < 1e-14; }) == 1);
    }
  }
}

BOOST_AUTO_TEST_CASE(times_end_at_all_arrivals_at_the_loaded_end) {
  const ColumnSolution solution(fixtures::paper_problem(Load(LoadShape::block, 1.0, 1e-5)));
  const double t = 2e-4;
  const auto ends = smooth_times(solution, t);
  BOOST_TEST(ends.front() == 0.0);
  BOOST_TEST(ends.back() == t);
  BOOST_TEST(std::is_sorted(ends.begin(), ends.end()));
  const double fast = 0.2 / solution.modes().speed(0);
  const double slow = 0.2 / solution.modes().speed(1);
  for (const double time : {1e-5, fast, fast + 1e-5, 2.0 * fast, slow, slow + 1e-5}) {
    BOOST_TEST(std::count_if(ends.begin(), ends.end(),
                             [&](double end) { return std::abs(end - time) < 1e-14; }) == 1);
  }
}

BOOST_AUTO_TEST_CASE(profiles_see_thin_layers) {
  // From waves that pass to stiff drag: at random places the series must be as good as it says.
  fixtures::RandomProblems random(3);
  for (const double permeability : {1e-10, 1e-13, 1e-15, 1e-17}) {
    Problem problem = fixtures::paper_problem();
    problem.material.intrinsic_permeability = permeability;
    const ColumnSolution solution(problem);
    for (const double t : {4e-5, 1.3e-4}) {
      const Profile profile(solution, t, 0.1);
      BOOST_TEST_CONTEXT("permeability " << permeability << " at " << t) {
        BOOST_TEST(profile.error() < 1e-9);
        for (int i = 0; i < 60; ++i) {
          // A third of the places near the front, a third near the loaded end.
          const double near = random.log_uniform(1e-7, 0.1);
          const double front = std::min(0.1, solution.modes().undrained_speed() * t);
          const double x = i % 3 == 0 ? near : i % 3 == 1 ? front - near : random.uniform(0, 0.1);
          const double exact = solution.at(std::max(x, 0.0), t).value.pore_pressure;
          BOOST_TEST(std::abs(profile.at(std::max(x, 0.0)).pore_pressure - exact) <=
                     profile.error());
        }
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
