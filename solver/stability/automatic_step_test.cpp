#include "solver/stability/automatic_step.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "reference/problem/errors.hpp"
#include "solver/case_fixtures.hpp"
#include "solver/stability/automatic_fixtures.hpp"
#include "solver/time_step.hpp"

BOOST_AUTO_TEST_SUITE(automatic_step)

using namespace porowave;
using namespace porowave::solver;
using namespace porowave::solver::test;

namespace {

const std::string automatic = with("courant = 0.25", "courant = \"auto\"");

Case at(Case scene, double courant) {
  scene.time.courant = courant;
  return scene;
}

// One point somewhere in each cell, moving least squares: not stable at any step.
Case hopeless() {
  Case scene = undamped_column(24, Placement::random, 1, 40.0);
  scene.discretization.kernel = kernel_name<BSpline1>;
  scene.discretization.support_radius = 1.0;
  scene.problem.column.near = NearEnd::velocity;
  return scene;
}

}  // namespace

// The limit of uniform points and linear functions without drag is known: 1/√(2 − w), w the mean of
// (1 − 2t)² over the places t of the points in a cell.
BOOST_AUTO_TEST_CASE(it_is_nine_tenths_of_the_known_limit_of_uniform_points) {
  for (const int points : {1, 2, 3, 6}) {
    double seen = 0.0;
    for (int k = 0; k < points; ++k) seen += std::pow(1.0 - (2.0 * k + 1.0) / points, 2) / points;
    Case scene = undamped_column(40, Placement::uniform, points, 200.0);
    use_linear_shape(scene.discretization);
    const AutomaticStep found = solver::automatic_step(scene);
    BOOST_CHECK(found.rule == StepRule::critical_step);
    BOOST_TEST(found.elements == 40);
    BOOST_TEST(std::abs(found.critical * std::sqrt(2.0 - seen) - 1.0) < 0.025);
    BOOST_TEST(std::abs(found.courant - 0.9 * found.critical) < 1e-12);
    BOOST_TEST(found.noise_growth <= tolerated_growth);
  }
}

// Real runs: within bounds at the step chosen, broken a little above the critical one.
BOOST_AUTO_TEST_CASE(runs_bear_it_out) {
  int limited = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    for (const bool mls : {true, false}) {
      Case scene = undamped_column(30, Placement::stratified, 3, 40.0);
      scene.discretization.seed = seed;
      scene.discretization.strain = Strain::recovered;
      if (!mls) use_linear_shape(scene.discretization);
      const AutomaticStep found = solver::automatic_step(scene);
      BOOST_TEST_CONTEXT((mls ? "mls" : "shape") << ", seed " << seed) {
        BOOST_TEST(peak_at_end(at(scene, found.courant)).share < 10.0);
        if (found.critical >= 0.95) continue;
        ++limited;
        BOOST_TEST(!(peak_at_end(at(scene, 1.05 * found.critical)).share < 10.0));
      }
    }
  }
  BOOST_TEST(limited >= 4);
}

BOOST_AUTO_TEST_CASE(a_window_of_uniform_points_stands_for_the_column) {
  for (const Scheme scheme : {Scheme::galerkin, Scheme::staggered4}) {
    Case column = undamped_column(400, Placement::uniform, 2, 2.0);
    column.discretization.scheme = scheme;
    if (scheme == Scheme::staggered4) {
      column.discretization.kernel = kernel_name<WendlandC2>;
      column.discretization.support_radius = 2.0;
      column.discretization.basis_order = 2;
    }
    Case part = column;
    part.problem.column.length = 0.1 * most_analysed_elements / 400.0;
    part.discretization.elements = most_analysed_elements;
    const AutomaticStep of_column = solver::automatic_step(column);
    const AutomaticStep of_part = solver::automatic_step(part);
    BOOST_CHECK(of_column.rule == StepRule::window);
    BOOST_CHECK(of_part.rule == StepRule::critical_step);
    BOOST_TEST(of_column.elements == most_analysed_elements);
    BOOST_TEST(std::abs(of_column.critical - of_part.critical) < 1e-9);
    BOOST_TEST(peak_at_end(at(column, of_column.courant)).share < 10.0);
  }
}

BOOST_AUTO_TEST_CASE(the_estimate_bounds_a_window_of_irregular_points) {
  Case scene = undamped_column(300, Placement::stratified, 4, 1.0);
  scene.discretization.strain = Strain::recovered;
  const AutomaticStep found = solver::automatic_step(scene);
  BOOST_CHECK(found.rule == StepRule::window);
  BOOST_TEST(found.courant <= estimated_courant(scene));
  BOOST_TEST(found.courant > 0.5);
}

// With Shepard's functions and recovered strains a gap leaves no stable step: also one that lies
// far beyond the window.
BOOST_AUTO_TEST_CASE(a_window_has_the_gaps_of_the_column) {
  const auto column = [](std::vector<double> gaps) {
    Case scene = undamped_column(200, Placement::uniform, 2, 40.0);
    scene.discretization.basis_order = 0;
    scene.discretization.strain = Strain::recovered;
    scene.discretization.empty_elements = std::move(gaps);
    return scene;
  };
  BOOST_CHECK_NO_THROW(solver::automatic_step(column({})));
  BOOST_CHECK_THROW(solver::automatic_step(column({0.01225})), NoStableStep);
  BOOST_CHECK_THROW(solver::automatic_step(column({0.08025})), NoStableStep);
}

BOOST_AUTO_TEST_CASE(long_columns_of_shape_functions_take_the_proven_limit) {
  for (const Placement placement : {Placement::uniform, Placement::random}) {
    Case scene = undamped_column(200, placement, 4, 1.0);
    use_linear_shape(scene.discretization);
    const AutomaticStep found = solver::automatic_step(scene);
    BOOST_CHECK(found.rule == StepRule::formula);
    BOOST_TEST(found.courant == 0.9 * linear_shape_limit(scene));
    BOOST_TEST(found.elements == 0);
  }
}

// Light nodes of linear functions ask for steps far below the scan.
BOOST_AUTO_TEST_CASE(linear_functions_have_a_step_below_the_scan) {
  for (const std::uint64_t seed : {3U, 4U, 6U, 17U}) {
    Case scene = undamped_column(20, Placement::random, 1, 5.0);
    use_linear_shape(scene.discretization);
    scene.problem.column.near = NearEnd::velocity;
    scene.discretization.seed = seed;
    const AutomaticStep found = solver::automatic_step(scene);
    BOOST_TEST(found.courant >= estimated_courant(scene));
    BOOST_TEST(estimated_courant(scene) < 0.1);
    BOOST_TEST(found.noise_growth <= tolerated_growth);
  }
}

BOOST_AUTO_TEST_CASE(a_scene_without_a_stable_step_is_refused_with_what_would_help) {
  const auto tells = [](const std::string& text) {
    return [text](const NoStableStep& error) {
      BOOST_TEST_MESSAGE(error.what());
      return std::string(error.what()).find(text) != std::string::npos;
    };
  };
  BOOST_CHECK_EXCEPTION(solver::automatic_step(hopeless()), NoStableStep,
                        tells("noise grows at every courant from 0.1 to 1"));
  BOOST_CHECK_EXCEPTION(solver::automatic_step(hopeless()), NoStableStep, tells("Stable with "));
}

// What is tolerated is growth over the run, so a short one has a step where a long one has none.
BOOST_AUTO_TEST_CASE(a_short_run_needs_less) {
  Case scene = hopeless();
  scene.time.end *= 1e-3;
  const AutomaticStep found = solver::automatic_step(scene);
  BOOST_TEST(found.noise_growth > 1.0);
  BOOST_TEST(found.noise_growth <= tolerated_growth);
}

BOOST_AUTO_TEST_CASE(a_case_file_has_what_is_chosen_for_its_scene) {
  const Case scene = read(automatic);
  BOOST_REQUIRE(scene.time.automatic.has_value());
  BOOST_TEST(scene.time.courant == scene.time.automatic->courant);
  BOOST_TEST(scene.time.courant == automatic_courant(read(full)));
  BOOST_TEST(!read(full).time.automatic.has_value());
}

BOOST_AUTO_TEST_CASE(a_case_file_without_a_stable_step_is_refused_by_line_and_key) {
  std::string text = with("elements = 200", "elements = 20", automatic);
  text = with("empty_elements = [0.05, 0]\n", "", text);
  text = with("jitter = 0.25\n", "", with("\"jittered\"", "\"random\"", text));
  text = with("points_per_element = 3", "points_per_element = 1", text);
  text = with("basis_order = 2", "basis_order = 1", text);
  text = with("\"wendland_c4\"", "\"bspline1\"", with("2.75", "1.0", text));
  text = with("flip = 0.75\n", "", with("12345678901", "1", text));
  text = with("\"sealed_traction\"", "\"velocity\"", text);
  text = with("end = 4.0e-5", "end = 1.0e-2", text);
  BOOST_TEST(message_for(text).starts_with(
                 "case.toml:34: [time] courant = \"auto\": expected a scene with a stable step: "),
             message_for(text));
}

BOOST_AUTO_TEST_CASE(a_case_file_whose_loaded_end_no_point_reaches_is_refused) {
  std::string text = with("empty_elements = [0.05, 0]",
                          "empty_elements = [0, 0.0006, 0.0011, 0.0016, 0.0021]", automatic);
  const std::string message = message_for(text);
  BOOST_TEST(message.find("courant = \"auto\": expected a scene that can be stepped; ") !=
                 std::string::npos,
             message);
  BOOST_TEST(message.find("no point within reach of the loaded end") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
