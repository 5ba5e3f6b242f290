#include "reference/fronts.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

#include "reference/column_solution.hpp"
#include "reference/field_fixtures.hpp"
#include "reference/problem/errors.hpp"
#include "reference/problem/problem_fixtures.hpp"
#include "reference/random_problems.hpp"

BOOST_AUTO_TEST_SUITE(fronts)

using namespace porowave;
using namespace porowave::reference;
using fixtures::as_array;

namespace {

std::vector<Front> fronts_of(const Problem& problem, double t) {
  return fronts_at(problem, WaveModes(problem.material), t);
}

/// What all fronts within `near` of x together do to the value at smaller less that at larger x.
std::array<double, 4> jump_across(const std::vector<Front>& fronts, double x, double near) {
  std::array<double, 4> sum{};
  for (const Front& front : fronts) {
    if (std::abs(front.x - x) > near) continue;
    for (std::size_t f = 0; f < 4; ++f) {
      sum[f] += (front.upwards ? 1.0 : -1.0) * as_array(front.jump)[f];
    }
  }
  return sum;
}

/// Largest deviation, relative to the load, between the jumps of the fronts and those of the exact
/// solution between points that the front passes a 1e-10 of t before and after. What the fields
/// change there besides is taken off by going twice as far.
double worst_difference(const Problem& problem, double t, int& compared) {
  const ColumnSolution solution(problem);
  const auto fronts = fronts_of(problem, t);
  const double length = problem.column.length.value_or(solution.modes().speed(0) * t * 2.0);
  const std::array<double, 4> scale = {problem.stress_scale(), problem.stress_scale(),
                                       problem.velocity_scale(), problem.velocity_scale()};
  double worst = 0.0;
  for (const Front& front : fronts) {
    const double aside = 1e-10 * t * solution.modes().speed(front.mode);
    if (front.x < 2 * aside || front.x > length - 2 * aside) continue;
    const auto at = [&](double x) { return as_array(solution.at(x, t).value); };
    const auto behind = at(front.x - aside);
    const auto ahead = at(front.x + aside);
    const auto far_behind = at(front.x - 2 * aside);
    const auto far_ahead = at(front.x + 2 * aside);
    const auto jump = jump_across(fronts, front.x, aside);
    for (std::size_t f = 0; f < 4; ++f) {
      const double seen = 2 * (behind[f] - ahead[f]) - (far_behind[f] - far_ahead[f]);
      worst = std::max(worst, std::abs(seen - jump[f]) / scale[f]);
    }
    ++compared;
  }
  return worst;
}

Load with_jumps(int kind, double crossing) {
  switch (kind) {
    case 0:
      return {LoadShape::step, 2.0};
    case 1:
      return {LoadShape::block, 3.0, 0.7 * crossing};
    default:
      return {1.0, {0.1 * crossing, 0.4 * crossing, 0.4 * crossing, crossing}, {1, 2, -1, 1}};
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(jumps_are_those_of_the_exact_solution_for_every_pair_of_ends) {
  fixtures::RandomProblems random(1);
  int compared = 0;
  double worst = 0.0;
  for (int near = 0; near < 4; ++near) {
    for (int far = 0; far < 4; ++far) {
      for (int kind = 0; kind < 3; ++kind) {
        Problem problem = random.next(random.log_uniform(0.1, 3.0), Load(),
                                      static_cast<NearEnd>(near), static_cast<FarEnd>(far));
        const double length = problem.column.length.value_or(1.0);
        const double crossing = length / wave_speeds(problem.material).p1;
        problem.load = with_jumps(kind, crossing);
        const double difference =
            worst_difference(problem, random.uniform(0.5, 3.5) * crossing, compared);
        BOOST_TEST_CONTEXT(name(problem.column.near) << " " << name(problem.column.far)) {
          BOOST_TEST(difference < 1e-11);
        }
        worst = std::max(worst, difference);
      }
    }
  }
  BOOST_TEST_MESSAGE(compared << " fronts, worst difference " << worst << " of the load");
  BOOST_TEST(compared > 200);
}

BOOST_AUTO_TEST_CASE(momentum_is_kept_across_every_front) {
  // [sigma' - n_s p] = -n_s rho_s c [v_s] and [n_f p] = n_f rho_f c [v_f], c > 0 going up.
  fixtures::RandomProblems random(2);
  for (int trial = 0; trial < 48; ++trial) {
    const Problem problem =
        random.next(random.log_uniform(0.01, 100.0), Load(), static_cast<NearEnd>(trial % 4),
                    static_cast<FarEnd>(trial / 4 % 4));
    const Material& m = problem.material;
    const WaveModes modes(m);
    const double length = problem.column.length.value_or(1.0);
    const auto list = fronts_at(problem, modes, 4.2 * length / modes.speed(0));
    BOOST_REQUIRE(!list.empty());
    for (const Front& front : list) {
      const double c = (front.upwards ? 1.0 : -1.0) * modes.speed(front.mode);
      const Fields& j = front.jump;
      const double solid = m.solid_partial_density() * c * j.solid_velocity;
      const double fluid = m.fluid_partial_density() * c * j.fluid_velocity;
      const double size = std::abs(j.effective_stress) + std::abs(j.pore_pressure) +
                          std::abs(solid) + std::abs(fluid);
      BOOST_TEST(std::abs(j.effective_stress - m.solid_fraction() * j.pore_pressure + solid) <=
                 1e-13 * size);
      BOOST_TEST(std::abs(m.porosity * j.pore_pressure - fluid) <= 1e-13 * size);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_two_waves_of_a_half_space) {
  Problem problem = fixtures::paper_problem();
  problem.column = {{}, NearEnd::drained_traction, FarEnd::half_space};
  const WaveModes modes(problem.material);
  const auto list = fronts_at(problem, modes, 1e-5);
  BOOST_REQUIRE(list.size() == 2u);
  BOOST_TEST(list[0].x == modes.speed(1) * 1e-5);
  BOOST_TEST(list[1].x == modes.speed(0) * 1e-5);
  BOOST_TEST(list[0].mode == 1);
  BOOST_TEST(list[1].mode == 0);
  for (const Front& front : list) {
    BOOST_TEST(front.upwards);
    BOOST_TEST(front.crossings == 0);
    BOOST_TEST(front.of_jump);
  }
  // At once after the load the two waves together are the load.
  const auto start = fronts_at(problem, modes, 0.0);
  BOOST_REQUIRE(start.size() == 2u);
  BOOST_TEST(std::abs(start[0].jump.effective_stress + start[1].jump.effective_stress + 1) < 1e-14);
  BOOST_TEST(std::abs(start[0].jump.pore_pressure + start[1].jump.pore_pressure) < 1e-14);
  BOOST_TEST(fronts_at(problem, modes, -1e-9).empty());
}

BOOST_AUTO_TEST_CASE(positions_are_those_that_the_solution_knows) {
  fixtures::RandomProblems random(3);
  for (int trial = 0; trial < 16; ++trial) {
    const Problem problem =
        random.next(1.0, Load(), static_cast<NearEnd>(trial % 4), static_cast<FarEnd>(trial / 4));
    const ColumnSolution solution(problem);
    const double t = 5.3 * problem.column.length.value_or(1.0) / solution.modes().speed(0);
    std::vector<double> positions;
    for (const Front& front : fronts_of(problem, t)) positions.push_back(front.x);
    const auto known = solution.fronts(t);
    BOOST_REQUIRE(positions.size() == known.size());
    for (std::size_t i = 0; i < known.size(); ++i) {
      BOOST_TEST(std::abs(positions[i] - known[i]) <= 1e-14 * known.back());
    }
  }
}

BOOST_AUTO_TEST_CASE(a_load_without_jumps_has_an_onset) {
  for (const Load& load : {Load(LoadShape::smooth_ramp, 1.0, 1e-5),
                           Load(LoadShape::ricker, 1, 1e-5), Load(1.0, {3e-6, 5e-6}, {0.0, 1.0})}) {
    const double started = load.shape() == LoadShape::table ? 3e-6 : 0.0;
    const Problem problem = fixtures::paper_problem(load);
    const auto list = fronts_of(problem, 2e-5);
    BOOST_REQUIRE(list.size() == 2u);
    BOOST_TEST(list[1].x == WaveModes(problem.material).speed(0) * (2e-5 - started));
    for (const Front& front : list) {
      BOOST_TEST(!front.of_jump);
      BOOST_TEST(front.started == started);
      BOOST_TEST(as_array(front.jump) == (std::array<double, 4>{}),
                 boost::test_tools::per_element());
    }
  }
}

BOOST_AUTO_TEST_CASE(jumps_of_a_load_at_one_time_are_one_front) {
  // 0 to 2 and on to 1, both at t = 0; then up and back at 4e-6, which is no jump.
  const Load load(1.0, {0.0, 0.0, 4e-6, 4e-6, 4e-6, 1e-5}, {2, 1, 1, 3, 1, 1});
  const auto list = fronts_of(fixtures::paper_problem(load), 1e-5);
  const auto step = fronts_of(fixtures::paper_problem(), 1e-5);
  BOOST_REQUIRE(list.size() == step.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    BOOST_TEST(as_array(list[i].jump) == as_array(step[i].jump), boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(times_that_have_no_answer_are_refused) {
  const Problem problem = fixtures::paper_problem();
  BOOST_CHECK_THROW(fronts_of(problem, std::numeric_limits<double>::infinity()), InputError);
  BOOST_CHECK_THROW(fronts_of(problem, std::numeric_limits<double>::quiet_NaN()), InputError);
  BOOST_CHECK_THROW(fronts_of(problem, 1e3), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
