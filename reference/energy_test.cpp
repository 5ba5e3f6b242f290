#include "reference/energy.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/problem/problem_fixtures.hpp"
#include "reference/profile.hpp"
#include "reference/random_problems.hpp"

BOOST_AUTO_TEST_SUITE(energy)

using namespace porowave;
using namespace porowave::reference;
namespace tt = boost::test_tools;

namespace {

/// Energy that drag has used up until the last of `ends`, by quadrature over x and t; rates have
/// kinks where fronts meet each other or an end, which `ends` must contain.
double dissipated_by_quadrature(const ColumnSolution& solution, const std::vector<double>& ends) {
  const Problem& problem = solution.problem();
  const auto rate = [&](double t) {
    const Profile profile(solution, t,
                          problem.column.length.value_or(solution.modes().speed(0) * t));
    return problem.material.drag() * profile.integral([](const Fields& f) {
      const double relative = f.fluid_velocity - f.solid_velocity;
      return relative * relative;
    });
  };
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    sum += boost::math::quadrature::gauss<double, 20>::integrate(rate, ends[i], ends[i + 1]);
  }
  return sum;
}

bool sound(const EnergyBalance& balance) {
  return balance.kinetic.value >= 0.0 && balance.elastic.value >= 0.0 &&
         balance.dissipated.value >= -balance.dissipated.error;
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_is_missing_is_what_drag_has_used_up) {
  fixtures::RandomProblems random(31);
  double worst = 0.0;
  for (int near = 0; near < 4; ++near) {
    for (const auto far : {FarEnd::rigid_sealed, FarEnd::half_space}) {
      for (const double stiffness : {0.3, 10.0}) {
        Problem problem = random.next(stiffness, Load(), static_cast<NearEnd>(near), far);
        const ColumnSolution solution(problem);
        const double length = problem.column.length.value_or(1.0);
        const double t = 0.9 * length / solution.modes().speed(0);
        const EnergyBalance balance = energy_balance(solution, t);
        const double expected = dissipated_by_quadrature(solution, {0.0, 0.2 * t, t});
        const double difference =
            std::abs(balance.dissipated.value - expected) / balance.work.value;
        BOOST_TEST(difference < 1e-11, name(problem.column.near) << ' ' << stiffness);
        BOOST_TEST(expected > 0.0);
        worst = std::max(worst, difference);
      }
    }
  }
  BOOST_TEST_MESSAGE("worst difference, as a share of the work: " << worst);
}

BOOST_AUTO_TEST_CASE(it_closes_after_reflections_too) {
  const ColumnSolution solution(fixtures::paper_problem());
  const double c1 = solution.modes().speed(0);
  const double c2 = solution.modes().speed(1);
  const double t = 8e-5;  // the fast wave has come back and met the slow one
  const double expected =
      dissipated_by_quadrature(solution, {0.0, 4e-6, 0.1 / c1, 0.2 / (c1 + c2), t});
  const EnergyBalance balance = energy_balance(solution, t);
  BOOST_TEST(balance.dissipated.value == expected, tt::tolerance(1e-11));
  BOOST_TEST(balance.dissipated.error < 1e-11 * balance.work.value);
}

BOOST_AUTO_TEST_CASE(under_a_constant_load_work_is_load_times_displacement) {
  fixtures::RandomProblems random(32);
  for (int near = 0; near < 3; ++near) {
    for (const double stiffness : {0.5, 300.0}) {
      const Problem problem = random.next(stiffness, Load(LoadShape::step, 5.0),
                                          static_cast<NearEnd>(near), FarEnd::rigid_sealed);
      const ColumnSolution solution(problem);
      const double t = 3.1 * *problem.column.length / solution.modes().speed(0);
      const EnergyBalance balance = energy_balance(solution, t);
      const DerivedFields end = derived_fields(solution, 0.0, t);
      const double nf = problem.material.porosity;
      const double moved =
          problem.column.near == NearEnd::fluid_pressure
              ? (1.0 - nf) * end.solid_displacement.value + nf * end.fluid_displacement.value
              : end.solid_displacement.value;
      BOOST_TEST(balance.work.value == 5.0 * moved, tt::tolerance(1e-12));
      BOOST_TEST(std::abs(balance.work.value - 5.0 * moved) < balance.work.error);
      BOOST_TEST(balance.settlement.value == end.solid_displacement.value);
      BOOST_TEST(sound(balance));
    }
  }
}

BOOST_AUTO_TEST_CASE(it_is_sound_for_all_ends_and_loads_and_only_grows_by_dissipation) {
  fixtures::RandomProblems random(33);
  for (int trial = 0; trial < 16; ++trial) {
    Problem problem = random.next(random.log_uniform(0.1, 1e4), Load(),
                                  static_cast<NearEnd>(trial % 4), static_cast<FarEnd>(trial / 4));
    const double crossing = problem.column.length.value_or(1.0) / wave_speeds(problem.material).p1;
    problem.load = trial % 6 == 5
                       ? Load(2.0, {0.0, 0.5 * crossing, 0.5 * crossing, crossing}, {0, 1, -1, 0.5})
                       : Load(static_cast<LoadShape>(trial % 6), 2.0, 0.8 * crossing);
    const ColumnSolution solution(problem);
    const std::vector<double> times = {2.2 * crossing, 0.7 * crossing, 1.3 * crossing};
    const auto balances = energy_balances(solution, times);
    BOOST_TEST_CONTEXT(name(problem.load.shape())
                       << ' ' << name(problem.column.near) << ' ' << name(problem.column.far)) {
      for (std::size_t i = 0; i < 3; ++i) {
        BOOST_TEST(balances[i].t == times[i]);
        BOOST_TEST(sound(balances[i]));
        BOOST_TEST(balances[i].dissipated.error < 1e-9 * balances[i].work.value + 1e-300);
      }
      BOOST_TEST(balances[1].dissipated.value <= balances[2].dissipated.value);
      BOOST_TEST(balances[2].dissipated.value <= balances[0].dissipated.value);
    }
  }
}

BOOST_AUTO_TEST_CASE(without_drag_half_of_the_work_of_a_step_moves_and_half_is_stored) {
  Problem problem = fixtures::paper_problem();
  problem.column = {std::nullopt, NearEnd::drained_traction, FarEnd::half_space};
  problem.material.intrinsic_permeability = 1e3;
  const EnergyBalance balance = energy_balance(ColumnSolution(problem), 4e-5);
  BOOST_TEST(balance.kinetic.value == 0.5 * balance.work.value, tt::tolerance(1e-12));
  BOOST_TEST(balance.elastic.value == 0.5 * balance.work.value, tt::tolerance(1e-12));
  BOOST_TEST(std::abs(balance.dissipated.value) <
             balance.dissipated.error + 1e-14 * balance.work.value);
}

BOOST_AUTO_TEST_CASE(at_rest_again_drag_has_used_up_half_of_the_work) {
  Problem problem = fixtures::paper_problem(Load(LoadShape::step, 7.0));
  problem.material.constrained_modulus = 1e9;
  problem.material.intrinsic_permeability = 2e-11;
  const EnergyBalance balance = energy_balance(ColumnSolution(problem), 2e-3);
  const double stored = 0.5 * 7.0 * 7.0 * 0.1 / 1e9;
  BOOST_TEST(balance.elastic.value == stored, tt::tolerance(0.02));
  BOOST_TEST(balance.dissipated.value == stored, tt::tolerance(0.02));
  BOOST_TEST(balance.kinetic.value < 0.01 * stored);
}

BOOST_AUTO_TEST_CASE(nothing_has_happened_at_the_start_and_what_is_lost_is_not_hidden) {
  Problem problem = fixtures::paper_problem();
  for (const double t : {0.0, -1.0}) {
    const EnergyBalance start = energy_balance(ColumnSolution(problem), t);
    BOOST_TEST(start.work.value == 0.0);
    BOOST_TEST(start.elastic.value == 0.0);
    BOOST_TEST(start.dissipated.error == 0.0);
  }
  BOOST_TEST(energy_balances(ColumnSolution(problem), {}).empty());
  // More images than are followed.
  problem.column.near = NearEnd::sealed_traction;
  problem.column.far = FarEnd::rigid_drained;
  const EnergyBalance lost = energy_balance(ColumnSolution(problem), 0.1);
  BOOST_TEST(std::isinf(lost.dissipated.error));
}

BOOST_AUTO_TEST_SUITE_END()
