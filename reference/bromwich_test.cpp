#include "reference/bromwich.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "reference/column_solution.hpp"
#include "reference/field_fixtures.hpp"
#include "reference/problem/errors.hpp"
#include "reference/problem/problem_fixtures.hpp"
#include "reference/random_problems.hpp"
#include "reference/tables/truth.hpp"

BOOST_AUTO_TEST_SUITE(bromwich)

using namespace porowave;
using namespace porowave::reference;
namespace tt = boost::test_tools;
using fixtures::as_array;
using fixtures::distance;
using fixtures::largest_share;

namespace {

/// Any load whose scale in time is `time`, and any pair of ends.
Problem random_problem(fixtures::RandomProblems& random, double stiffness) {
  const auto near = static_cast<NearEnd>(random.index(4));
  const auto far = static_cast<FarEnd>(random.index(4));
  Problem problem = random.next(stiffness, Load(), near, far);
  const double time = problem.column.length.value_or(1.0) / wave_speeds(problem.material).p1 *
                      random.log_uniform(0.1, 3.0);
  const auto shape = static_cast<LoadShape>(random.index(6));
  problem.load =
      shape == LoadShape::table
          ? Load(2.5, {0.0, 0.3 * time, 0.5 * time, 0.5 * time, time}, {0.5, 1, -0.5, 0.2, 0.7})
          : Load(shape, 2.5, time);
  return problem;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_series_in_1_over_s_is_the_expansion_of_the_fields_for_large_s) {
  fixtures::RandomProblems random(3);
  for (int near = 0; near < 4; ++near) {
    for (int far = 0; far < 3; ++far) {
      const Problem problem =
          random.next(3.0, Load(), static_cast<NearEnd>(near), static_cast<FarEnd>(far));
      const line::Medium medium(problem.material);
      const double length = *problem.column.length;
      const double rate = problem.material.relaxation_rate();
      const auto images =
          line::images_until(problem.column, medium, 0.4 * length, 3.0 * length / medium.speed[0]);
      for (const auto& image : images) {
        const auto series = line::image_fields(problem.column, medium, image, Series::variable());
        const auto remainder = [&](double u) {
          const auto fields =
              line::image_fields(problem.column, medium, image, line::Complex(u, 0.0));
          std::array<double, 4> rest;
          for (std::size_t f = 0; f < 4; ++f) {
            const auto& c = series[f].c;
            rest[f] = std::abs(fields[f] - (c[0] + u * (c[1] + u * (c[2] + u * c[3]))));
          }
          return rest;
        };
        const double u = 5e-4 / rate;
        const auto coarse = remainder(2.0 * u);
        const auto fine = remainder(u);
        for (std::size_t f = 0; f < 4; ++f) {
          // What is left is of order u^4, or rounding.
          BOOST_TEST(fine[f] <= coarse[f] / 12.0 + 1e-13 * std::abs(series[f].c[0]));
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(without_drag_waves_travel_unchanged) {
  Problem problem = fixtures::paper_problem();
  problem.column = {std::nullopt, NearEnd::drained_traction, FarEnd::half_space};
  problem.material.intrinsic_permeability = 1e6;
  const BromwichSolution solution(problem);
  const auto [fast, slow] = wave_speeds(problem.material);
  const double t = 4e-5;
  const Fields behind_both = solution.at(0.5 * slow * t, t).value;
  BOOST_TEST(behind_both.effective_stress == -1.0, tt::tolerance(1e-9));
  BOOST_TEST(std::abs(behind_both.pore_pressure) < 1e-9);
  const Fields a = solution.at(1.001 * slow * t, t).value;
  const Fields b = solution.at(0.999 * fast * t, t).value;
  BOOST_TEST(distance(problem, a, b) < 1e-9);
  // Momentum of the fluid in the fast wave alone.
  const Material& m = problem.material;
  BOOST_TEST(m.fluid_partial_density() * fast * a.fluid_velocity == m.porosity * a.pore_pressure,
             tt::tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(nothing_moves_before_the_first_arrival) {
  const BromwichSolution solution(fixtures::paper_problem());
  const double t = 2e-5;
  const double front = wave_speeds(solution.problem().material).p1 * t;
  for (const double x : {front * (1 + 1e-12), 0.07, 0.1}) {
    BOOST_TEST(as_array(solution.at(x, t).value) == (std::array<double, 4>{}), tt::per_element());
    BOOST_TEST(as_array(solution.at(x, t).error) == (std::array<double, 4>{}), tt::per_element());
  }
  BOOST_TEST(solution.at(front * (1 - 1e-12), t).value.effective_stress < -1e-3);
  BOOST_TEST(solution.at(front, t).error.effective_stress > 1e-3);
}

BOOST_AUTO_TEST_CASE(every_row_of_the_truth_tables_is_within_1e_8_of_the_load) {
  double worst = 0.0;
  int rows = 0;
  for (const char* table : {"truth_step.csv", "truth_smooth.csv"}) {
    for (const auto& row :
         fixtures::read_truth(std::string(POROWAVE_SOURCE_DIR) + "/reference/tables/" + table)) {
      const auto solution = BromwichSolution(row.problem).at(row.x, row.t);
      const double error = distance(row.problem, solution.value, row.value);
      BOOST_TEST_CONTEXT(row.id) {
        BOOST_TEST(error <= 1e-8);
        BOOST_TEST(error <= largest_share(row.problem, solution.error) + row.uncertainty);
        BOOST_TEST(largest_share(row.problem, solution.error) <= 1e-5);
      }
      worst = std::max(worst, error);
      ++rows;
    }
  }
  BOOST_TEST(rows == 100);
  BOOST_TEST_MESSAGE("truth tables by the Bromwich integral: " << rows << " rows, worst error "
                                                               << worst << " of the load");
}

BOOST_AUTO_TEST_CASE(random_problems_agree_with_the_contour_to_1e_8) {
  fixtures::RandomProblems random(11);
  double worst = 0.0;
  int compared = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const Problem problem = random_problem(random, random.log_uniform(0.1, 50.0));
    const double length = problem.column.length.value_or(1.0);
    const double x = length * random.uniform(0.0, 1.0);
    const double t = length / wave_speeds(problem.material).p1 * random.uniform(0.1, 4.0);
    const BoundedFields contour = ColumnSolution(problem).at(x, t);
    if (!(largest_share(problem, contour.error) < 1e-10)) continue;
    ++compared;
    const BoundedFields solution = BromwichSolution(problem).at(x, t);
    const double error = distance(problem, solution.value, contour.value);
    BOOST_TEST_CONTEXT(name(problem.column.near)
                       << " " << name(problem.column.far) << " " << name(problem.load.shape())) {
      BOOST_TEST(error <= 1e-8);
      BOOST_TEST(error <=
                 largest_share(problem, solution.error) + largest_share(problem, contour.error));
    }
    worst = std::max(worst, error);
  }
  BOOST_TEST(compared >= 95);
  BOOST_TEST_MESSAGE("Bromwich integral and contour: " << compared << " problems, worst difference "
                                                       << worst << " of the load");
}

BOOST_AUTO_TEST_CASE(what_cannot_be_done_is_said) {
  const Problem problem = fixtures::paper_problem();
  BOOST_CHECK_THROW(BromwichSolution(problem, 0.0), InputError);
  BOOST_CHECK_THROW(BromwichSolution(problem, 1e-14), InputError);
  BOOST_CHECK_THROW(BromwichSolution(problem, std::nan("")), InputError);
  const BromwichSolution solution(problem);
  BOOST_CHECK_THROW(solution.at(-1e-9, 1e-5), InputError);
  BOOST_CHECK_THROW(solution.at(0.1001, 1e-5), InputError);
  BOOST_CHECK_THROW(solution.at(0.05, std::nan("")), InputError);
  BOOST_TEST(as_array(solution.at(0.0, -1.0).value) == (std::array<double, 4>{}),
             tt::per_element());
  // More than 600 images.
  const BoundedFields late = solution.at(0.05, 0.1);
  BOOST_TEST(std::isnan(late.value.effective_stress));
  BOOST_TEST(late.error.effective_stress == std::numeric_limits<double>::infinity());
}

BOOST_AUTO_TEST_SUITE_END()
