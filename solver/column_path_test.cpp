// The ways to make a step, and what must not depend on them.

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/problem/problem_fixtures.hpp"
#include "solver/breakdown_cause.hpp"
#include "solver/column_fixtures.hpp"
#include "solver/column_solver.hpp"

BOOST_AUTO_TEST_SUITE(column_path)

using namespace porowave;
using namespace porowave::solver;
using test::largest_difference;

namespace {

Case scene_with(int elements, long steps, StepPath path) {
  Case scene;
  scene.problem = fixtures::paper_problem(Load(LoadShape::smooth_ramp, 1.0, 1e-5));
  scene.discretization.elements = elements;
  scene.time.path = path;
  const double h = *scene.problem.column.length / elements;
  scene.time.end =
      static_cast<double>(steps) * scene.time.courant * h / wave_speeds(scene.problem.material).p1;
  return scene;
}

Snapshot result_of(const Case& scene) {
  ColumnSolver solver(scene);
  BOOST_TEST(!solver.run());
  return solver.snapshot();
}

// Largest difference of any field, stresses by the load and velocities by its velocity.
double difference(const Snapshot& a, const Snapshot& b, const Problem& problem) {
  const double stress = problem.stress_scale();
  const double velocity = problem.velocity_scale();
  return std::max({largest_difference(a.solid.stress, b.solid.stress) / stress,
                   largest_difference(a.fluid.stress, b.fluid.stress) / stress,
                   largest_difference(a.effective_stress, b.effective_stress) / stress,
                   largest_difference(a.pore_pressure, b.pore_pressure) / stress,
                   largest_difference(a.solid.velocity, b.solid.velocity) / velocity,
                   largest_difference(a.fluid.velocity, b.fluid.velocity) / velocity,
                   largest_difference(a.solid_velocity, b.solid_velocity) / velocity,
                   largest_difference(a.fluid_velocity, b.fluid_velocity) / velocity});
}

double path_difference(Case scene) {
  scene.time.path = StepPath::points;
  const Snapshot points = result_of(scene);
  scene.time.path = StepPath::frozen;
  return difference(points, result_of(scene), scene.problem);
}

// A load that moves points by several thousandths of h.
Case moving_scene(StepPath path) {
  Case scene = scene_with(60, 300, path);
  scene.problem.load = Load(LoadShape::smooth_ramp, 2.5e6, 1e-5);
  return scene;
}

}  // namespace

BOOST_AUTO_TEST_CASE(frozen_is_points_after_ten_thousand_steps) {
  const double found = path_difference(scene_with(100, 10'000, StepPath::automatic));
  BOOST_TEST_MESSAGE("difference / load: " << found);
  BOOST_TEST(found < 1e-10);
}

BOOST_AUTO_TEST_CASE(frozen_is_points_for_every_transfer_and_blend) {
  for (const Discretization& transfer :
       {test::shape(), test::mls<BSpline1>(1.0, 1), test::mls<BSpline2>(1.5, 1),
        test::mls<BSpline3>(2.0, 2), test::mls<WendlandC2>(5.0, 0), test::mls<WendlandC6>(3.0, 1),
        test::recovered(test::mls<BSpline2>(1.5, 1)), test::adaptive(test::mls<BSpline1>(1.0, 1)),
        test::recovered(test::shape())}) {
    for (const double flip : {1.0, 0.95, 0.0}) {
      BOOST_TEST_CONTEXT(test::title(transfer) << ", flip " << flip) {
        Case scene = scene_with(50, 200, StepPath::automatic);
        const int elements = scene.discretization.elements;
        scene.discretization = transfer;
        scene.discretization.elements = elements;
        scene.discretization.placement = Placement::stratified;
        scene.discretization.points_per_element = 3;
        scene.discretization.empty_elements = {0.05};
        scene.time.flip = flip;
        BOOST_TEST(path_difference(scene) < 1e-10);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(frozen_is_points_for_all_ends) {
  for (const NearEnd near : {NearEnd::drained_traction, NearEnd::sealed_traction,
                             NearEnd::fluid_pressure, NearEnd::velocity}) {
    for (const FarEnd far : {FarEnd::rigid_sealed, FarEnd::rigid_drained, FarEnd::free_drained}) {
      Case scene = scene_with(40, 300, StepPath::automatic);
      scene.problem.column.near = near;
      scene.problem.column.far = far;
      if (near == NearEnd::velocity) scene.problem.load = Load(LoadShape::sin4_pulse, 1e-7, 1e-5);
      BOOST_TEST(path_difference(scene) < 1e-10);
    }
  }
}

BOOST_AUTO_TEST_CASE(auto_is_frozen_while_points_stay) {
  ColumnSolver still(scene_with(60, 100, StepPath::automatic));
  still.run();
  BOOST_TEST((still.path() == StepPath::frozen));
  BOOST_TEST(still.frozen_steps() == still.steps_done());
  ColumnSolver points(scene_with(60, 100, StepPath::points));
  points.run();
  BOOST_TEST((points.path() == StepPath::points));
  BOOST_TEST(points.frozen_steps() == 0);
}

BOOST_AUTO_TEST_CASE(auto_goes_on_with_points_without_a_jump) {
  ColumnSolver mixed(moving_scene(StepPath::automatic));
  ColumnSolver points(moving_scene(StepPath::points));
  while (mixed.path() == StepPath::frozen && mixed.steps_done() < 300) {
    mixed.step();
    points.step();
  }
  BOOST_TEST(mixed.steps_done() > 5);
  BOOST_TEST(mixed.steps_done() < 290);
  const Problem& problem = moving_scene(StepPath::points).problem;
  BOOST_TEST(difference(mixed.snapshot(), points.snapshot(), problem) < 1e-12);
  BOOST_TEST(!mixed.run());
  BOOST_TEST(!points.run());
  BOOST_TEST(mixed.frozen_steps() < mixed.steps_done());
  BOOST_TEST(difference(mixed.snapshot(), points.snapshot(), problem) < 1e-10);
  BOOST_TEST(largest_difference(mixed.snapshot().solid.x, points.snapshot().solid.x) < 1e-15);
}

BOOST_AUTO_TEST_CASE(frozen_only_ends_where_points_move_too_far) {
  ColumnSolver solver(moving_scene(StepPath::frozen));
  const auto breakdown = solver.run();
  BOOST_REQUIRE(breakdown);
  BOOST_TEST(breakdown->step == solver.steps_done());
  BOOST_TEST(breakdown->reason.find("displacement is more than 0.001 of an element") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(an_explosion_is_found_by_both_paths) {
  for (const StepPath path : {StepPath::points, StepPath::automatic}) {
    Case scene = scene_with(50, 2000, path);
    scene.discretization.placement = Placement::stratified;
    scene.discretization.transfer = TransferName::shape;
    scene.discretization.kernel = kernel_name<BSpline1>;
    scene.discretization.support_radius = 1.0;
    scene.time.courant = 1.0;
    ColumnSolver solver(scene);
    const auto breakdown = solver.run();
    BOOST_REQUIRE(breakdown);
    const std::string reason = reason_and_cause(scene, *breakdown);
    BOOST_TEST(reason.find("try a smaller courant") != std::string::npos, reason);
  }
}

BOOST_AUTO_TEST_CASE(nothing_is_missed_ahead_of_the_signal) {
  for (const StepPath path : {StepPath::points, StepPath::frozen}) {
    for (const double radius : {1.5, 4.0, 1.0}) {
      Case scene = scene_with(700, 500, path);
      scene.discretization.adaptive_support = radius == 1.0;
      scene.discretization.strain = radius == 1.5 ? Strain::recovered : Strain::cell;
      scene.problem.load = Load(LoadShape::step, 1.0);
      scene.discretization.placement = Placement::jittered;
      scene.discretization.support_radius = radius;
      ColumnSolver window(scene);
      ColumnSolver all(scene);
      all.disregard_causality();
      BOOST_TEST(!window.run());
      BOOST_TEST(!all.run());
      // A change of 1e-30 far ahead can still turn the last bit of a small value, which grows with
      // it when the wave arrives.
      BOOST_TEST(difference(window.snapshot(), all.snapshot(), scene.problem) < 1e-13);
    }
  }
}

BOOST_AUTO_TEST_CASE(threads_do_not_change_a_bit) {
  for (const StepPath path : {StepPath::points, StepPath::frozen}) {
    Case scene = scene_with(1000, 40, path);
    scene.discretization.strain = Strain::recovered;
    ColumnSolver one(scene);
    one.disregard_causality();
    one.run();
    for (const std::size_t threads : {2u, 3u, 7u}) {
      ColumnSolver many(scene);
      many.disregard_causality();
      many.use_threads(threads);
      many.run();
      BOOST_TEST(difference(one.snapshot(), many.snapshot(), scene.problem) == 0.0);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
