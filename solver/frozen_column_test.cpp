#include "solver/frozen_column.hpp"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "reference/problem/problem_fixtures.hpp"
#include "solver/column_fixtures.hpp"
#include "solver/general_operators.hpp"

using namespace porowave;
using namespace porowave::solver;
using test::largest_difference;

namespace {

constexpr std::size_t cells = test::column_cells;
constexpr std::size_t nodes = cells + 1;

// One phase with its points, for the step in its plain form.
struct Phase {
  PreparedPhase prepared;
  PhaseNodes at_nodes;
  PointValues values;
  std::vector<double> displacement = std::vector<double>(nodes);

  Phase(const PointSet<1>& points, const Discretization& choice)
      : prepared(prepare_phase(points, test::column_grid(), choice)) {
    at_nodes.resize(nodes);
    at_nodes.mass = prepared.nodal_mass;
    at_nodes.volume = prepared.nodal_volume;
    values.velocity.resize(points.x.size());
    values.stress.resize(points.x.size());
  }
};

struct Pair {
  Problem problem = fixtures::paper_problem(Load(LoadShape::step, 1.0));
  double dt = 1e-7;
  FrozenColumn::Constants constants;
  Phase solid;
  Phase fluid;

  Pair(const PointSet<1>& solid_points, const PointSet<1>& fluid_points,
       const Discretization& choice, double flip)
      : constants{flip,
                  problem.material.solid_fraction(),
                  problem.material.porosity,
                  dt * problem.material.constrained_modulus,
                  -dt * problem.material.storage_modulus(),
                  dt},
        solid(solid_points, choice),
        fluid(fluid_points, choice) {}

  StepLoad load(int step) const { return {1.0 + 0.1 * step, 1.0, 1.0}; }

  void step_points(int step) {
    std::vector<double> pressure_force(nodes);
    for (Phase* phase : {&solid, &fluid}) {
      auto& force = phase == &solid ? solid.at_nodes.force : pressure_force;
      phase->prepared.operators->gather(phase->values, {0, nodes}, phase->at_nodes.velocity.data(),
                                        force.data());
    }
    std::vector<double> mixture(nodes);
    for (std::size_t i = 0; i < nodes; ++i) {
      solid.at_nodes.force[i] -= constants.solid_fraction * pressure_force[i];
      fluid.at_nodes.force[i] = -constants.porosity * pressure_force[i];
    }
    update_nodes(problem, load(step), dt, solid.at_nodes, fluid.at_nodes);
    for (std::size_t i = 0; i < nodes; ++i) {
      mixture[i] = constants.solid_fraction * solid.at_nodes.new_velocity[i] +
                   constants.porosity * fluid.at_nodes.new_velocity[i];
    }
    scatter(solid, solid.at_nodes.new_velocity, constants.effective_stress);
    scatter(fluid, mixture, constants.pore_pressure);
  }

  void scatter(Phase& phase, const std::vector<double>& b, double c) const {
    const PhaseNodes& at = phase.at_nodes;
    phase.prepared.operators->scatter(
        {constants.flip, at.velocity.data(), at.new_velocity.data(), b.data(), c}, {0, cells},
        phase.values);
    for (std::size_t i = 0; i < nodes; ++i) phase.displacement[i] += dt * at.new_velocity[i];
  }
};

double relative_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (const double value : a) largest = std::max(largest, std::abs(value));
  return largest_difference(a, b) / largest;
}

void compare(const PointSet<1>& solid, const PointSet<1>& fluid, const Discretization& choice,
             double flip) {
  Pair pair(solid, fluid, choice, flip);
  const Pair start(pair);
  const PreparedUpdate update(pair.problem, pair.dt, pair.solid.at_nodes, pair.fluid.at_nodes);
  const bool same = &solid == &fluid;
  FrozenColumn frozen(start.solid.prepared.operators,
                      (same ? start.solid : start.fluid).prepared.operators, pair.constants);
  PhaseNodes solid_nodes = start.solid.at_nodes;
  PhaseNodes fluid_nodes = start.fluid.at_nodes;
  for (int step = 0; step < 40; ++step) {
    pair.step_points(step);
    for (const std::size_t first : {512, 0, 256}) {  // in any order
      frozen.step(pair.problem, pair.load(step), update, {first, std::min(first + 256, nodes)},
                  solid_nodes, fluid_nodes);
    }
    frozen.end_step();
  }
  PointValues solid_values = start.solid.values;
  PointValues fluid_values = start.fluid.values;
  frozen.settle(solid_values, fluid_values);
  BOOST_TEST(relative_difference(pair.solid.values.velocity, solid_values.velocity) < 1e-11);
  BOOST_TEST(relative_difference(pair.solid.values.stress, solid_values.stress) < 1e-11);
  BOOST_TEST(relative_difference(pair.fluid.values.velocity, fluid_values.velocity) < 1e-11);
  BOOST_TEST(relative_difference(pair.fluid.values.stress, fluid_values.stress) < 1e-11);
  std::vector<double> us(nodes), uf(nodes);
  const double bound = frozen.displacement_bound();
  frozen.displacements(us, uf);
  BOOST_TEST(relative_difference(pair.solid.displacement, us) < 1e-11);
  BOOST_TEST(relative_difference(pair.fluid.displacement, uf) < 1e-11);
  BOOST_TEST(bound >= frozen.displacement_bound());
  BOOST_TEST(bound < 1e3 * frozen.displacement_bound());
}

}  // namespace

BOOST_AUTO_TEST_SUITE(frozen_column)

BOOST_AUTO_TEST_CASE(the_points_are_the_same_as_if_visited) {
  const auto other = test::column_points(3);
  test::for_all_columns([&](const auto& points, const auto&, const auto& choice) {
    for (const double flip : {1.0, 0.9, 0.0}) compare(points, other, choice, flip);
  });
}

BOOST_AUTO_TEST_CASE(phases_with_the_same_points_share_their_operators) {
  test::for_all_columns([](const auto& points, const auto&, const auto& choice) {
    compare(points, points, choice, 1.0);
  });
}

BOOST_AUTO_TEST_CASE(other_operators_are_refused) {
  const auto points = test::column_points(4);
  const auto general = std::make_shared<GeneralOperators>(
      Transfer<1>(points, test::column_grid(), test::shape()), points.x.size());
  BOOST_TEST(!FrozenColumn::possible(*general));
  BOOST_CHECK_THROW(FrozenColumn(general, general, {}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
