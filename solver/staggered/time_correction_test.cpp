#include "solver/staggered/time_correction.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/problem/problem_fixtures.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(time_correction)

namespace {

// One free node under forces f(τ) = f + τ f′ + τ²/2 f″, times around 0.
constexpr double f_solid = 1.0, f_fluid = -0.7;
constexpr double rate_solid = 0.8e6, rate_fluid = 1.3e6;
constexpr double second_solid = -0.6e12, second_fluid = 0.9e12;

Problem free_problem(double permeability) {
  Problem problem = fixtures::paper_problem();
  problem.material.intrinsic_permeability = permeability;
  problem.column.far = FarEnd::free_drained;
  return problem;
}

struct Velocities {
  double solid;
  double fluid;
};

// From rest at `from` to `to`: Simpson's rule on the exact solution of the relative motion.
Velocities exact(const Material& m, double from, double to) {
  const double rho_s = m.solid_partial_density();
  const double rho_f = m.fluid_partial_density();
  const auto at = [](double f, double rate, double second, double t) {
    return f + t * (rate + 0.5 * t * second);
  };
  const int count = 2000;
  double common = 0.0;
  double relative = 0.0;
  for (int k = 0; k <= count; ++k) {
    const double t = from + (to - from) * k / count;
    const double weight = (k == 0 || k == count ? 1.0
                           : k % 2 == 1         ? 4.0
                                                : 2.0) *
                          (to - from) / (3.0 * count);
    const double fs = at(f_solid, rate_solid, second_solid, t);
    const double ff = at(f_fluid, rate_fluid, second_fluid, t);
    common += weight * (fs + ff) / (rho_s + rho_f);
    relative += weight * (ff / rho_f - fs / rho_s) * std::exp(-m.relaxation_rate() * (to - t));
  }
  return {common - rho_f / (rho_s + rho_f) * relative, common + rho_s / (rho_s + rho_f) * relative};
}

// The same by one corrected step, or its first half; the largest error of both velocities.
double error_of_step(double permeability, double dt, StepPart part) {
  const Problem problem = free_problem(permeability);
  constexpr std::size_t nodes = 3;
  TimeCorrection correction(problem, dt, nodes);
  BothPhases forces;
  BothPhases second;
  BothPhases increments;
  for (auto* values : {&forces, &second, &increments}) values->assign(nodes);
  correction.force_rates.solid.assign(nodes, rate_solid - 0.5 * dt * second_solid);
  correction.force_rates.fluid.assign(nodes, rate_fluid - 0.5 * dt * second_fluid);
  forces.solid.assign(nodes, f_solid);
  forces.fluid.assign(nodes, f_fluid);
  second.solid.assign(nodes, dt * second_solid);
  second.fluid.assign(nodes, dt * second_fluid);
  correction.correct(forces, second, part, nodes);
  const bool whole = part == StepPart::whole;
  std::vector<double> solid(nodes, 0.0);
  std::vector<double> fluid(nodes, 0.0);
  VelocityUpdate(problem, whole ? dt : 0.5 * dt)
      .find_increments(forces, {0.0, 0.0, 0.0}, nodes, solid, fluid, increments);
  const Velocities truth = exact(problem.material, -0.5 * dt, whole ? 0.5 * dt : 0.0);
  return std::max(std::abs(increments.solid[1] - truth.solid),
                  std::abs(increments.fluid[1] - truth.fluid));
}

BOOST_AUTO_TEST_CASE(without_drag_forces_of_second_degree_are_integrated_exactly) {
  for (const StepPart part : {StepPart::whole, StepPart::first_half}) {
    BOOST_TEST(error_of_step(1e3, 1e-6, part) < 1e-20);
  }
}

BOOST_AUTO_TEST_CASE(with_drag_the_error_of_a_step_is_of_fifth_order) {
  // θ = 0.2 and 0.1: the rest comes from the curvature of the forces alone.
  const double coarse = error_of_step(2.5e-12, 1e-6, StepPart::whole);
  const double fine = error_of_step(2.5e-12, 0.5e-6, StepPart::whole);
  BOOST_TEST(std::log2(coarse / fine) > 4.7);
  // The half step is taken once, at the end: one order less will do.
  const double coarse_half = error_of_step(2.5e-12, 1e-6, StepPart::first_half);
  const double fine_half = error_of_step(2.5e-12, 0.5e-6, StepPart::first_half);
  BOOST_TEST(std::log2(coarse_half / fine_half) > 3.7);
}

BOOST_AUTO_TEST_CASE(stiff_drag_keeps_the_correction_bounded) {
  for (const double permeability : {1e-14, 1e-17, 1e-20}) {
    const Problem problem = free_problem(permeability);
    TimeCorrection correction(problem, 1e-6, 3);
    correction.force_rates.solid.assign(3, 1e6);
    correction.force_rates.fluid.assign(3, -1e6);
    BothPhases forces;
    BothPhases none;
    forces.assign(3);
    none.assign(3);
    correction.correct(forces, none, StepPart::whole, 3);
    // A rate times the step is 1.
    BOOST_TEST(std::abs(forces.solid[1]) < 1.0);
    BothPhases increments;
    BothPhases mean;
    increments.assign(3);
    mean.assign(3);
    increments.fluid.assign(3, 1.0);
    const std::vector<double> rest(3, 0.0);
    correction.find_mean_velocities(rest, rest, increments, 0.0, 3, mean);
    BOOST_TEST(std::abs(mean.solid[1]) < 0.1);
    BOOST_TEST(std::abs(mean.fluid[1]) < 0.1);
  }
}

BOOST_AUTO_TEST_CASE(the_mean_velocity_of_a_parabola_is_exact_without_drag) {
  // v(τ) = v + τ²/2 v″: the mean over ± dt/2 is v + dt²/24 v″.
  const Problem problem = free_problem(1e6);
  const double dt = 1e-6;
  TimeCorrection correction(problem, dt, 3);
  correction.force_rates.solid.assign(3, 5e12 * problem.material.solid_partial_density());
  correction.force_rates.fluid.assign(3, -3e12 * problem.material.fluid_partial_density());
  BothPhases increments;
  BothPhases mean;
  increments.assign(3);
  mean.assign(3);
  correction.find_mean_velocities({1.0, 1.0, 1.0}, {2.0, 2.0, 2.0}, increments, 0.0, 3, mean);
  BOOST_TEST(mean.solid[1] == 1.0 + 5.0 / 24.0, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(mean.fluid[1] == 2.0 - 3.0 / 24.0, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(prescribed_ends_keep_their_mean) {
  Problem problem = fixtures::paper_problem();
  problem.column.near = NearEnd::velocity;
  TimeCorrection correction(problem, 1e-6, 3);
  correction.force_rates.solid.assign(3, 1e9);
  BothPhases increments;
  BothPhases mean;
  increments.assign(3);
  mean.assign(3);
  correction.find_mean_velocities({1.0, 1.0, 0.0}, {1.0, 1.0, 0.0}, increments, 0.75, 3, mean);
  BOOST_TEST(mean.solid[0] == 0.75);
  BOOST_TEST(mean.fluid[0] == 0.75);
  BOOST_TEST(mean.solid[2] == 0.0);
  BOOST_TEST(mean.fluid[2] == 0.0);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
