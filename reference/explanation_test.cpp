#include "reference/explanation.hpp"

#include <boost/test/unit_test.hpp>

#include "reference/problem/errors.hpp"
#include "reference/problem/problem_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(explanation)

using namespace porowave;
using namespace porowave::reference;

BOOST_AUTO_TEST_CASE(the_groups_add_up_to_the_value_and_converge_with_the_level) {
  for (const double permeability : {1e-10, 1e-13}) {
    Problem problem = fixtures::paper_problem(Load(LoadShape::smooth_ramp, 1.0, 1e-5));
    problem.material.intrinsic_permeability = permeability;
    const ColumnSolution solution(problem);
    for (const double x : {0.01, 0.05}) {
      const auto value = solution.at(x, 4e-5);
      double coarse = 0.0;
      double fine = 0.0;
      for (const auto& group : explain(solution, x, 4e-5)) {
        BOOST_REQUIRE(group.by_level.size() == 7u);
        coarse += group.by_level[1][0];
        fine += group.by_level.back()[0];
        BOOST_TEST(group.nodes_by_level.back() > 2 * group.nodes_by_level[3]);
        BOOST_TEST(!group.nodes.empty());
        BOOST_TEST(group.choice.height > 0.0);
      }
      BOOST_TEST(std::abs(fine - value.value.effective_stress) <=
                 2.0 * value.error.effective_stress);
      BOOST_TEST(std::abs(coarse - fine) > std::abs(fine - value.value.effective_stress));
    }
  }
}

BOOST_AUTO_TEST_CASE(heights_are_those_of_the_integrand) {
  const Problem problem = fixtures::paper_problem();
  const auto groups = explain(ColumnSolution(problem), 0.0, 1e-5);
  BOOST_REQUIRE(groups.size() == 1u);
  // At the loaded end sigma' = -q throughout: the integrand is e^(s t)/s.
  const double s = 2e5;
  const auto heights = groups[0].log_heights(problem, {Complex(s, 0.0)});
  BOOST_TEST(heights[0] >= s * 1e-5 * std::log10(std::exp(1.0)) - 1e-9);
}

BOOST_AUTO_TEST_CASE(nothing_is_explained_outside_of_the_column) {
  const ColumnSolution solution(fixtures::paper_problem());
  BOOST_CHECK_THROW(explain(solution, 0.2, 1e-5), InputError);
  BOOST_TEST(explain(solution, 0.1, 0.0).empty());
  BOOST_TEST(explain(solution, 0.1, 1e-5).empty());
}

BOOST_AUTO_TEST_SUITE_END()
