#include "reference/node_table.hpp"

#include <boost/test/unit_test.hpp>

#include "reference/problem/problem_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(node_table)

using namespace porowave;
using namespace porowave::reference;

BOOST_AUTO_TEST_CASE(the_levels_together_are_the_trapezoidal_rule_of_the_finest) {
  const Problem problem = fixtures::paper_problem();
  const WaveModes modes(problem.material);
  NodeTable table(problem, modes, {0.0, 2.0, 0.9}, WaveModes::Cut::between);
  constexpr int finest = 3;
  std::vector<double> places;
  for (int level = 0; level <= finest; ++level) {
    for (std::size_t j = 0; table.at(level, j).u < 4.0; ++j) places.push_back(table.at(level, j).u);
  }
  std::sort(places.begin(), places.end());
  for (std::size_t i = 0; i < places.size(); ++i) {
    BOOST_TEST(places[i] == static_cast<double>(i) * NodeTable::step(finest));
  }
}

BOOST_AUTO_TEST_CASE(weights_count_both_halves_of_the_contour) {
  // The inverse of 1/(s + 1) at t = 1.
  const Problem problem = fixtures::paper_problem();
  const WaveModes modes(problem.material);
  NodeTable table(problem, modes, {0.0, 4.0, 0.9}, WaveModes::Cut::between);
  double sum = 0.0;
  for (int level = 0; level <= 4; ++level) {
    for (std::size_t j = 0; table.at(level, j).u < 5.0; ++j) {
      const Node& node = table.at(level, j);
      sum += (node.weight * std::exp(node.s) / (node.s + 1.0)).real();
    }
  }
  BOOST_TEST(sum * NodeTable::step(4) == std::exp(-1.0), boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_SUITE_END()
