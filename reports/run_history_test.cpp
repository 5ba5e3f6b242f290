#include "reports/run_history.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/fronts.hpp"
#include "reference/problem/errors.hpp"
#include "reference/problem/problem_fixtures.hpp"
#include "verification/run.hpp"

BOOST_AUTO_TEST_SUITE(run_history)

using namespace porowave;
namespace tt = boost::test_tools;

namespace {

solver::Case scene_of(int elements) {
  solver::Case scene;
  scene.problem = fixtures::paper_problem();
  scene.problem.load = Load(LoadShape::smooth_ramp, 1.0, 1e-5);
  scene.discretization.elements = elements;
  scene.time.end = 3e-5;
  return scene;
}

/// Where the ways are at time t, ascending, each place once.
std::vector<double> places_at(const std::vector<reports::Characteristic>& ways, double t) {
  std::vector<double> places;
  for (const reports::Characteristic& way : ways) {
    if (t < way.t_begin || t > way.t_end) continue;
    const double share = (t - way.t_begin) / (way.t_end - way.t_begin);
    places.push_back(way.x_begin + share * (way.x_end - way.x_begin));
  }
  std::sort(places.begin(), places.end());
  places.erase(
      std::unique(places.begin(), places.end(), [](double a, double b) { return b - a < 1e-9; }),
      places.end());
  return places;
}

}  // namespace

BOOST_AUTO_TEST_CASE(frames_are_equally_far_apart_and_end_with_the_run) {
  const solver::Case scene = scene_of(40);
  const auto history = reports::run_history(scene, 7);
  const auto run = verification::run_case(scene, *verification::reference_profile(scene));
  BOOST_TEST_REQUIRE(history.frames.size() == 7u);
  for (std::size_t k = 0; k < 7; ++k) {
    const double t = static_cast<double>(k + 1) / 7.0 * scene.time.end;
    BOOST_TEST(std::abs(history.frames[k].snapshot.time - t) <= run.time_step);
  }
  const auto& last = history.frames.back();
  BOOST_TEST(last.snapshot.time == scene.time.end, tt::tolerance(1e-12));
  BOOST_TEST(last.snapshot.effective_stress == run.snapshot.effective_stress, tt::per_element());
}

BOOST_AUTO_TEST_CASE(the_reference_stands_beside_every_frame) {
  const solver::Case scene = scene_of(200);
  const auto history = reports::run_history(scene, 3);
  for (const auto& frame : history.frames) {
    double worst = 0.0;
    double largest = 0.0;
    for (std::size_t c = 0; c < frame.reference.size(); ++c) {
      worst = std::max(
          worst, std::abs(frame.reference[c].pore_pressure - frame.snapshot.pore_pressure[c]));
      largest = std::max(largest, std::abs(frame.reference[c].pore_pressure));
    }
    BOOST_TEST(worst < 0.05 * largest);  // second order, 200 cells
    BOOST_TEST(largest > 0.0);
  }
}

BOOST_AUTO_TEST_CASE(there_are_no_more_frames_than_steps) {
  const solver::Case scene = scene_of(4);
  const auto steps = static_cast<int>(solver::ColumnSolver(scene).planned_steps());
  BOOST_TEST(reports::run_history(scene, steps).frames.size() == static_cast<std::size_t>(steps));
  BOOST_CHECK_THROW(reports::run_history(scene, steps + 1), std::invalid_argument);
  BOOST_CHECK_THROW(reports::run_history(scene, 0), std::invalid_argument);
}

// Two routes to the same places: images of the exact solution, and rays followed by hand.
BOOST_AUTO_TEST_CASE(characteristics_pass_where_the_fronts_of_the_reference_are) {
  Problem problem = fixtures::paper_problem();
  problem.load = Load(LoadShape::step, 1.0);
  const reference::WaveModes modes(problem.material);
  const double crossing = *problem.column.length / modes.speed(0);
  for (const NearEnd near :
       {NearEnd::drained_traction, NearEnd::sealed_traction, NearEnd::velocity}) {
    for (const FarEnd far : {FarEnd::rigid_sealed, FarEnd::rigid_drained, FarEnd::free_drained}) {
      problem.column.near = near;
      problem.column.far = far;
      for (const double crossings : {0.4, 1.3, 2.6, 4.45}) {
        const double t = crossings * crossing;
        std::vector<double> fronts;
        for (const reference::Front& front : reference::fronts_at(problem, modes, t)) {
          if (std::abs(front.jump.effective_stress) < 1e-12) continue;  // reflected to nothing
          if (fronts.empty() || front.x - fronts.back() > 1e-9) fronts.push_back(front.x);
        }
        const auto places = places_at(reports::characteristics(problem, 1.2 * t), t);
        BOOST_TEST_CONTEXT(name(near) << ", " << name(far) << ", " << crossings) {
          BOOST_TEST_REQUIRE(places.size() == fronts.size());
          for (std::size_t k = 0; k < fronts.size(); ++k) {
            BOOST_TEST(std::abs(places[k] - fronts[k]) < 1e-9);
          }
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(both_fronts_stand_at_speed_times_time) {
  const Problem problem = fixtures::paper_problem();
  const auto speeds = wave_speeds(problem.material);
  const double t = 2e-5;
  const auto fronts = reports::fronts_at(problem, t);
  BOOST_TEST_REQUIRE(fronts.size() == 2u);
  BOOST_TEST(fronts[0].x == speeds.p2 * t, tt::tolerance(1e-12));
  BOOST_TEST(!fronts[0].fast);
  BOOST_TEST(fronts[1].x == speeds.p1 * t, tt::tolerance(1e-12));
  BOOST_TEST(fronts[1].fast);
  // After the fast wave's reflection at 0.1 m.
  const double later = 0.15 / speeds.p1;
  const auto back = reports::fronts_at(problem, later);
  BOOST_TEST_REQUIRE(back.size() == 2u);
  BOOST_TEST(back[0].x == 0.05, tt::tolerance(1e-9));
  BOOST_TEST(back[0].fast);
}

BOOST_AUTO_TEST_CASE(a_watched_run_is_the_run_or_ends_before_its_breakdown) {
  solver::Case scene = scene_of(40);
  const auto plain = reports::run_history(scene, 7);
  const auto watched = reports::watched_run(scene, 7);
  BOOST_TEST(!watched.breakdown.has_value());
  BOOST_TEST_REQUIRE(watched.frames.size() == 7u);
  const auto& end = watched.frames.back().snapshot;
  BOOST_TEST(end.solid.stress == plain.frames.back().snapshot.solid.stress, tt::per_element());
  BOOST_TEST(
      watched.frames[3].snapshot.effective_stress == plain.frames[3].snapshot.effective_stress,
      tt::per_element());
  BOOST_TEST(watched.frames[3].snapshot.solid.x.empty());
  BOOST_TEST(reports::watched_run(scene_of(4), 1000).frames.size() ==
             static_cast<std::size_t>(solver::ColumnSolver(scene_of(4)).planned_steps()));

  scene = scene_of(200);
  scene.discretization.transfer = solver::TransferName::shape;
  scene.time.courant = 1.0;  // stable to 0.71
  const auto broken = reports::watched_run(scene, 50);
  BOOST_TEST_REQUIRE(broken.breakdown.has_value());
  BOOST_TEST(broken.breakdown->step > 0);
  BOOST_TEST_REQUIRE(!broken.frames.empty());
  BOOST_TEST(broken.frames.size() < 50u);
  const auto& last = broken.frames.back().snapshot;
  BOOST_TEST(last.solid.x.size() == 800u);
  for (const double value : last.effective_stress) BOOST_TEST(std::abs(value) < 20.0);
  BOOST_CHECK_THROW(reports::run_history(scene, 50), BreakdownError);
}

BOOST_AUTO_TEST_CASE(the_fourth_order_scheme_is_watched_by_its_own_solver) {
  solver::Case scene = scene_of(40);
  scene.discretization.scheme = solver::Scheme::staggered4;
  scene.discretization.basis_order = 3;
  const auto run = verification::run_case(scene, *verification::reference_profile(scene));
  const auto watched = reports::watched_run(scene, 5);
  BOOST_TEST(watched.frames.back().snapshot.effective_stress == run.snapshot.effective_stress,
             tt::per_element());
}

BOOST_AUTO_TEST_CASE(a_half_space_reflects_nothing) {
  Problem problem = fixtures::paper_problem();
  problem.column.length.reset();
  problem.column.far = FarEnd::half_space;
  BOOST_TEST(reports::characteristics(problem, 1.0).size() == 2u);
}

BOOST_AUTO_TEST_CASE(many_reflections_end_at_a_stated_number) {
  Problem problem = fixtures::paper_problem();
  problem.column.far = FarEnd::rigid_drained;
  const auto ways = reports::characteristics(problem, 1.0);
  BOOST_TEST(ways.size() <= 2048u);
  BOOST_TEST(ways.size() > 2040u);
}

BOOST_AUTO_TEST_SUITE_END()
