#include "verification/stability/scene_stability.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/problem/problem_fixtures.hpp"
#include "solver/column_solver.hpp"
#include "verification/stability/stability_output.hpp"
#include "verification/stability/text_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(scene_stability)

using namespace porowave;
using namespace porowave::verification;
namespace tt = boost::test_tools;
using fixtures::lines_of;

namespace {

/// One point in the middle of every cell: the limit is 1/sqrt(2) without drag.
solver::Case one_point_column(double courant) {
  solver::Case scene;
  scene.problem = fixtures::paper_problem();
  scene.problem.material.intrinsic_permeability = 1.0;
  scene.discretization.elements = 40;
  scene.discretization.transfer = solver::TransferName::shape;
  scene.discretization.shape = solver::shape_name<solver::LinearSpline>;
  scene.discretization.points_per_element = 1;
  scene.time.end = 1e-4;
  scene.time.courant = courant;
  return scene;
}

double largest(const std::vector<double>& values) {
  double size = 0.0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return size;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_step_is_that_of_the_run) {
  const solver::Case scene = one_point_column(0.5);
  const solver::ColumnSolver solver(scene);
  const SceneStability found = verification::scene_stability(scene);
  BOOST_TEST(found.time_step == solver.time_step());
  BOOST_TEST(found.steps == solver.planned_steps());
  BOOST_TEST(found.courant <= 0.5);
  BOOST_TEST(found.courant > 0.49);
  BOOST_TEST(found.fast_crossing == found.estimates.fast_wave, tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(progress_is_told_step_by_step) {
  std::size_t told = 0;
  const SceneStability found =
      verification::scene_stability(one_point_column(0.5), {}, [&] { ++told; });
  BOOST_TEST(told > found.critical.scan.size());
  BOOST_TEST(told < found.critical.scan.size() + 10);
}

BOOST_AUTO_TEST_CASE(a_stable_step_is_told_from_an_unstable_one) {
  const SceneStability stable = verification::scene_stability(one_point_column(0.7));
  BOOST_TEST(stable.stable(1e-3));
  BOOST_TEST(stable.critical.courant == std::sqrt(0.5), tt::tolerance(4e-3));
  BOOST_TEST(*stable.estimates.linear_shape == stable.critical.courant * stable.fast_crossing,
             tt::tolerance(4e-3));
  BOOST_TEST_REQUIRE(stable.mode.has_value());  // of the first unstable step
  BOOST_TEST(stable.mode->courant > stable.critical.courant);
  BOOST_TEST(stable.mode->growth > 1.001);

  const SceneStability unstable = verification::scene_stability(one_point_column(0.8));
  BOOST_TEST(!unstable.stable(1e-3));
  BOOST_TEST(unstable.critical.courant == stable.critical.courant);
  BOOST_TEST_REQUIRE(unstable.mode.has_value());
  BOOST_TEST(unstable.mode->courant == unstable.courant);
}

// The wave that the points do not see alternates from node to node.
BOOST_AUTO_TEST_CASE(the_fastest_mode_is_the_shortest_wave) {
  const SceneStability found = verification::scene_stability(one_point_column(0.9));
  BOOST_TEST_REQUIRE(found.mode.has_value());
  BOOST_TEST(found.mode->angle == std::acos(-1.0), tt::tolerance(1e-9));
  const solver::CarriedFields& fields = found.mode->fields;
  for (std::size_t i = 0; i + 2 < fields.node_x.size(); ++i) {
    BOOST_TEST(fields.solid_velocity[i] * fields.solid_velocity[i + 1] < 0.0);
  }
  const Material& m = one_point_column(0.9).problem.material;
  const double impedance = m.mixture_density() * m.undrained_speed();
  const double size = std::max({largest(fields.solid_velocity), largest(fields.fluid_velocity),
                                largest(fields.effective_stress) / impedance,
                                largest(fields.pore_pressure) / impedance});
  BOOST_TEST(size == 1.0, tt::tolerance(1e-12));
  BOOST_TEST(largest(found.mode->quarter_later.solid_velocity) < 1e-9);
}

// Of a mode that turns slowly, what has most energy is shown at its largest.
BOOST_AUTO_TEST_CASE(a_turning_mode_is_shown_at_its_peak) {
  solver::Case scene;
  scene.problem = fixtures::paper_problem();
  scene.discretization.elements = 24;
  scene.discretization.kernel = solver::kernel_name<solver::BSpline1>;
  scene.discretization.support_radius = 1.0;
  scene.discretization.placement = solver::Placement::stratified;
  scene.discretization.seed = 4;
  scene.time.end = 1e-5;
  scene.time.courant = 0.1;
  const SceneStability found = verification::scene_stability(scene);
  BOOST_TEST_REQUIRE(found.mode.has_value());
  BOOST_TEST_REQUIRE(found.mode->courant == found.courant);
  BOOST_TEST((found.mode->angle > 1e-3 && found.mode->angle < 1.0));
  const Material& m = scene.problem.material;
  double peak = 0.0, later_there = HUGE_VAL;
  const auto see = [&](const std::vector<double>& now, const std::vector<double>& later,
                       double energy) {
    for (std::size_t k = 0; k < now.size(); ++k) {
      const double size = std::sqrt(energy) * std::hypot(now[k], later[k]);
      if (size <= peak) continue;
      peak = size;
      later_there = std::abs(later[k] / now[k]);
    }
  };
  const auto& now = found.mode->fields;
  const auto& later = found.mode->quarter_later;
  see(now.solid_velocity, later.solid_velocity, m.solid_partial_density());
  see(now.fluid_velocity, later.fluid_velocity, m.fluid_partial_density());
  see(now.effective_stress, later.effective_stress, 1.0 / m.constrained_modulus);
  see(now.pore_pressure, later.pore_pressure, 1.0 / m.storage_modulus());
  BOOST_TEST(later_there < 1e-9);
  BOOST_TEST(largest(later.solid_velocity) > 0.01 * largest(now.solid_velocity));
}

BOOST_AUTO_TEST_CASE(without_an_unstable_step_there_is_no_mode) {
  solver::CriticalSettings settings;
  settings.highest = 0.6;
  const SceneStability found = verification::scene_stability(one_point_column(0.5), settings);
  BOOST_TEST(!found.mode.has_value());
  BOOST_TEST(found.critical.courant == 0.6);
  const std::string text = stability_summary(found, settings.limit);
  BOOST_TEST(contains(text, "0.6 or more"), text);
  BOOST_TEST(!contains(text, "fastest mode"), text);
}

BOOST_AUTO_TEST_CASE(the_summary_says_what_was_found) {
  const SceneStability found = verification::scene_stability(one_point_column(0.8));
  const std::string text = stability_summary(found, 1e-3);
  for (const char* part : {"verdict            unstable: growth above 0.001 a step",
                           "critical courant   0.70", "fast wave, h/c_1 ", "linear shape functions",
                           "if drag were explicit", "turning by 180 degrees"}) {
    BOOST_TEST(contains(text, part), text << " lacks " << part);
  }
  const std::string stable =
      stability_summary(verification::scene_stability(one_point_column(0.5)), 1e-3);
  BOOST_TEST(contains(stable, "verdict            stable: growth of at most 0.001"), stable);
}

BOOST_AUTO_TEST_CASE(steps_that_are_unstable_below_the_critical_one_are_listed) {
  SceneStability found = verification::scene_stability(one_point_column(0.5));
  found.critical.scan.back() = {0.05, 1.003, false};
  const std::string text = stability_summary(found, 1e-3);
  BOOST_TEST(contains(text, "unstable below it  at courant 0.05 (growth up to 0.003 a step)"),
             text);
}

BOOST_AUTO_TEST_CASE(the_scan_is_a_table) {
  const SceneStability found = verification::scene_stability(one_point_column(0.5));
  std::ostringstream csv;
  write_growth_csv(found, csv);
  const auto lines = lines_of(csv.str());
  BOOST_TEST_REQUIRE(lines.size() == 21u);
  BOOST_TEST(lines[0] == "courant,time_step,growth,stable");
  BOOST_TEST(lines[1].starts_with("0.05,"), lines[1]);
  BOOST_TEST(lines[1].ends_with(",true"), lines[1]);
  BOOST_TEST(lines[20].starts_with("1,"), lines[20]);
  BOOST_TEST(lines[20].ends_with(",false"), lines[20]);
}

BOOST_AUTO_TEST_CASE(the_mode_is_a_table_by_x) {
  const SceneStability found = verification::scene_stability(one_point_column(0.8));
  std::ostringstream csv;
  write_mode_csv(*found.mode, csv);
  const auto lines = lines_of(csv.str());
  BOOST_TEST_REQUIRE(lines.size() == 1u + 41u + 40u);
  BOOST_TEST(lines[0] ==
             "x,effective_stress,pore_pressure,solid_velocity,fluid_velocity,"
             "effective_stress_amplitude,pore_pressure_amplitude,solid_velocity_amplitude,"
             "fluid_velocity_amplitude");
  double before = -1.0;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    BOOST_TEST(std::count(lines[k].begin(), lines[k].end(), ',') == 8);
    const double x = std::stod(lines[k]);
    BOOST_TEST(x > before);
    before = x;
    // A node, of which there is one at either end, has no stresses, a cell no velocities.
    BOOST_TEST((lines[k].find(",,,") == lines[k].find(',')) == (k % 2 == 1));
    BOOST_TEST(lines[k].ends_with(",,") == (k % 2 == 0));
  }
}

BOOST_AUTO_TEST_SUITE_END()
