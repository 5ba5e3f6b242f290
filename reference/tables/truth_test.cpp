#include "reference/tables/truth.hpp"
#include "reference/field_fixtures.hpp"

#include <boost/test/unit_test.hpp>
#include <ctime>

#include "reference/column_solution.hpp"

BOOST_AUTO_TEST_SUITE(truth)

using namespace porowave;
using fixtures::Worst;

namespace {

/// CPU milliseconds a value, by the stiffness of the drag.
struct Cost {
  double seconds = 0.0;
  double worst = 0.0;
  int values = 0;
  void see(double time) {
    seconds += time;
    worst = std::max(worst, time);
    ++values;
  }
};

std::ostream& operator<<(std::ostream& out, const Cost& cost) {
  return out << 1e3 * cost.seconds / cost.values << " ms in the mean of " << cost.values
             << ", worst " << 1e3 * cost.worst << " ms";
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_row_is_within_1e_12_of_the_load_and_within_its_bound) {
  Worst error;
  Worst ratio;
  std::array<Cost, 3> cost;
  int rows = 0;
  for (const char* table : {"truth_step.csv", "truth_smooth.csv"}) {
    for (const auto& row :
         fixtures::read_truth(std::string(POROWAVE_SOURCE_DIR) + "/reference/tables/" + table)) {
      ++rows;
      const std::clock_t start = std::clock();
      const auto solution = reference::ColumnSolution(row.problem).at(row.x, row.t);
      const double stiffness = row.problem.material.relaxation_rate() * row.t;
      cost[stiffness < 100.0 ? 0
           : stiffness < 1e4 ? 1
                             : 2]
          .see(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
      const double velocity = row.problem.velocity_scale();
      const std::array<double, 4> errors = {
          std::abs(solution.value.effective_stress - row.value.effective_stress),
          std::abs(solution.value.pore_pressure - row.value.pore_pressure),
          std::abs(solution.value.solid_velocity - row.value.solid_velocity) / velocity,
          std::abs(solution.value.fluid_velocity - row.value.fluid_velocity) / velocity};
      const std::array<double, 4> bounds = {
          solution.error.effective_stress, solution.error.pore_pressure,
          solution.error.solid_velocity / velocity, solution.error.fluid_velocity / velocity};
      for (std::size_t f = 0; f < 4; ++f) {
        BOOST_TEST_CONTEXT(row.id << " field " << f) {
          BOOST_TEST(errors[f] <= 1e-12);
          BOOST_TEST(errors[f] <= bounds[f] + row.uncertainty);
          BOOST_TEST(bounds[f] <= 1e-10);
          error.see(errors[f], row.id);
          ratio.see((errors[f] - row.uncertainty) / bounds[f], row.id);
        }
      }
    }
  }
  BOOST_TEST(rows == 100);
  BOOST_TEST_MESSAGE("truth tables: " << rows << " rows; worst error " << error.size
                                      << " of the load (" << error.where << "); worst error/bound "
                                      << ratio.size << " (" << ratio.where << ")");
  BOOST_TEST_MESSAGE("a value with drag rate * time below 100: "
                     << cost[0] << "; below 1e4: " << cost[1] << "; above: " << cost[2]);
}

BOOST_AUTO_TEST_SUITE_END()
