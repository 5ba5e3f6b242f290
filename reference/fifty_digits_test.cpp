#include "reference/fifty_digits.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/problem/problem_fixtures.hpp"
#include "reference/random_points.hpp"
#include "reference/tables/truth.hpp"

using namespace porowave;

namespace {

double distance(const Problem& problem, const Fields& a, const Fields& b) {
  const double stress = problem.stress_scale();
  const double velocity = problem.velocity_scale();
  return std::max({std::abs(a.effective_stress - b.effective_stress) / stress,
                   std::abs(a.pore_pressure - b.pore_pressure) / stress,
                   std::abs(a.solid_velocity - b.solid_velocity) / velocity,
                   std::abs(a.fluid_velocity - b.fluid_velocity) / velocity});
}

}  // namespace

BOOST_AUTO_TEST_SUITE(fifty_digits)

BOOST_AUTO_TEST_CASE(every_row_of_the_truth_tables) {
  double worst = 0.0;
  double worst_agreement = 0.0;
  for (const char* table : {"truth_step.csv", "truth_smooth.csv"}) {
    for (const auto& row :
         fixtures::read_truth(std::string(POROWAVE_SOURCE_DIR) + "/reference/tables/" + table)) {
      const auto exact = fixtures::fifty_digits(row.problem, row.x, row.t);
      const double error = distance(row.problem, exact.value, row.value);
      BOOST_TEST_CONTEXT(row.id) {
        BOOST_TEST(exact.agreement < 1e-18);
        BOOST_TEST(error <= 1e-15 + row.uncertainty);
      }
      worst = std::max(worst, error);
      worst_agreement = std::max(worst_agreement, exact.agreement);
    }
  }
  BOOST_TEST_MESSAGE("truth tables: worst error " << worst << ", worst agreement "
                                                  << worst_agreement);
}

BOOST_AUTO_TEST_SUITE_END()
