#include "solver/prepared_update.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/problem/problem_fixtures.hpp"
#include "solver/transfer_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(prepared_update)

using namespace porowave;
using namespace porowave::solver;

namespace {

constexpr std::size_t nodes = 43;

// Masses like those of a grid with h = 1 mm; some nodes without one of the phases, some without
// both.
PhaseNodes some_nodes(double density, unsigned seed, std::size_t missing) {
  PhaseNodes n;
  n.resize(nodes);
  n.volume = test::noise(nodes, seed, 0.5e-3, 1.5e-3);
  n.velocity = test::noise(nodes, seed + 1);
  for (std::size_t i = 0; i < nodes; ++i) n.mass[i] = density * n.volume[i];
  for (const std::size_t i : {missing, std::size_t{20}}) n.mass[i] = n.volume[i] = 0.0;
  return n;
}

double largest_velocity_difference(const PhaseNodes& a, const PhaseNodes& b) {
  return std::max(test::largest_difference(a.velocity, b.velocity),
                  test::largest_difference(a.new_velocity, b.new_velocity));
}

}  // namespace

BOOST_AUTO_TEST_CASE(nodes_move_as_by_update_nodes) {
  const double dt = 1e-7;
  const auto effective = test::noise(nodes, 50);
  const auto pressure = test::noise(nodes, 51);
  for (const double permeability : {1e-8, 1e-11, 1e-17}) {
    for (const NearEnd near : {NearEnd::drained_traction, NearEnd::sealed_traction,
                               NearEnd::fluid_pressure, NearEnd::velocity}) {
      for (const FarEnd far : {FarEnd::rigid_sealed, FarEnd::rigid_drained, FarEnd::free_drained}) {
        Problem problem = fixtures::paper_problem(Load(LoadShape::step, 1.0));
        problem.material.intrinsic_permeability = permeability;
        problem.column.near = near;
        problem.column.far = far;
        PhaseNodes solid = some_nodes(1590.0, 1, 7);
        PhaseNodes fluid = some_nodes(400.0, 5, 31);
        PhaseNodes solid_parts = solid;
        PhaseNodes fluid_parts = fluid;
        const StepLoad load{0.4, 0.3, 0.5};
        const PreparedUpdate prepared(problem, dt, solid, fluid);
        for (const IndexRange part : {IndexRange{0, 16}, IndexRange{16, nodes}}) {
          prepared.apply(problem, load, part,
                         {effective.data() + part.first, pressure.data() + part.first}, solid_parts,
                         fluid_parts);
        }
        const Material& m = problem.material;
        for (std::size_t i = 0; i < nodes; ++i) {
          solid.force[i] = effective[i] - m.solid_fraction() * pressure[i];
          fluid.force[i] = -m.porosity * pressure[i];
        }
        update_nodes(problem, load, dt, solid, fluid);
        BOOST_TEST(largest_velocity_difference(solid, solid_parts) < 1e-14);
        BOOST_TEST(largest_velocity_difference(fluid, fluid_parts) < 1e-14);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
