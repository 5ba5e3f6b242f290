#include "verification/work_precision.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

#include "reference/problem/errors.hpp"
#include "reference/problem/problem_fixtures.hpp"
#include "solver/stability/automatic_step.hpp"

BOOST_AUTO_TEST_SUITE(work_precision)

using namespace porowave;
using namespace porowave::verification;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// A measurement of one error in all fields but one, which is smaller.
WorkPrecision measurement(const std::string& name, double cpu_seconds, double error) {
  WorkPrecision m;
  m.method.name = name;
  m.cpu_seconds = cpu_seconds;
  for (FieldError& field : m.run.errors) field.field.l2 = error;
  m.run.errors[0].field.l2 = 0.5 * error;
  return m;
}

/// Two methods that cross, one that is always worse, and one that broke.
std::vector<WorkPrecision> synthetic() {
  return {measurement("low", 1.0, 1e-2),           measurement("low", 4.0, 3e-3),
          measurement("low", 16.0, 1e-3),          measurement("high", 3.0, 2e-2),
          measurement("high", 6.0, 1e-3),          measurement("high", 12.0, 1e-4),
          measurement("poor", 2.0, 5e-2),          measurement("poor", 20.0, 1e-4),
          measurement("broken", 0.5, not_a_number)};
}

solver::Case small_column() {
  solver::Case scene;
  scene.problem = fixtures::paper_problem(Load(LoadShape::smooth_ramp, 1.0, 1e-5));
  scene.time.end = 1e-5;
  return scene;
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream text(line);
  for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
  return cells;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_error_is_that_of_the_worst_field) {
  WorkPrecision m = measurement("m", 1.0, 1e-3);
  BOOST_TEST(m.error() == 1e-3);
  m.run.errors[3].field.l2 = 0.1;
  BOOST_TEST(m.error() == 0.1);
  m.run.errors[1].field.l2 = not_a_number;
  BOOST_TEST(std::isnan(m.error()));
}

BOOST_AUTO_TEST_CASE(the_cheapest_of_an_error_level_is_named) {
  const auto measured = synthetic();
  BOOST_TEST(cheapest_within(measured, 1e-2) == 0u);
  BOOST_TEST(cheapest_within(measured, 9.9e-3) == 1u);
  BOOST_TEST(cheapest_within(measured, 1e-3) == 4u);  // the high order has overtaken
  BOOST_TEST(cheapest_within(measured, 1e-4) == 5u);
  BOOST_TEST(cheapest_within(measured, 9e-5) == measured.size());
}

BOOST_AUTO_TEST_CASE(the_front_has_what_no_cheaper_run_reaches) {
  const std::vector<std::size_t> expected = {0, 1, 4, 5};
  BOOST_TEST(pareto_front(synthetic()) == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(of_two_equally_cheap_runs_the_better_is_on_the_front) {
  const std::vector<WorkPrecision> measured = {
      measurement("a", 1.0, 2e-2), measurement("b", 1.0, 1e-2), measurement("c", 2.0, 1e-2)};
  const std::vector<std::size_t> expected = {1};
  BOOST_TEST(pareto_front(measured) == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_table_says_when_no_method_is_good_enough) {
  const std::string text = best_of_levels(synthetic(), std::array{1e-3, 1e-9});
  BOOST_TEST(text.find("1e-03         high") != std::string::npos);
  BOOST_TEST(text.find("6e+03") != std::string::npos);
  BOOST_TEST(text.find("1e-09         none") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(every_transfer_kernel_and_strain_is_among_the_methods) {
  std::set<std::string> names;
  for (const Method& method : every_method(small_column())) names.insert(method.name);
  BOOST_TEST(names.size() == solver::shape_names().size() + 3 + 2 * solver::kernel_count + 4);
  for (const char* name : {"shape cpgimp", "apic bspline2", "mls wendland_c6", "mls bspline1",
                           "mls bspline3, recovered", "staggered4 basis 3, time 4"}) {
    BOOST_TEST(names.count(name) == 1u);
  }
}

// Every method runs, and the name says what ran: different methods have different errors. Only the
// linear functions and the domains of gimp agree as long as points have not moved.
BOOST_AUTO_TEST_CASE(methods_are_measured_and_written_a_row_each) {
  const auto methods = every_method(small_column());
  const auto measured = measure(methods, std::array{20, 40}, 2);
  BOOST_TEST_REQUIRE(measured.size() == 2 * methods.size());
  std::set<double> errors;
  for (std::size_t i = 0; i < measured.size(); i += 2) {
    BOOST_TEST(measured[i].method.scene.discretization.elements == 20);
    BOOST_TEST(measured[i + 1].method.scene.discretization.elements == 40);
    BOOST_TEST(measured[i].cpu_seconds > 0.0);
    errors.insert(std::round(1e12 * measured[i].error()));
  }
  BOOST_TEST(errors.size() == methods.size() - 2);

  std::ostringstream out;
  write_work_precision_csv(measured, out);
  std::istringstream lines(out.str());
  std::string header;
  std::getline(lines, header);
  const auto columns = split(header);
  std::size_t rows = 0;
  for (std::string line; std::getline(lines, line); ++rows) {
    const auto cells = split(line);
    BOOST_TEST_REQUIRE(cells.size() == columns.size());
    BOOST_TEST(cells[9] == (rows % 2 == 0 ? "20" : "40"));
    BOOST_TEST(std::abs(std::stod(cells[13]) / measured[rows].run.errors[0].field.l2 - 1.0) < 1e-4);
  }
  BOOST_TEST(rows == measured.size());
}

BOOST_AUTO_TEST_CASE(no_repetition_is_no_measurement) {
  const auto methods = every_method(small_column());
  BOOST_CHECK_THROW(measure(methods, std::array{20}, 0), std::invalid_argument);
}

// Few points that are random over the whole column make staggered4 unstable at any step.
BOOST_AUTO_TEST_CASE(a_method_without_a_stable_step_is_not_measured) {
  solver::Case scene = small_column();
  scene.discretization.placement = solver::Placement::random;
  scene.discretization.points_per_element = 2;
  scene.time.end = 8e-5;
  const Method method = every_method(scene).back();
  BOOST_CHECK_THROW(measure(std::array{method}, std::array{200}, 1), solver::NoStableStep);
}

// A load of several times the modulus compresses the solid to nothing.
BOOST_AUTO_TEST_CASE(a_run_that_breaks_down_is_not_a_measurement) {
  solver::Case scene = small_column();
  scene.problem.load = Load(LoadShape::step, 5.0 * scene.problem.material.constrained_modulus);
  scene.time.end = 2e-5;
  const Method method = every_method(scene).front();
  BOOST_CHECK_THROW(measure(std::array{method}, std::array{20}, 1), BreakdownError);
}

BOOST_AUTO_TEST_SUITE_END()
