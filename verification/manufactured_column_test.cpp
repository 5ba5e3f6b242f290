// The two-phase column under volume forces that make a smooth motion its solution: every term of
// the equations at once, order two. Independent of the transform-domain reference.

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "reference/problem/problem_fixtures.hpp"
#include "solver/column_solver.hpp"
#include "verification/field_errors.hpp"
#include "verification/manufactured/two_phase_motion.hpp"

BOOST_AUTO_TEST_SUITE(manufactured_column)

using namespace porowave;
using namespace porowave::verification;
using solver::Case;
using solver::Snapshot;
using solver::Strain;

namespace {

TwoPhaseMotion motion(NearEnd near, double permeability) {
  Material m = fixtures::paper_material();
  m.intrinsic_permeability = permeability;
  return {m, 0.1, near, 1e-9};  // nothing moves
}

template <class Kernel>
Case scene_of(const TwoPhaseMotion& motion, Strain strain) {
  Case scene;
  scene.problem = motion.problem();
  scene.discretization.kernel = solver::kernel_name<Kernel>;
  scene.discretization.support_radius = Kernel::natural_radius;
  scene.discretization.strain = strain;
  scene.time.end = 2.5 * motion.time_scale();
  return scene;
}

/// Relative L2 errors of the four fields, at the points and then of the reconstructed fields.
using Errors = std::array<double, 8>;

double error(const std::vector<double>& values, const std::vector<double>& x,
             const std::vector<double>& weights, const TwoPhaseMotion& motion, double t,
             double Fields::*field) {
  std::vector<double> expected;
  for (const double place : x) expected.push_back(motion.fields(place, t).*field);
  return relative_norms(values, expected, weights).l2;
}

Errors errors_of(const Snapshot& s, const TwoPhaseMotion& motion) {
  const std::vector<double> cells(s.cell_x.size(), 1.0);
  const std::vector<double> nodes(s.node_x.size(), 1.0);
  const auto of = [&](const std::vector<double>& values, const std::vector<double>& x,
                      const std::vector<double>& weights, double Fields::*field) {
    return error(values, x, weights, motion, s.time, field);
  };
  return {of(s.solid.stress, s.solid.x, s.solid.volume, &Fields::effective_stress),
          of(s.fluid.stress, s.fluid.x, s.fluid.volume, &Fields::pore_pressure),
          of(s.solid.velocity, s.solid.x, s.solid.volume, &Fields::solid_velocity),
          of(s.fluid.velocity, s.fluid.x, s.fluid.volume, &Fields::fluid_velocity),
          of(s.effective_stress, s.cell_x, cells, &Fields::effective_stress),
          of(s.pore_pressure, s.cell_x, cells, &Fields::pore_pressure),
          of(s.solid_velocity, s.node_x, nodes, &Fields::solid_velocity),
          of(s.fluid_velocity, s.node_x, nodes, &Fields::fluid_velocity)};
}

Errors run(Case scene, const TwoPhaseMotion& motion, int elements) {
  scene.discretization.elements = elements;
  solver::ColumnSolver solver(scene);
  solver.start_from([&](double x, double t) { return motion.fields(x, t); });
  solver.set_body_force([&](double x, double t) { return motion.body_force(x, t); });
  BOOST_REQUIRE(!solver.run());
  return errors_of(solver.snapshot(), motion);
}

constexpr std::array<int, 4> elements{50, 100, 200, 400};

std::string name_of(std::size_t field) {
  return std::string(field_names[field % 4]) + (field < 4 ? " at the points" : " of the field");
}

/// Orders of every refinement, of the fields from `first_field` on.
void check_orders(const char* title, const Case& scene, const TwoPhaseMotion& motion,
                  std::size_t first_field = 0) {
  std::array<Errors, 4> levels;
  for (std::size_t k = 0; k < 4; ++k) levels[k] = run(scene, motion, elements[k]);
  for (std::size_t f = 0; f < 8; ++f) {
    std::array<double, 3> orders;
    for (std::size_t k = 0; k < 3; ++k) orders[k] = std::log2(levels[k][f] / levels[k + 1][f]);
    BOOST_TEST_MESSAGE(title << ", " << name_of(f) << ": errors " << levels[0][f] << " "
                             << levels[1][f] << " " << levels[2][f] << " " << levels[3][f]
                             << ", orders " << orders[0] << " " << orders[1] << " " << orders[2]);
    if (f < first_field) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      BOOST_TEST_CONTEXT(title << ", " << name_of(f) << ", from " << elements[k] << " cells") {
        BOOST_TEST(orders[k] >= 1.9);
        BOOST_TEST(orders[k] <= 2.1);
      }
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(all_fields_are_of_order_two_at_points_and_nodes) {
  const TwoPhaseMotion mild = motion(NearEnd::drained_traction, 1e-11);
  check_orders("mild drag, drained, bspline1", scene_of<solver::BSpline1>(mild, Strain::recovered),
               mild);
  check_orders("mild drag, drained, bspline2", scene_of<solver::BSpline2>(mild, Strain::recovered),
               mild);
  const TwoPhaseMotion held = motion(NearEnd::velocity, 1e-11);
  check_orders("mild drag, held, bspline2", scene_of<solver::BSpline2>(held, Strain::recovered),
               held);
}

BOOST_AUTO_TEST_CASE(stiff_drag_keeps_the_order) {
  // θ Δt is about 2 to 0.3, and 200 to 30.
  for (const double permeability : {1e-13, 1e-15}) {
    for (const NearEnd near : {NearEnd::velocity, NearEnd::drained_traction}) {
      const TwoPhaseMotion stiff = motion(near, permeability);
      const std::string title = "permeability " + std::to_string(permeability * 1e15) + "e-15, " +
                                std::string(name(near));
      check_orders(title.c_str(), scene_of<solver::BSpline2>(stiff, Strain::recovered), stiff);
    }
  }
}

BOOST_AUTO_TEST_CASE(strains_of_cells_give_fields_of_order_two) {
  // At points away from the middles of cells the stress is of first order, as it must be.
  const TwoPhaseMotion mild = motion(NearEnd::drained_traction, 1e-11);
  check_orders("cell strains", scene_of<solver::BSpline2>(mild, Strain::cell), mild, 4);
}

BOOST_AUTO_TEST_SUITE_END()
