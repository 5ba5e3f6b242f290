#include "reference/fifty_digits.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "reference/field_fixtures.hpp"
#include "reference/problem/problem_fixtures.hpp"
#include "reference/random_points.hpp"
#include "reference/tables/truth.hpp"

BOOST_AUTO_TEST_SUITE(fifty_digits)

using namespace porowave;
using fixtures::distance;

namespace {

Fields fifty_digits_at(const Problem& problem, double x, double t) {
  return fixtures::fifty_digits(problem, x, t).value;
}

/// By how much the fields may change when decimal numbers of a row become doubles: twice the sum
/// over the inputs of what half a unit in the last place does, measured over a hundred of them.
double rounding_of_inputs(const fixtures::TruthRow& row) {
  const auto changed = [&](auto change) {
    fixtures::TruthRow other = row;
    change(other);
    return distance(row.problem, fifty_digits_at(row.problem, row.x, row.t),
                    fifty_digits_at(other.problem, other.x, other.t)) /
           100.0;
  };
  constexpr double factor = 1.0 + 100.0 * std::numeric_limits<double>::epsilon();
  double sum = changed([](auto& r) { r.x *= factor; }) + changed([](auto& r) { r.t *= factor; });
  for (const auto member : {&Material::porosity, &Material::grain_density, &Material::fluid_density,
                            &Material::constrained_modulus, &Material::fluid_bulk_modulus,
                            &Material::intrinsic_permeability, &Material::fluid_viscosity}) {
    sum += changed([member](auto& r) { r.problem.material.*member *= factor; });
  }
  return sum;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_row_of_the_truth_tables) {
  double worst = 0.0;
  double worst_agreement = 0.0;
  for (const char* table : {"truth_step.csv", "truth_smooth.csv"}) {
    for (const auto& row :
         fixtures::read_truth(std::string(POROWAVE_SOURCE_DIR) + "/reference/tables/" + table)) {
      const auto exact = fixtures::fifty_digits(row.problem, row.x, row.t);
      const double error = distance(row.problem, exact.value, row.value);
      double allowed = 1e-15 + row.uncertainty;
      if (error > allowed) allowed += rounding_of_inputs(row);
      BOOST_TEST_CONTEXT(row.id) {
        BOOST_TEST(exact.agreement < 1e-18);
        BOOST_TEST(error <= allowed);
      }
      worst = std::max(worst, error);
      worst_agreement = std::max(worst_agreement, exact.agreement);
    }
  }
  BOOST_TEST_MESSAGE("truth tables: worst error " << worst << ", worst agreement "
                                                  << worst_agreement);
}

// Almost no drag: two waves of d'Alembert, each with the ratio of velocities of its mode.
BOOST_AUTO_TEST_CASE(without_drag_a_step_runs_through_as_two_plateaus) {
  Problem problem = fixtures::paper_problem();
  problem.column = {std::nullopt, NearEnd::drained_traction, FarEnd::half_space};
  problem.material.intrinsic_permeability = 1e12;
  const auto& m = problem.material;
  const WaveSpeeds c = wave_speeds(m);
  const double t = 4e-5;
  // From the fluid's equation of motion, c^2 m_f v_f = K n_s n_f v_s + K n_f^2 v_f.
  const auto ratio = [&](double speed) {
    const double coupling = m.storage_modulus() * m.solid_fraction() * m.porosity;
    const double fluid = m.storage_modulus() * m.porosity * m.porosity;
    return (speed * speed * m.fluid_partial_density() - fluid) / coupling;  // vs/vf
  };
  const auto behind = fifty_digits_at(problem, 0.5 * c.p2 * t, t);
  BOOST_TEST(behind.effective_stress == -1.0, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(std::abs(behind.pore_pressure) < 1e-14);
  const auto between = fifty_digits_at(problem, 0.5 * (c.p1 + c.p2) * t, t);
  BOOST_TEST(between.solid_velocity == ratio(c.p1) * between.fluid_velocity,
             boost::test_tools::tolerance(1e-13));
  BOOST_TEST(between.effective_stress == -m.constrained_modulus / c.p1 * between.solid_velocity,
             boost::test_tools::tolerance(1e-13));
  // What is missing to the values at the end is a P2 wave.
  const double solid = behind.solid_velocity - between.solid_velocity;
  const double fluid = behind.fluid_velocity - between.fluid_velocity;
  BOOST_TEST(solid == ratio(c.p2) * fluid, boost::test_tools::tolerance(1e-13));
  BOOST_TEST(
      behind.effective_stress - between.effective_stress == -m.constrained_modulus / c.p2 * solid,
      boost::test_tools::tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(nothing_before_the_first_arrival_and_the_value_behind_on_it) {
  for (const LoadShape shape : {LoadShape::step, LoadShape::sin4_pulse, LoadShape::ricker}) {
    Problem problem = fixtures::paper_problem(Load(shape, 1.0, 1e-5));
    const double front = 0.05 / wave_speeds(problem.material).p1;
    const Fields before = fifty_digits_at(problem, 0.05, front * (1 - 1e-14));
    BOOST_TEST(before.effective_stress == 0.0);
    BOOST_TEST(before.fluid_velocity == 0.0);
    const Fields after = fifty_digits_at(problem, 0.05, front);
    BOOST_TEST((std::abs(after.effective_stress) > 0.1) == (shape == LoadShape::step));
  }
}

BOOST_AUTO_TEST_CASE(two_contours_agree_at_random_points) {
  fixtures::RandomPoints points(20);
  double worst = 0.0;
  for (int i = 0; i < 40; ++i) {
    const auto point = points.next();
    const auto exact = fixtures::fifty_digits(point.problem, point.x, point.t);
    BOOST_TEST_CONTEXT("point " << i << ", " << point.place) {
      BOOST_TEST(exact.agreement < 1e-18);
    }
    worst = std::max(worst, exact.agreement);
  }
  BOOST_TEST_MESSAGE("random points: worst agreement " << worst);
}

BOOST_AUTO_TEST_SUITE_END()
