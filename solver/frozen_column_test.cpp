#include "solver/frozen_column.hpp"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "reference/problem/problem_fixtures.hpp"
#include "solver/column_fixtures.hpp"
#include "solver/general_operators.hpp"

BOOST_AUTO_TEST_SUITE(frozen_column)

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
  double dt;
  FrozenColumn::Constants constants;
  Phase solid;
  Phase fluid;

  Pair(const PointSet<1>& solid_points, const PointSet<1>& fluid_points,
       const Discretization& choice, double flip, double step = 1e-7)
      : dt(step),
        constants{flip,
                  problem.material.solid_fraction(),
                  problem.material.porosity,
                  dt * problem.material.constrained_modulus,
                  -dt * problem.material.storage_modulus(),
                  dt},
        solid(solid_points, choice),
        fluid(fluid_points, choice) {}

  StepLoad load(int step) const { return {step < 10 ? 1.0 + 0.1 * step : 0.0, 1.0, 1.0}; }
  double largest_velocity() const {
    double largest = 0.0;
    for (const Phase* phase : {&solid, &fluid}) {
      for (const double v : phase->at_nodes.new_velocity) largest = std::max(largest, std::abs(v));
    }
    return largest;
  }

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
             double flip, double dt = 1e-7) {
  Pair pair(solid, fluid, choice, flip, dt);
  const Pair start(pair);
  const PreparedUpdate update(pair.problem, pair.dt, pair.solid.at_nodes, pair.fluid.at_nodes);
  const bool same = &solid == &fluid;
  FrozenColumn frozen(start.solid.prepared.operators,
                      (same ? start.solid : start.fluid).prepared.operators, update,
                      pair.constants);
  PhaseNodes solid_nodes = start.solid.at_nodes;
  PhaseNodes fluid_nodes = start.fluid.at_nodes;
  SignalWindow all = SignalWindow::whole_column(nodes);
  for (int step = 0; step < 40; ++step) {
    pair.step_points(step);
    const double bound_before = frozen.displacement_bound();
    const StepLoad load = pair.load(step);
    frozen.advance({pair.problem, update, solid_nodes, fluid_nodes}, {&load, 1}, all, 1);
    BOOST_TEST(frozen.displacement_bound() - bound_before >= 0.999 * dt * pair.largest_velocity());
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

// The wave runs through twenty cells, and leaves the first of them.
void compare_regular(const PointSet<1>& points, const Discretization& choice, double flip) {
  compare(points, points, choice, flip, 2e-6);
}

}  // namespace

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

BOOST_AUTO_TEST_CASE(the_points_are_the_same_where_nodes_are_regular) {
  for (const int per_cell : {1, 3, 4}) {
    for (const Discretization& choice : test::column_choices()) {
      BOOST_TEST_CONTEXT(test::title(choice)
                         << test::strain_title(choice) << ", " << per_cell << " points a cell") {
        for (const double flip : {1.0, 0.9}) {
          compare_regular(test::regular_points(per_cell), choice, flip);
          compare_regular(test::regular_points(per_cell, {0.805, 3.005}), choice, flip);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_bound_holds_where_the_fluid_moves_more) {
  const auto points = test::regular_points(4);
  Pair pair(points, points, test::mls<BSpline2>(1.5, 1), 1.0);
  pair.problem.column.near = NearEnd::fluid_pressure;
  pair.problem.material.intrinsic_permeability = 1e-6;
  for (double& mass : pair.fluid.at_nodes.mass) mass *= 0.1;
  const PreparedUpdate update(pair.problem, pair.dt, pair.solid.at_nodes, pair.fluid.at_nodes);
  const auto& operators = pair.solid.prepared.operators;
  FrozenColumn frozen(operators, operators, update, pair.constants);
  SignalWindow all = SignalWindow::whole_column(nodes);
  for (int step = 0; step < 30; ++step) {
    const StepLoad load = pair.load(step);
    frozen.advance({pair.problem, update, pair.solid.at_nodes, pair.fluid.at_nodes}, {&load, 1},
                   all, 1);
    const double bound = frozen.displacement_bound();
    std::vector<double> us(nodes), uf(nodes);
    frozen.displacements(us, uf);  // from here on the bound is the largest of them
    BOOST_TEST(bound >= 0.999 * frozen.displacement_bound());
    BOOST_TEST(std::abs(uf[0]) > 2.0 * std::abs(us[0]));
  }
}

BOOST_AUTO_TEST_CASE(steps_that_are_undone_leave_no_trace) {
  const auto points = test::column_points(4);
  Pair pair(points, points, test::mls<BSpline2>(1.5, 1), 1.0, 1e-6);
  const PreparedUpdate update(pair.problem, pair.dt, pair.solid.at_nodes, pair.fluid.at_nodes);
  const FrozenColumn::NodeUpdate by{pair.problem, update, pair.solid.at_nodes, pair.fluid.at_nodes};
  const auto& operators = pair.solid.prepared.operators;
  FrozenColumn frozen(operators, operators, update, pair.constants);
  const std::vector<StepLoad> loads(frozen.most_steps(), StepLoad{1.0, 1.0, 1.0});
  SignalWindow window = SignalWindow::at_rest(nodes, operators->reach(), 0.0);
  // Until what is undone comes to nodes of the next part.
  for (int step = 0; step < 200 && window.nodes + SignalWindow::growth < 256; ++step) {
    frozen.advance(by, std::span(loads).first(1), window, 1);
  }
  const FrozenColumn copy(frozen);
  SignalWindow later = window;
  FrozenColumn(copy).advance(by, loads, later, 1);
  BOOST_TEST(window.nodes <= 256u);
  BOOST_TEST(later.nodes > 256u);
  for (std::size_t steps = 1; steps <= loads.size(); ++steps) {
    FrozenColumn straight(copy);
    FrozenColumn back(copy);
    SignalWindow in_vain = window;
    back.advance(by, std::span(loads).first(steps), in_vain, 1);
    back.undo();
    BOOST_TEST(back.displacement_bound() == copy.displacement_bound());
    for (FrozenColumn* column : {&straight, &back}) {
      SignalWindow at = window;
      column->advance(by, std::span(loads).first(5), at, 1);
      column->advance(by, std::span(loads).first(4), at, 1);
    }
    for (const int phase : {0, 1}) {
      const auto q = std::array{straight.node_values()[phase], back.node_values()[phase]};
      const auto e = std::array{straight.cell_values()[phase], back.cell_values()[phase]};
      BOOST_TEST(q[0] == q[1], boost::test_tools::per_element());
      BOOST_TEST(e[0] == e[1], boost::test_tools::per_element());
    }
    BOOST_TEST(back.displacement_bound() == straight.displacement_bound());
  }
}

BOOST_AUTO_TEST_CASE(as_many_steps_as_stay_in_the_bound) {
  const auto points = test::column_points(4);
  Pair pair(points, points, test::mls<BSpline2>(1.5, 1), 1.0);
  const PreparedUpdate update(pair.problem, pair.dt, pair.solid.at_nodes, pair.fluid.at_nodes);
  const auto& operators = pair.solid.prepared.operators;
  FrozenColumn frozen(operators, operators, update, pair.constants);
  BOOST_TEST(frozen.most_steps() == FrozenColumn::longest_chunk);
  BOOST_TEST(frozen.steps_before(1e-20) == frozen.most_steps());  // nothing has moved yet
  SignalWindow all = SignalWindow::whole_column(nodes);
  const StepLoad load = pair.load(0);
  frozen.advance({pair.problem, update, pair.solid.at_nodes, pair.fluid.at_nodes}, {&load, 1}, all,
                 1);
  const double moved = frozen.displacement_bound();  // in one step
  BOOST_TEST(moved > 0.0);
  BOOST_TEST(frozen.steps_before(0.5 * moved) == 0u);
  BOOST_TEST(frozen.steps_before(2.9 * moved) == 0u);
  BOOST_TEST(frozen.steps_before(3.1 * moved) == 1u);
  BOOST_TEST(frozen.steps_before(11.5 * moved) == 5u);
  BOOST_TEST(frozen.steps_before(1e3 * moved) == frozen.most_steps());
}

BOOST_AUTO_TEST_CASE(parts_that_reach_far_are_stepped_once_at_a_time) {
  const auto points = test::regular_points(1);
  for (const bool far : {false, true}) {
    Pair pair(points, points, test::mls<BSpline1>(far ? 260.0 : 100.0, 0), 1.0);
    const PreparedUpdate update(pair.problem, pair.dt, pair.solid.at_nodes, pair.fluid.at_nodes);
    const auto& operators = pair.solid.prepared.operators;
    const FrozenColumn frozen(operators, operators, update, pair.constants);
    BOOST_TEST(frozen.most_steps() == (far ? 1u : FrozenColumn::longest_chunk));
  }
}

BOOST_AUTO_TEST_CASE(other_operators_are_refused) {
  const auto points = test::column_points(4);
  const auto general = std::make_shared<GeneralOperators>(
      Transfer<1>(points, test::column_grid(), test::shape()), points.x.size());
  BOOST_TEST(!FrozenColumn::possible(*general));
  BOOST_CHECK_THROW(FrozenColumn(general, general, {}, {}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
