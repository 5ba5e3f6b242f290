#include "verification/grade/grade.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reference/problem/errors.hpp"
#include "reference/problem/problem_fixtures.hpp"
#include "verification/run.hpp"

BOOST_AUTO_TEST_SUITE(grade)

using namespace porowave;
using namespace porowave::verification;

namespace {

const Problem problem = fixtures::paper_problem(Load(LoadShape::smooth_ramp, 1.0, 1e-5));
constexpr double time_of_points = 2e-5;

/// The exact fields at a hundred points, each multiplied by a factor.
PointTable exact_points(double factor = 1.0, double time = time_of_points) {
  const auto reference = reference_profile(problem, time, 0.1);
  PointTable table;
  PointProfile& points = table.profiles.emplace_back();
  points.time = time;
  for (int i = 0; i < 100; ++i) {
    const double x = 0.0005 + 0.001 * i;
    const Fields at = reference->at(x);
    points.x.push_back(x);
    points.weight.push_back(1.0 + i);
    points.fields[0].push_back(factor * at.effective_stress);
    points.fields[1].push_back(factor * at.pore_pressure);
    points.fields[2].push_back(factor * at.solid_velocity);
    points.fields[3].push_back(factor * at.fluid_velocity);
  }
  return table;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_factor_is_the_error_in_every_norm) {
  for (const double factor : {1.0, 1.01, 0.9, 0.0}) {
    const auto grades = verification::grade(problem, exact_points(factor));
    BOOST_TEST_REQUIRE(grades.size() == 1U);
    BOOST_TEST(grades[0].time == time_of_points);
    BOOST_TEST(grades[0].points == 100U);
    BOOST_TEST(grades[0].reference_error < 1e-9);
    for (const auto& error : grades[0].errors) {
      BOOST_TEST_REQUIRE(error.has_value());
      for (const double norm : {error->l1, error->l2, error->linf}) {
        BOOST_TEST(std::abs(norm - std::abs(factor - 1.0)) < 1e-12);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(weights_decide_the_share_of_a_point) {
  PointTable table = exact_points();
  auto& stress = table.profiles[0].fields[0];
  auto& weight = table.profiles[0].weight;
  stress[3] *= 2.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < stress.size(); ++i) {
    sum += weight[i] * std::abs(i == 3 ? 0.5 * stress[i] : stress[i]);
  }
  const double share = weight[3] * std::abs(0.5 * stress[3]) / sum;
  const auto grades = verification::grade(problem, table);
  BOOST_TEST(grades[0].errors[0]->l1 == share, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(rows_without_a_value_and_fields_without_rows_do_not_count) {
  PointTable table = exact_points();
  auto& fields = table.profiles[0].fields;
  fields[0][7] = std::nan("");
  fields[1].assign(100, std::nan(""));
  fields[2].clear();
  const auto errors = verification::grade(problem, table)[0].errors;
  BOOST_TEST(errors[0]->linf < 1e-12);
  BOOST_TEST(!errors[1].has_value());
  BOOST_TEST(!errors[2].has_value());
  BOOST_TEST(errors[3].has_value());
}

BOOST_AUTO_TEST_CASE(a_sign_the_other_way_round_is_said) {
  const PointTable wrong = exact_points(-1.02);
  const auto grades = verification::grade(problem, wrong);
  for (const bool opposite : grades[0].opposite_sign) BOOST_TEST(opposite);
  BOOST_TEST(grade_summary(grades, wrong).find("pore_pressure: right with the other sign?") !=
             std::string::npos);
  for (const double factor : {1.0, 0.0, 3.0, -3.0}) {
    const auto right = verification::grade(problem, exact_points(factor));
    for (const bool opposite : right[0].opposite_sign) BOOST_TEST(!opposite);
  }
}

BOOST_AUTO_TEST_CASE(every_time_is_judged_by_itself) {
  PointTable table = exact_points(1.1, 1e-5);
  table.profiles.push_back(exact_points(1.2, 2e-5).profiles[0]);
  const auto grades = verification::grade(problem, table);
  BOOST_TEST_REQUIRE(grades.size() == 2U);
  BOOST_TEST(std::abs(grades[0].errors[2]->l2 - 0.1) < 1e-12);
  BOOST_TEST(std::abs(grades[1].errors[2]->l2 - 0.2) < 1e-12);
  const auto json = nlohmann::json::parse(grade_json(grades, false));
  BOOST_TEST(json.at("profiles").size() == 2U);
  BOOST_TEST(json.at("profiles").at(1).at("time") == 2e-5);
  BOOST_TEST(json.at("profiles").at(1).at("weights") == "equal");
}

BOOST_AUTO_TEST_CASE(an_error_relative_to_nothing_is_none) {
  PointTable table = exact_points(1.0, 0.0);  // all at rest
  for (auto& value : table.profiles[0].fields[1]) value = 1.0;
  const auto grades = verification::grade(problem, table);
  const auto json = nlohmann::json::parse(grade_json(grades, true));
  BOOST_TEST(json.at("errors").at("effective_stress").at("points").at("l1") == 0.0);
  for (const char* norm : {"l1", "l2", "linf"}) {
    BOOST_TEST(json.at("errors").at("pore_pressure").at("points").at(norm).is_null());
  }
  BOOST_TEST(json.at("weights") == "volume");
  const std::string summary = grade_summary(grades, table);
  BOOST_TEST(summary.find("none: the exact field is zero") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_half_space_reaches_to_the_farthest_point) {
  Problem half = problem;
  half.column.length.reset();
  half.column.far = FarEnd::half_space;
  PointTable table = exact_points();  // waves have not reached the end at x = 0.1 m
  table.profiles[0].x.push_back(5.0);
  table.profiles[0].weight.push_back(1.0);
  for (auto& field : table.profiles[0].fields) field.push_back(0.0);
  const auto beyond = verification::grade(half, table);
  for (const auto& error : beyond[0].errors) BOOST_TEST(error->linf < 1e-9);
}

BOOST_AUTO_TEST_CASE(without_a_reference_there_is_no_grade) {
  Problem long_run = problem;
  long_run.column.near = NearEnd::sealed_traction;
  long_run.column.far = FarEnd::rigid_drained;
  PointTable table = exact_points();
  table.profiles[0].time = 1.0;
  BOOST_CHECK_THROW(verification::grade(long_run, table), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
