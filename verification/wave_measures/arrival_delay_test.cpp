#include "verification/wave_measures/arrival_delay.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "reference/waves.hpp"
#include "verification/run.hpp"
#include "verification/wave_measures/wave_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(arrival_delay)

using namespace porowave;
using namespace porowave::verification;
using reference::Profile;
using wave_fixtures::column;
using wave_fixtures::snapshot_of;

namespace {

constexpr double length = 0.1;
const Load ramp(LoadShape::smooth_ramp, 1.0, 1e-5);

Profile profile_of(const Problem& problem, double t) {
  return {reference::ColumnSolution(problem), t, length};
}

std::array<double, 2> delays(const Problem& problem, const Profile& profile,
                             const wave_fixtures::FieldsAt& found, int cells) {
  return arrival_delays(problem, profile, snapshot_of(found, profile.time(), cells),
                        wave_fixtures::values_of([&](double x) { return profile.at(x); }, cells));
}

/// The reference, late by a length (m).
wave_fixtures::FieldsAt late_by(const Profile& profile, double d) {
  return [&profile, d](double x) { return profile.at(std::clamp(x + d, 0.0, length)); };
}

/// Runs of the solver in one resolution after another.
std::array<double, 2> delays_of_run(int cells) {
  solver::Case scene;
  scene.problem = column(ramp);
  scene.discretization.elements = cells;
  scene.time.end = 4e-5;
  return run_case(scene, *reference_profile(scene)).measures.arrival_delay;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_reference_that_is_shifted_is_late_by_its_shift) {
  // As short as a hundred cells can show them.
  for (const Load& load :
       {Load(LoadShape::smooth_ramp, -3.0, 1e-5), Load(LoadShape::sin4_pulse, 1e6, 1e-5),
        Load(LoadShape::ricker, 1.0, 6e-5)}) {
    const Problem problem = column(load);
    const Profile profile = profile_of(problem, 4e-5);
    const WaveSpeeds c = wave_speeds(problem.material);
    for (const int cells : {100, 333}) {
      const double h = length / cells;
      for (const double shift : {0.0, 0.3 * h, -0.3 * h, 2.7 * h, -4.0 * h}) {
        const auto found = delays(problem, profile, late_by(profile, shift), cells);
        BOOST_TEST(std::abs(found[0] - shift / c.p1) < 1e-8 * h / c.p1);
        BOOST_TEST(std::abs(found[1] - shift / c.p2) < 1e-8 * h / c.p2);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_shifted_step_is_late_by_its_shift_to_half_a_cell) {
  for (const LoadShape shape : {LoadShape::step, LoadShape::block}) {
    const Problem problem = column(Load(shape, 1.0, 1e-5));
    const Profile profile = profile_of(problem, 4e-5);
    const WaveSpeeds c = wave_speeds(problem.material);
    const double h = length / 200;
    for (const double shift : {0.0, 0.4 * h, -0.7 * h, 3.1 * h}) {
      const auto found = delays(problem, profile, late_by(profile, shift), 200);
      BOOST_TEST(std::abs(found[0] - shift / c.p1) < 0.51 * h / c.p1);
      BOOST_TEST(std::abs(found[1] - shift / c.p2) < 0.51 * h / c.p2);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_step_smeared_to_a_straight_line_arrives_with_its_middle) {
  const Problem problem = column(Load(LoadShape::step, 1.0), 1e-2);
  const Profile profile = profile_of(problem, 4e-5);
  const WaveSpeeds c = wave_speeds(problem.material);
  const int cells = 200;
  const double h = length / cells;
  const double front = c.p1 * 4e-5;
  const Fields plateau = profile.at(0.5 * (c.p1 + c.p2) * 4e-5);
  for (const double late : {0.0, 0.3 * h, -0.4 * h, 1.25 * h}) {
    const auto smeared = [&](double x) {
      if (x < front - 10 * h) return profile.at(x);
      const double share = 0.5 + (front - late - x) / (7 * h);
      return wave_fixtures::scaled(plateau, std::clamp(share, 0.0, 1.0));
    };
    const double found = delays(problem, profile, smeared, cells)[0];
    BOOST_TEST(std::abs(found - late / c.p1) < 1e-6 * h / c.p1);
  }
}

BOOST_AUTO_TEST_CASE(ringing_behind_the_front_and_a_wrong_plateau_do_not_matter) {
  const Problem problem = column(ramp);
  const Profile profile = profile_of(problem, 4e-5);
  const double h = length / 200;
  const WaveSpeeds c = wave_speeds(problem.material);
  const double shift = 1.3 * h;
  for (const int mode : {0, 1}) {
    const double rear = (mode == 0 ? c.p1 : c.p2) * 3e-5 - 4 * h;
    const auto ringing = [&](double x) {
      const Fields f = profile.at(std::clamp(x + shift, 0.0, length));
      return x > rear ? f
                      : wave_fixtures::scaled(
                            f, 1.2 + 0.1 * std::sin(2 * std::numbers::pi * x / (3 * h)));
    };
    const double clean =
        delays(problem, profile, late_by(profile, shift), 200)[static_cast<std::size_t>(mode)];
    BOOST_TEST(delays(problem, profile, ringing, 200)[static_cast<std::size_t>(mode)] == clean,
               boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(where_drag_rules_the_undrained_front_is_timed) {
  Problem problem = column(Load(LoadShape::smooth_ramp, 1.0, 5e-6));
  problem.material.constrained_modulus = 2.0e10;
  problem.material.intrinsic_permeability = 1e-13;
  const reference::WaveModes modes(problem.material);
  const double t = 2.2e-5;
  BOOST_REQUIRE(std::exp(-modes.frozen().excess[0].real() * modes.speed(0) * t) < 0.1);
  const Profile profile = profile_of(problem, t);
  const double h = length / 200;
  for (const double shift : {0.6 * h, -2.2 * h}) {
    const auto found = delays(problem, profile, late_by(profile, shift), 200);
    BOOST_TEST(found[0] == shift / modes.undrained_speed(), boost::test_tools::tolerance(1e-7));
    BOOST_TEST(std::isnan(found[1]));  // the slow wave is damped away
  }
}

BOOST_AUTO_TEST_CASE(without_a_front_in_the_column_there_is_no_delay) {
  const auto at_rest_error = [](const Problem& problem, double t) {
    const Profile profile = profile_of(problem, t);
    return delays(problem, profile, late_by(profile, 0.0), 200);
  };
  const auto has = [](const std::array<double, 2>& d, bool fast, bool slow) {
    BOOST_TEST(std::isfinite(d[0]) == fast);
    BOOST_TEST(std::isfinite(d[1]) == slow);
  };
  has(at_rest_error(column(ramp), 0.9e-5), false, false);  // the load still rises
  has(at_rest_error(column(ramp), 1.05e-5), true, false);  // 0.6 cells of plateau as slow wave
  has(at_rest_error(column(ramp), 4.0e-5), true, true);
  has(at_rest_error(column(ramp), 4.5e-5), false, true);         // the fast wave has been reflected
  has(at_rest_error(column(ramp), 9.0e-5), false, false);        // and the slow one
  has(at_rest_error(column(ramp, 1e-13), 4.0e-5), true, false);  // damped
}

BOOST_AUTO_TEST_CASE(a_solution_that_stays_behind_or_small_does_not_arrive) {
  const Problem problem = column(ramp);
  const Profile profile = profile_of(problem, 4e-5);
  const auto stopped = [&](double x) { return x > 0.05 ? Fields{} : profile.at(x); };
  const auto weak = [&](double x) { return wave_fixtures::scaled(profile.at(x), 0.4); };
  const auto nowhere = [&](double) { return Fields{NAN, NAN, NAN, NAN}; };
  BOOST_TEST(std::isnan(delays(problem, profile, stopped, 200)[0]));
  BOOST_TEST(std::isfinite(delays(problem, profile, stopped, 200)[1]));
  for (const int mode : {0, 1}) {
    const auto k = static_cast<std::size_t>(mode);
    BOOST_TEST(std::isnan(delays(problem, profile, weak, 200)[k]));
    BOOST_TEST(std::isnan(delays(problem, profile, nowhere, 200)[k]));
    const double front =
        (mode == 0 ? wave_speeds(problem.material).p1 : wave_speeds(problem.material).p2) * 3.5e-5;
    const auto spoiled_ahead = [&](double x) { return x > front ? nowhere(x) : profile.at(x); };
    BOOST_TEST(std::isnan(delays(problem, profile, spoiled_ahead, 200)[k]));
  }
}

BOOST_AUTO_TEST_CASE(loads_reach_their_peak_after_their_rise_time) {
  for (const LoadShape shape : {LoadShape::step, LoadShape::smooth_ramp, LoadShape::sin4_pulse,
                                LoadShape::block, LoadShape::ricker}) {
    const Load load(shape, -2.0, 3e-6);
    BOOST_TEST(load.value(rise_time(load)) == -2.0, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(std::abs(load.value(0.99 * rise_time(load))) <= 2.0);
  }
  BOOST_TEST(rise_time(Load(1.0, {0.0, 1e-6, 2e-6, 5e-6}, {0.0, 1.0, -4.0, 3.0})) == 2e-6);
}

BOOST_AUTO_TEST_CASE(runs_are_late_by_the_square_of_the_cells) {
  // Lumped masses and a step below the stable one make short waves slow.
  std::array<double, 2> coarse = delays_of_run(400);
  for (const int cells : {800, 1600}) {
    const auto fine = delays_of_run(cells);
    for (const std::size_t k : {0u, 1u}) {
      BOOST_TEST_MESSAGE(cells << " cells, wave " << k << ": late by " << fine[k] << " s, factor "
                               << coarse[k] / fine[k]);
      BOOST_TEST(fine[k] > 0.0);
      BOOST_TEST(coarse[k] / fine[k] > 3.5);
      BOOST_TEST(coarse[k] / fine[k] < 4.5);
    }
    coarse = fine;
  }
}

BOOST_AUTO_TEST_SUITE_END()
