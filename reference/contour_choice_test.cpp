#include "reference/contour_choice.hpp"

#include <boost/test/unit_test.hpp>

#include "reference/inversion.hpp"
#include "reference/problem/problem_fixtures.hpp"
#include "reference/random_points.hpp"

BOOST_AUTO_TEST_SUITE(contour_choice)

using namespace porowave;
using namespace porowave::reference;

BOOST_AUTO_TEST_CASE(different_contours_agree_within_their_bounds) {
  // Any permitted contour gives the same integral: here the chosen one against one half as far out
  // and one of a smaller angle, for random points of the whole range.
  fixtures::RandomPoints random(11);
  int compared = 0;
  int sharp = 0;
  for (int trial = 0; trial < 250; ++trial) {
    const auto point = random.next();
    const WaveModes modes(point.problem.material);
    const LoadTransform load(point.problem.load);
    const double uncertainty = 1e-15 * point.t;
    const auto rays = rays_until(point.problem, modes, point.x, point.t);
    if (rays.size() > 300) continue;
    const auto arrivals = arrivals_of(point.problem, modes, load, rays, point.t, uncertainty);
    for (const auto& group : arrivals.groups) {
      const auto choices = contours_for(point.problem, modes, load, group);
      if (choices.empty()) continue;
      Integrand integrand(point.problem, load, group.arrivals);
      const auto invert_on = [&](const Hyperbola& contour) {
        NodeTable table(point.problem, modes, contour, choices.front().cut);
        return invert(integrand, table, uncertainty);
      };
      const Hyperbola chosen = choices.front().contour;
      const Inverted best = invert_on(chosen);
      const Inverted nearer = invert_on({chosen.shift, 0.5 * chosen.scale, chosen.angle});
      const Inverted closed = invert_on({chosen.shift, chosen.scale, 0.8 * chosen.angle});
      for (const Inverted& other : {nearer, closed}) {
        ++compared;
        if (best.worst + other.worst < 1e-11) ++sharp;
        for (std::size_t f = 0; f < 4; ++f) {
          BOOST_TEST_CONTEXT("trial " << trial << ' ' << point.place << " field " << f) {
            BOOST_TEST(
                !(std::abs(best.value[f] - other.value[f]) > best.error[f] + other.error[f]));
          }
        }
      }
    }
  }
  BOOST_TEST(compared > 300);
  BOOST_TEST(sharp > 0.7 * compared);
}

BOOST_AUTO_TEST_CASE(a_contour_on_which_the_integrand_comes_back_is_avoided) {
  // Just behind a returning undrained wave the integrand vanishes along a wide hyperbola, only to
  // come back near the relaxation rate, too fast to be summed.
  Problem problem = fixtures::paper_problem();
  problem.material.intrinsic_permeability = 1e-17;
  const ColumnSolution solution(problem);
  for (const double t : {7.8363972908388672e-4, 8.7070940038809746e-4, 1.2187876529890751e-3}) {
    const auto fields = solution.at(0.0, t);
    BOOST_TEST(fields.error.pore_pressure < 1e-12);
    BOOST_TEST(fields.error.solid_velocity < 1e-12 * problem.velocity_scale());
  }
}

BOOST_AUTO_TEST_SUITE_END()
