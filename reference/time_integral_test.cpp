#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/field_fixtures.hpp"
#include "reference/problem/problem_fixtures.hpp"
#include "reference/random_problems.hpp"
#include "reference/smooth_pieces.hpp"
#include "reference/time_slice.hpp"

BOOST_AUTO_TEST_SUITE(time_integral)

using namespace porowave;
using namespace porowave::reference;
namespace tt = boost::test_tools;
using fixtures::as_array;
using fixtures::derivative;

namespace {

/// Every shape, as long as a wave takes to cross the column.
Load load_of(LoadShape shape, double crossing) {
  if (shape != LoadShape::table) return {shape, 3.0, 0.7 * crossing};
  return {3.0, {0.0, 0.2 * crossing, 0.4 * crossing, 0.4 * crossing}, {0.5, 1.0, -0.5, 0.25}};
}

Problem problem_of(fixtures::RandomProblems& random, int ends, LoadShape shape, double stiffness) {
  Problem problem =
      random.next(stiffness, Load(), static_cast<NearEnd>(ends % 4), static_cast<FarEnd>(ends / 4));
  const double length = problem.column.length.value_or(1.0);
  problem.load = load_of(shape, length / wave_speeds(problem.material).p1);
  return problem;
}

/// Middle of the longest smooth piece, and its length.
std::pair<double, double> smooth_place(const ColumnSolution& solution, double t, double length) {
  const double end = std::min(length, solution.modes().speed(0) * t);
  const auto ends = reference::smooth_pieces(solution, t, end);
  std::pair<double, double> best;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double size = ends[i + 1] - ends[i];
    if (size > best.second) best = {0.5 * (ends[i] + ends[i + 1]), size};
  }
  return best;
}

/// How far stress and pressure are from what the strains make of them, as a share of the load.
double of_strains(const ColumnSolution& solution, double x, double t, double step) {
  const Problem& problem = solution.problem();
  const Material& m = problem.material;
  TimeSlice slice(solution, t, TimeIntegral::once);
  const auto strain = derivative([&](double dx) { return slice.at(x + dx).value; }, step);
  const Fields f = solution.at(x, t).value;
  const double squeezed = m.solid_fraction() * strain[2] + m.porosity * strain[3];
  return std::max(std::abs(m.constrained_modulus * strain[2] - f.effective_stress),
                  std::abs(m.storage_modulus() * squeezed + f.pore_pressure)) /
         problem.stress_scale();
}

/// How far the rates of the integrals are from the fields, as a share of the load.
double of_rates(const ColumnSolution& solution, double x, double t, double step) {
  const Problem& problem = solution.problem();
  const auto rate =
      derivative([&](double dt) { return solution.time_integral(x, t + dt).value; }, step);
  const auto fields = as_array(solution.at(x, t).value);
  double worst = 0.0;
  for (std::size_t f = 0; f < 4; ++f) {
    const double scale = f < 2 ? problem.stress_scale() : problem.velocity_scale();
    worst = std::max(worst, std::abs(rate[f] - fields[f]) / scale);
  }
  return worst;
}

}  // namespace

BOOST_AUTO_TEST_CASE(strains_and_rates_fit_the_fields_for_all_ends_and_loads) {
  fixtures::RandomProblems random(11);
  double worst_strain = 0.0;
  double worst_rate = 0.0;
  for (int trial = 0; trial < 16 * 6; ++trial) {
    for (const double stiffness : {0.1, 5.0, 1e3}) {
      const auto shape = static_cast<LoadShape>(trial % 6);
      const Problem problem = problem_of(random, trial / 6, shape, stiffness);
      const double length = problem.column.length.value_or(1.0);
      const ColumnSolution solution(problem);
      const double t = random.uniform(0.5, 2.5) * length / solution.modes().speed(0);
      const auto [x, size] = smooth_place(solution, t, length);
      // The wavelet is much shorter than its duration.
      const double step = size / (shape == LoadShape::ricker ? 4000.0 : 400.0);
      const double strain = of_strains(solution, x, t, step);
      const double rate = of_rates(solution, x, t, step / solution.modes().speed(0));
      BOOST_TEST_CONTEXT(name(shape) << " " << name(problem.column.near) << " "
                                     << name(problem.column.far) << " " << stiffness) {
        BOOST_TEST(strain < 2e-7);
        BOOST_TEST(rate < 2e-7);
      }
      worst_strain = std::max(worst_strain, strain);
      worst_rate = std::max(worst_rate, rate);
    }
  }
  BOOST_TEST_MESSAGE("worst of strains " << worst_strain << ", of rates " << worst_rate);
}

BOOST_AUTO_TEST_CASE(rigid_ends_stay_where_they_are_and_pistons_go_where_they_are_driven) {
  fixtures::RandomProblems random(12);
  for (int trial = 0; trial < 8 * 6; ++trial) {
    const auto shape = static_cast<LoadShape>(trial % 6);
    const Problem problem = problem_of(random, trial / 6, shape, random.log_uniform(0.1, 1e4));
    const ColumnSolution solution(problem);
    const double t = random.uniform(0.5, 5.0) * *problem.column.length / solution.modes().speed(0);
    const auto end = solution.time_integral(*problem.column.length, t);
    BOOST_TEST(std::abs(end.value.solid_velocity) <= end.error.solid_velocity);
    if (problem.column.far == FarEnd::rigid_sealed) {
      BOOST_TEST(std::abs(end.value.fluid_velocity) <= end.error.fluid_velocity);
    } else {
      BOOST_TEST(std::abs(end.value.pore_pressure) <= end.error.pore_pressure);
    }
    const auto start = solution.time_integral(0.0, t);
    BOOST_TEST(start.error.solid_velocity < 1e-11 * problem.velocity_scale() * t);
    const double impulse = problem.load.impulse(t);
    if (problem.column.near == NearEnd::velocity) {
      BOOST_TEST(std::abs(start.value.solid_velocity - impulse) <= start.error.solid_velocity);
      BOOST_TEST(std::abs(start.value.fluid_velocity - impulse) <= start.error.fluid_velocity);
    } else if (problem.column.near == NearEnd::drained_traction) {
      BOOST_TEST(std::abs(start.value.effective_stress + impulse) <= start.error.effective_stress);
    }
  }
}

BOOST_AUTO_TEST_CASE(displacements_are_continuous_across_fronts) {
  fixtures::RandomProblems random(13);
  for (int trial = 0; trial < 16; ++trial) {
    const Problem problem = problem_of(random, trial, LoadShape::step, 0.5);
    const double length = problem.column.length.value_or(1.0);
    const ColumnSolution solution(problem);
    const double c = solution.modes().speed(0);
    const double t = 1.3 * length / c;
    const double step = 1e-9 * length;
    for (const double front : solution.fronts(t)) {
      if (front < step || front > length - step) continue;
      for (const double side : {-step, step}) {
        const auto here = solution.time_integral(front, t);
        const auto beside = solution.time_integral(front + side, t);
        // On a front the fields are bounded by their jump only; their integrals lose nothing.
        BOOST_TEST(here.error.fluid_velocity < 1e-11 * problem.velocity_scale() * t);
        const auto a = as_array(here.value);
        const auto b = as_array(beside.value);
        for (std::size_t f = 0; f < 4; ++f) {
          const double scale = f < 2 ? problem.stress_scale() : problem.velocity_scale();
          BOOST_TEST(std::abs(a[f] - b[f]) < 50.0 * scale * step / solution.modes().speed(1));
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(nothing_has_moved_before_the_first_arrival) {
  const ColumnSolution solution(fixtures::paper_problem());
  const double t = 2e-5;
  const double ahead = solution.modes().speed(0) * t * (1 + 1e-12);
  for (const auto& fields : {solution.time_integral(ahead, t), solution.time_integral(0.0, 0.0),
                             solution.time_integral(0.05, -1.0)}) {
    BOOST_TEST(as_array(fields.value) == (std::array<double, 4>{}), tt::per_element());
    BOOST_TEST(as_array(fields.error) == (std::array<double, 4>{}), tt::per_element());
  }
}

BOOST_AUTO_TEST_CASE(a_column_at_rest_again_is_as_short_as_its_load_makes_it) {
  Problem problem = fixtures::paper_problem(Load(LoadShape::step, 7.0));
  // A skeleton so soft, and drag such, that waves die soon.
  problem.material.constrained_modulus = 1e9;
  problem.material.intrinsic_permeability = 2e-11;
  const Material& m = problem.material;
  // Drained: only the skeleton carries; the fluid has left through the loaded end.
  const double drained = 7.0 * 0.1 / m.constrained_modulus;
  const auto late = ColumnSolution(problem).time_integral(0.0, 0.03);
  BOOST_TEST(late.value.solid_velocity == drained, tt::tolerance(1e-8));
  BOOST_TEST(late.value.fluid_velocity == -drained * m.solid_fraction() / m.porosity,
             tt::tolerance(1e-8));
}

BOOST_AUTO_TEST_SUITE_END()
