#include "reference/column_solution.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

#include "reference/field_fixtures.hpp"
#include "reference/problem/errors.hpp"
#include "reference/problem/problem_fixtures.hpp"
#include "reference/random_problems.hpp"

BOOST_AUTO_TEST_SUITE(column_solution)

using namespace porowave;
using namespace porowave::reference;
namespace tt = boost::test_tools;
using fixtures::as_array;
using fixtures::derivative;

namespace {

/// What is left of the four governing equations (problem.hpp), each relative to `size`.
double residual(const ColumnSolution& solution, double x, double t, double period) {
  const Problem& problem = solution.problem();
  const Material& m = problem.material;
  const double ns = m.solid_fraction();
  const double nf = m.porosity;
  const double c = solution.modes().speed(1);
  const auto ft = derivative([&](double dt) { return solution.at(x, t + dt).value; }, period / 4e3);
  const auto fx =
      derivative([&](double dx) { return solution.at(x + dx, t).value; }, c * period / 4e3);
  const Fields f = solution.at(x, t).value;
  const double drag = m.drag() * (f.fluid_velocity - f.solid_velocity);
  const double stress_rate = problem.stress_scale() / period;
  const double force = stress_rate / c;
  return std::max(
      {std::abs(m.solid_partial_density() * ft[2] - fx[0] + ns * fx[1] - drag) / force,
       std::abs(m.fluid_partial_density() * ft[3] + nf * fx[1] + drag) / force,
       std::abs(ft[0] - m.constrained_modulus * fx[2]) / stress_rate,
       std::abs(ft[1] + m.storage_modulus() * (ns * fx[2] + nf * fx[3])) / stress_rate});
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_governing_equations_hold_for_every_pair_of_ends) {
  fixtures::RandomProblems random(1);
  for (int near = 0; near < 4; ++near) {
    for (int far = 0; far < 4; ++far) {
      for (const double stiffness : {0.1, 3.0, 20.0}) {
        Problem problem =
            random.next(stiffness, Load(), static_cast<NearEnd>(near), static_cast<FarEnd>(far));
        const double length = problem.column.length.value_or(1.0);
        const double crossing = length / wave_speeds(problem.material).p1;
        problem.load = Load(LoadShape::ricker, 5.0, 0.8 * crossing);
        const ColumnSolution solution(problem);
        const double worst =
            std::max({residual(solution, 0.21 * length, 1.05 * crossing, 0.8 * crossing),
                      residual(solution, 0.83 * length, 1.40 * crossing, 0.8 * crossing)});
        BOOST_TEST_CONTEXT(name(problem.column.near)
                           << " " << name(problem.column.far) << " " << stiffness) {
          BOOST_TEST(worst < 2e-6);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(both_ends_show_what_is_prescribed_there) {
  fixtures::RandomProblems random(2);
  for (int trial = 0; trial < 32; ++trial) {
    const auto near = static_cast<NearEnd>(trial % 4);
    const auto far = static_cast<FarEnd>(trial / 4 % 3);
    Problem problem = random.next(random.log_uniform(0.1, 20), Load(), near, far);
    const double crossing = *problem.column.length / wave_speeds(problem.material).p1;
    problem.load = Load(LoadShape::sin4_pulse, 3.0, 2.0 * crossing);
    const double t = 1.7 * crossing;
    const ColumnSolution solution(problem);
    const Fields start = solution.at(0.0, t).value;
    const Fields end = solution.at(*problem.column.length, t).value;
    const double q = problem.load.value(t);
    const double stress = 1e-12 * problem.stress_scale();
    const double velocity = 1e-12 * problem.velocity_scale();
    if (near == NearEnd::drained_traction) {
      BOOST_TEST(std::abs(start.effective_stress + q) < stress);
      BOOST_TEST(std::abs(start.pore_pressure) < stress);
    } else if (near == NearEnd::fluid_pressure) {
      BOOST_TEST(std::abs(start.effective_stress) < stress);
      BOOST_TEST(std::abs(start.pore_pressure - q) < stress);
    } else if (near == NearEnd::sealed_traction) {
      BOOST_TEST(std::abs(start.effective_stress - start.pore_pressure + q) < stress);
      BOOST_TEST(std::abs(start.solid_velocity - start.fluid_velocity) < velocity);
    } else {
      BOOST_TEST(std::abs(start.solid_velocity - q) < velocity);
      BOOST_TEST(std::abs(start.fluid_velocity - q) < velocity);
    }
    if (far == FarEnd::free_drained) {
      BOOST_TEST(std::abs(end.effective_stress) < stress);
    } else {
      BOOST_TEST(std::abs(end.solid_velocity) < velocity);
    }
    if (far == FarEnd::rigid_sealed) {
      BOOST_TEST(std::abs(end.fluid_velocity) < velocity);
    } else {
      BOOST_TEST(std::abs(end.pore_pressure) < stress);
    }
  }
}

BOOST_AUTO_TEST_CASE(nothing_moves_before_the_first_arrival) {
  const ColumnSolution solution(fixtures::paper_problem());
  const double t = 2e-5;
  const double front = solution.modes().speed(0) * t;
  for (const double x : {front * (1 + 1e-12), 0.07, 0.1}) {
    const BoundedFields fields = solution.at(x, t);
    BOOST_TEST(as_array(fields.value) == (std::array<double, 4>{}), tt::per_element());
    BOOST_TEST(as_array(fields.error) == (std::array<double, 4>{}), tt::per_element());
  }
  BOOST_TEST(solution.at(front * (1 - 1e-12), t).value.effective_stress < -1e-3);
  BOOST_TEST(as_array(solution.at(0.0, -1.0).value) == (std::array<double, 4>{}),
             tt::per_element());
  BOOST_TEST(solution.at(0.0, 0.0).value.effective_stress == -1.0, tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(on_a_front_the_bound_covers_the_jump) {
  const ColumnSolution solution(fixtures::paper_problem());
  const double t = 2e-5;
  const double front = solution.modes().speed(0) * t;
  const double jump = std::abs(solution.at(front * (1 - 1e-12), t).value.effective_stress);
  BOOST_TEST(solution.at(front, t).error.effective_stress >= 0.99 * jump);
  BOOST_TEST(solution.at(front * (1 - 1e-12), t).error.effective_stress < 1e-12);
}

BOOST_AUTO_TEST_CASE(loads_superpose) {
  // A block is a step less a later step; a table with the same corners is the same block.
  const double T = 1.3e-5;
  const ColumnSolution step(fixtures::paper_problem());
  const ColumnSolution block(fixtures::paper_problem(Load(LoadShape::block, 1.0, T)));
  const ColumnSolution table(fixtures::paper_problem(Load(1.0, {0.0, T, T}, {1.0, 1.0, 0.0})));
  for (const double x : {0.0, 0.011, 0.04, 0.077, 0.1}) {
    const double t = 6e-5;
    const auto a = as_array(step.at(x, t).value);
    const auto b = as_array(step.at(x, t - T).value);
    const auto whole = as_array(block.at(x, t).value);
    const auto same = as_array(table.at(x, t).value);
    const auto bound = as_array(block.at(x, t).error);
    for (std::size_t f = 0; f < 4; ++f) {
      BOOST_TEST(std::abs(whole[f] - (a[f] - b[f])) <= 3 * bound[f]);
      BOOST_TEST(std::abs(whole[f] - same[f]) <= 3 * bound[f]);
    }
  }
}

BOOST_AUTO_TEST_CASE(without_drag_waves_travel_unchanged) {
  // d'Alembert: sigma' and p are steps of the frozen modes, whatever the distance travelled.
  Problem problem = fixtures::paper_problem();
  problem.column = {std::nullopt, NearEnd::drained_traction, FarEnd::half_space};
  problem.material.intrinsic_permeability = 1e6;
  const ColumnSolution solution(problem);
  const double t = 4e-5;
  const double between = 0.5 * t * (solution.modes().speed(0) + solution.modes().speed(1));
  const Fields behind_both = solution.at(0.3 * between, t).value;
  const Fields near_front = solution.at(0.999 * t * solution.modes().speed(0), t).value;
  const Fields behind_one = solution.at(between, t).value;
  BOOST_TEST(behind_both.effective_stress == -1.0, tt::tolerance(1e-10));
  BOOST_TEST(std::abs(behind_both.pore_pressure) < 1e-10);
  BOOST_TEST(behind_one.effective_stress == near_front.effective_stress, tt::tolerance(1e-10));
  // Momentum of the fast wave alone: traction jump = density * speed * velocity jump, per phase.
  const Material& m = problem.material;
  const double c = solution.modes().speed(0);
  BOOST_TEST(m.fluid_partial_density() * c * behind_one.fluid_velocity ==
                 m.porosity * behind_one.pore_pressure,
             tt::tolerance(1e-9));
  BOOST_TEST(m.solid_partial_density() * c * behind_one.solid_velocity ==
                 m.solid_fraction() * behind_one.pore_pressure - behind_one.effective_stress,
             tt::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(fronts_are_where_the_fields_jump) {
  const ColumnSolution solution(fixtures::paper_problem());
  const double t = 6e-5;  // P1 has been reflected, P2 has not arrived
  const double c1 = solution.modes().speed(0);
  const double c2 = solution.modes().speed(1);
  const auto fronts = solution.fronts(t);
  BOOST_REQUIRE(fronts.size() == 2u);
  BOOST_TEST(fronts[0] == std::min(c2 * t, 0.2 - c1 * t), tt::tolerance(1e-12));
  BOOST_TEST(fronts[1] == std::max(c2 * t, 0.2 - c1 * t), tt::tolerance(1e-12));
  for (const double front : fronts) {
    const double before = solution.at(front - 1e-10, t).value.pore_pressure;
    const double after = solution.at(front + 1e-10, t).value.pore_pressure;
    BOOST_TEST(std::abs(after - before) > 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(points_outside_of_the_column_are_refused) {
  const ColumnSolution solution(fixtures::paper_problem());
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(solution.at(-1e-9, 1e-5), InputError);
  BOOST_CHECK_THROW(solution.at(0.1001, 1e-5), InputError);
  BOOST_CHECK_THROW(solution.at(nan, 1e-5), InputError);
  BOOST_CHECK_THROW(solution.at(0.05, nan), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
