#include "solver/stability/step_estimates.hpp"

#include <Eigen/Dense>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/problem/problem_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(step_estimates)

using namespace porowave;
using namespace porowave::solver;
namespace tt = boost::test_tools;

namespace {

Case scene_of(double permeability) {
  Case scene;
  scene.problem = fixtures::paper_problem();
  scene.problem.material.intrinsic_permeability = permeability;
  return scene;
}

// Growth a step of the shortest wave of lumped linear elements of both phases, Euler–Cromer with
// explicit drag: w' = w − Δt M⁻¹ D w − Δt² M⁻¹ K u 4/h², u' = u + w', w = Δt v.
double growth_with_explicit_drag(const Case& scene, double dt) {
  const Material& m = scene.problem.material;
  const double h = *scene.problem.column.length / scene.discretization.elements;
  const double ns = m.solid_fraction(), nf = m.porosity, k = m.storage_modulus();
  Eigen::Matrix2d stiffness, drag, mass;
  stiffness << m.constrained_modulus + k * ns * ns, k * ns * nf, k * ns * nf, k * nf * nf;
  drag << 1, -1, -1, 1;
  mass << m.solid_partial_density(), 0, 0, m.fluid_partial_density();
  const Eigen::Matrix2d by_u = mass.inverse() * stiffness * 4.0 * dt * dt / (h * h);
  const Eigen::Matrix2d by_w = mass.inverse() * drag * m.drag() * dt;
  Eigen::Matrix4d step;
  step.topLeftCorner<2, 2>() = Eigen::Matrix2d::Identity() - by_w;
  step.topRightCorner<2, 2>() = -by_u;
  step.bottomLeftCorner<2, 2>() = Eigen::Matrix2d::Identity() - by_w;
  step.bottomRightCorner<2, 2>() = Eigen::Matrix2d::Identity() - by_u;
  return step.eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace

BOOST_AUTO_TEST_CASE(waves_cross_a_cell) {
  const Case scene = scene_of(1e-11);
  const StepEstimates estimates = solver::step_estimates(scene);
  BOOST_TEST(estimates.fast_wave * wave_speeds(scene.problem.material).p1 == 1e-3,
             tt::tolerance(1e-14));
  BOOST_TEST(estimates.undrained_wave * scene.problem.material.undrained_speed() == 1e-3,
             tt::tolerance(1e-14));
  BOOST_TEST(estimates.undrained_wave > estimates.fast_wave);
}

// With explicit drag that step is stable and, where drag or inertia alone decide, one a little
// longer is not.
BOOST_AUTO_TEST_CASE(explicit_drag_is_limited_as_said) {
  for (int exponent = -16; exponent <= -5; ++exponent) {
    const Case scene = scene_of(std::pow(10.0, exponent));
    const double dt = solver::step_estimates(scene).explicit_drag;
    BOOST_TEST_CONTEXT("permeability 1e" << exponent) {
      BOOST_TEST(growth_with_explicit_drag(scene, dt * (1.0 - 1e-6)) < 1.0 + 1e-6);
      if (exponent < -13 || exponent > -8) {
        BOOST_TEST(growth_with_explicit_drag(scene, 1.02 * dt) > 1.0 + 1e-3);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(explicit_drag_has_the_two_limits) {
  const Case none = scene_of(1.0);
  BOOST_TEST(solver::step_estimates(none).explicit_drag == solver::step_estimates(none).fast_wave,
             tt::tolerance(1e-6));
  const Case much = scene_of(1e-18);
  BOOST_TEST(
      solver::step_estimates(much).explicit_drag == 2.0 / much.problem.material.relaxation_rate(),
      tt::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(linear_shape_functions_have_a_limit_of_their_own) {
  Case scene = scene_of(1e-11);
  BOOST_TEST(!solver::step_estimates(scene).linear_shape);
  scene.discretization.transfer = TransferName::shape;
  scene.discretization.shape = shape_name<LinearSpline>;
  const StepEstimates estimates = solver::step_estimates(scene);
  BOOST_TEST_REQUIRE(estimates.linear_shape.has_value());
  BOOST_TEST(*estimates.linear_shape == std::sqrt(0.5) * estimates.fast_wave, tt::tolerance(1e-12));
  scene.discretization.shape = shape_name<SplineShape<BSpline2>>;
  BOOST_TEST(!solver::step_estimates(scene).linear_shape);
}

BOOST_AUTO_TEST_SUITE_END()
