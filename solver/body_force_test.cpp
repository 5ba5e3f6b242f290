#include "solver/body_force.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "reference/problem/problem_fixtures.hpp"
#include "solver/column_solver.hpp"

BOOST_AUTO_TEST_SUITE(body_force)

using namespace porowave;
using namespace porowave::solver;

namespace {

Case quiet_case() {
  Case scene;
  scene.problem = fixtures::paper_problem(Load(LoadShape::step, 0.0));
  scene.discretization.elements = 40;
  scene.discretization.strain = Strain::cell;
  scene.time.end = 1e-5;
  return scene;
}

double momentum(const PhasePoints& points, double density) {
  double sum = 0.0;
  for (std::size_t p = 0; p < points.x.size(); ++p) {
    sum += density * points.volume[p] * points.velocity[p];
  }
  return sum;
}

}  // namespace

BOOST_AUTO_TEST_CASE(each_phase_gets_its_force) {
  const Material m = fixtures::paper_material();
  const Grid<1> grid(Vector<1>(0.0), 0.5, CellIndex<1>(4));
  const std::vector<double> vs{0.25, 0.5, 0.5, 0.4, 0.25};
  const std::vector<double> vf{0.25, 0.5, 0.3, 0.5, 0.2};
  const BodyForce force = [](double x, double t) { return PhaseForces{3.0 * x + t, 5.0 - x * t}; };
  std::vector<double> effective{1.0, 2.0, 3.0};
  std::vector<double> pressure{4.0, 5.0, 6.0};
  add_body_force(force, 2.0, 0.5, m, grid, {vs, vf}, {1, 4}, effective.data(), pressure.data());
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = 0.5 * static_cast<double>(k + 1);
    const double before_solid =
        1.0 + static_cast<double>(k) - m.solid_fraction() * (4.0 + static_cast<double>(k));
    const double before_fluid = -m.porosity * (4.0 + static_cast<double>(k));
    const double solid = effective[k] - m.solid_fraction() * pressure[k];
    const double fluid = -m.porosity * pressure[k];
    BOOST_TEST(std::abs(solid - before_solid - 0.5 * (3.0 * x + 2.0) * vs[k + 1]) < 1e-12);
    BOOST_TEST(std::abs(fluid - before_fluid - 0.5 * (5.0 - 2.0 * x) * vf[k + 1]) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(a_steady_force_becomes_momentum) {
  // Both ends are free, so nothing else acts on the mixture.
  for (const TransferName transfer : {TransferName::shape, TransferName::mls}) {
    Case scene = quiet_case();
    scene.discretization.transfer = transfer;
    scene.problem.column.far = FarEnd::free_drained;
    ColumnSolver solver(scene);
    solver.set_body_force([](double, double) { return PhaseForces{2.0, 3.0}; });
    BOOST_REQUIRE(!solver.run());
    const Snapshot now = solver.snapshot();
    const Material& m = scene.problem.material;
    const double total = momentum(now.solid, m.solid_partial_density()) +
                         momentum(now.fluid, m.fluid_partial_density());
    BOOST_TEST(total == 5.0 * 0.1 * scene.time.end, boost::test_tools::tolerance(1e-10));
  }
}

BOOST_AUTO_TEST_CASE(a_start_is_where_it_was_asked_to_be) {
  for (const StepPath path : {StepPath::automatic, StepPath::points}) {
    Case scene = quiet_case();
    scene.time.path = path;
    ColumnSolver stressed(scene);
    stressed.start_from([](double x, double) { return Fields{3.0 * x, 4.0 - x, 0.0, 0.0}; });
    const Snapshot stresses = stressed.snapshot();
    // Both phases move together and have no stress, so the velocities of −Δt/2 are those of t = 0.
    ColumnSolver moving(scene);
    const auto velocity = [](double x, double t) { return (0.1 - x) * (5.0 + 1e5 * t); };
    moving.start_from([&](double x, double t) {
      return Fields{0.0, 0.0, velocity(x, t), velocity(x, t)};
    });
    const Snapshot velocities = moving.snapshot();
    const double before = -0.5 * moving.time_step();
    for (std::size_t p = 0; p < stresses.solid.x.size(); ++p) {
      const double x = velocities.solid.x[p];
      BOOST_TEST(std::abs(stresses.solid.stress[p] - 3.0 * x) < 1e-12);
      BOOST_TEST(std::abs(stresses.fluid.stress[p] - (4.0 - x)) < 1e-12);
      BOOST_TEST(std::abs(velocities.solid.velocity[p] - velocity(x, before)) < 1e-12);
      BOOST_TEST(std::abs(velocities.fluid.velocity[p] - velocity(x, before)) < 1e-12);
    }
    BOOST_TEST(std::abs(velocities.node_x[7] - 0.0175) < 1e-12);
    BOOST_TEST(std::abs(velocities.solid_velocity[7] - velocity(0.0175, before)) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(starts_and_forces_that_have_no_place_are_refused) {
  const auto rest = [](double, double) { return Fields{}; };
  ColumnSolver running(quiet_case());
  running.step();
  BOOST_CHECK_THROW(running.start_from(rest), std::invalid_argument);
  const BodyForce force = [](double, double) { return PhaseForces{1.0, 1.0}; };
  BOOST_CHECK_THROW(running.set_body_force(force), std::invalid_argument);
  Case eliminated = quiet_case();
  eliminated.time.path = StepPath::frozen;
  ColumnSolver frozen(eliminated);
  BOOST_CHECK_THROW(frozen.start_from(rest), std::invalid_argument);
  BOOST_CHECK_THROW(frozen.set_body_force(force), std::invalid_argument);
  Case affine = quiet_case();
  affine.discretization.transfer = TransferName::apic;
  ColumnSolver solver(affine);
  BOOST_CHECK_THROW(solver.start_from(rest), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_run_that_is_not_driven_by_its_load_stops_at_values_that_are_not_finite) {
  ColumnSolver solver(quiet_case());
  solver.set_body_force([](double, double t) {
    return PhaseForces{t > 5e-6 ? std::numeric_limits<double>::quiet_NaN() : 1.0, 0.0};
  });
  const auto breakdown = solver.run();
  BOOST_REQUIRE(breakdown.has_value());
  BOOST_TEST(breakdown->reason.find("not a finite number") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
