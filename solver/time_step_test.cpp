#include "solver/time_step.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/problem/errors.hpp"
#include "reference/problem/problem_fixtures.hpp"
#include "solver/case_fixtures.hpp"
#include "solver/column_solver.hpp"
#include "solver/staggered/staggered_solver.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(time_step)

namespace {

using namespace test;

Case papers_case(int elements) {
  Case scene;
  scene.problem = fixtures::paper_problem();
  scene.discretization.elements = elements;
  return scene;
}

Case linear_shape(Placement placement, int points_per_element) {
  Case scene = papers_case(60);
  scene.discretization.transfer = TransferName::shape;
  scene.discretization.shape = shape_name<LinearSpline>;
  scene.discretization.placement = placement;
  scene.discretization.points_per_element = points_per_element;
  return scene;
}

double largest(const std::vector<double>& values) {
  double size = 0.0;
  for (const double value : values) {
    if (!std::isfinite(value)) return HUGE_VAL;
    size = std::max(size, std::abs(value));
  }
  return size;
}

// Largest stress or velocity of any point at ten times of a run, in multiples of the load's;
// infinite where a field is not finite.
template <class Solver>
double largest_share(const Case& scene) {
  Solver solver(scene);
  const double stress = scene.problem.stress_scale();
  const double velocity = scene.problem.velocity_scale();
  double share = 0.0;
  for (long k = 1; k <= 10; ++k) {
    while (solver.steps_done() < k * solver.planned_steps() / 10) solver.step();
    const Snapshot now = solver.snapshot();
    for (const double size :
         {largest(now.solid.stress) / stress, largest(now.fluid.stress) / stress,
          largest(now.solid.velocity) / velocity, largest(now.fluid.velocity) / velocity}) {
      share = std::max(share, size);
    }
  }
  return share;
}

double largest_share(const Case& scene) {
  return scene.discretization.scheme == Scheme::staggered4 ? largest_share<StaggeredSolver>(scene)
                                                           : largest_share<ColumnSolver>(scene);
}

// Without drag, through 20 crossings of the column by the fast wave.
Case long_run(Case scene, double courant) {
  scene.problem.material.intrinsic_permeability = 1.0;
  scene.time.end = 20.0 * *scene.problem.column.length / wave_speeds(scene.problem.material).p1;
  scene.time.courant = courant;
  return scene;
}

bool breaks_down(const Case& scene) {
  return ColumnSolver(scene).run().has_value();
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_scheme_has_its_estimate) {
  Case scene = linear_shape(Placement::uniform, 4);
  BOOST_TEST(std::abs(estimated_courant(scene) - 0.9 * std::sqrt(0.5)) < 1e-12);
  scene.discretization.transfer = TransferName::apic;
  BOOST_TEST(std::abs(estimated_courant(scene) - 0.9 * std::sqrt(0.5)) < 1e-12);
  scene.discretization.scheme = Scheme::staggered4;
  BOOST_TEST(estimated_courant(scene) == 0.8);
  scene.discretization.placement = Placement::stratified;
  BOOST_TEST(estimated_courant(scene) == 0.5);
  scene.time.order = 4;
  BOOST_TEST(estimated_courant(scene) == 0.8);
}

BOOST_AUTO_TEST_CASE(the_limit_of_uniform_points_is_one_over_root_two) {
  for (const int points : {1, 2, 3, 4, 7}) {
    const Case scene = linear_shape(Placement::uniform, points);
    const double limit = linear_shape_limit(scene);
    BOOST_TEST(std::abs(limit - std::sqrt(0.5)) < 1e-12);
    BOOST_TEST(largest_share(long_run(scene, 0.99 * limit)) < 10.0);
    BOOST_TEST(breaks_down(long_run(scene, 1.1 * limit)));
  }
}

// At 0.6, where uniform points are safe, some of these columns are not.
BOOST_AUTO_TEST_CASE(the_limit_holds_for_the_points_that_a_case_has) {
  int unstable = 0;
  for (const auto& [placement, points] :
       {std::pair(Placement::stratified, 1), std::pair(Placement::stratified, 2),
        std::pair(Placement::stratified, 4), std::pair(Placement::random, 8)}) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      Case scene = linear_shape(placement, points);
      scene.discretization.seed = seed;
      const double limit = linear_shape_limit(scene);
      BOOST_TEST_CONTEXT(name(placement) << ", " << points << " points, seed " << seed) {
        BOOST_TEST(limit < std::sqrt(0.5));
        BOOST_TEST(largest_share(long_run(scene, 0.99 * limit)) < 100.0);
      }
      unstable += breaks_down(long_run(scene, 0.6)) ? 1 : 0;
    }
  }
  BOOST_TEST(unstable > 5);
}

BOOST_AUTO_TEST_CASE(moving_least_squares_stay_bounded_at_their_estimate) {
  for (std::size_t k = 0; k < kernel_count; ++k) {
    for (const Placement placement : {Placement::uniform, Placement::stratified}) {
      Case scene = papers_case(60);
      Discretization& d = scene.discretization;
      d.kernel = KernelName{k};
      d.support_radius = natural_radius(d.kernel);
      d.placement = placement;
      d.strain = placement == Placement::uniform ? Strain::cell : Strain::recovered;
      const double share = largest_share(long_run(scene, estimated_courant(scene)));
      BOOST_TEST_MESSAGE(to_string(d.kernel) << ", " << name(placement) << ": " << share);
      BOOST_TEST(share < 10.0);
    }
  }
}

// From a drag that levels both velocities within 1e-7 of a step to none at all.
BOOST_AUTO_TEST_CASE(drag_never_limits_the_time_step) {
  for (const Scheme scheme : {Scheme::galerkin, Scheme::staggered4}) {
    for (const auto near : {NearEnd::drained_traction, NearEnd::sealed_traction}) {
      for (int exponent = -18; exponent <= -6; ++exponent) {
        Case scene = papers_case(60);
        scene.problem.column.near = near;
        scene.problem.material.intrinsic_permeability = std::pow(10.0, exponent);
        scene.discretization.scheme = scheme;
        if (scheme == Scheme::staggered4) scene.discretization.basis_order = 2;
        scene.time.courant = estimated_courant(scene);
        scene.time.end = 2e-4;
        const double share = largest_share(scene);
        BOOST_TEST_MESSAGE((scheme == Scheme::galerkin ? "galerkin, " : "staggered4, ")
                           << name(near) << ", permeability 1e" << exponent << ": largest field "
                           << share << " of the load's");
        BOOST_TEST(share < 10.0);
        BOOST_TEST(share > 1.0);
      }
    }
  }
}

// Their number must not overflow to a single step.
BOOST_AUTO_TEST_CASE(a_run_of_too_many_steps_is_refused) {
  Case scene;
  scene.problem = fixtures::paper_problem(Load(LoadShape::smooth_ramp, 1.0, 1e-6));
  scene.time.end = 4e-5;
  scene.time.courant = 1e-9;
  BOOST_TEST(step_count(scene, 1e-3) > 10'000'000L);
  for (const double courant : {1e-14, 1e-17, 1e-300}) {
    scene.time.courant = courant;
    BOOST_CHECK_THROW(step_count(scene, 1e-3), InputError);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
