#include "solver/regular_nodes.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <memory>

#include "reference/problem/problem_fixtures.hpp"
#include "solver/column_fixtures.hpp"
#include "solver/compact_operators.hpp"

BOOST_AUTO_TEST_SUITE(regular_nodes)

using namespace porowave;
using namespace porowave::solver;

namespace {

constexpr std::size_t cells = test::column_cells;
constexpr std::size_t nodes = cells + 1;
constexpr double dt = 1e-7;

// W and B as frozen_column.hpp defines them.
struct Rows {
  PreparedPhase phase;
  std::shared_ptr<const CompactOperators> points;
  std::vector<int> cell_of_point;
  BandedRows to_nodes;
  BandedRows to_cells;
  PhaseNodes solid, fluid;
  Problem problem = fixtures::paper_problem();

  Rows(const PointSet<1>& at, const Discretization& choice)
      : phase(prepare_phase(at, test::column_grid(), choice)),
        points(std::dynamic_pointer_cast<const CompactOperators>(phase.operators)) {
    BOOST_TEST_REQUIRE((points != nullptr));
    for (const Vector<1>& x : at.x) {
      cell_of_point.push_back(test::column_grid().cell_of(x)[0]);
    }
    to_nodes = BandedRows(points->node_rows(), [&](std::size_t p) {
      const double t = points->place_in_cell(p);
      return PointRow{cell_of_point[p], {1.0 - t, t}};
    });
    to_cells = BandedRows(points->cell_rows(), [&](std::size_t p) {
      return points->shared_strains().row(static_cast<std::size_t>(cell_of_point[p]),
                                          points->place_in_cell(p));
    });
    for (PhaseNodes* n : {&solid, &fluid}) {
      n->resize(nodes);
      n->mass = phase.nodal_mass;
      n->volume = phase.nodal_volume;
    }
    for (double& mass : fluid.mass) mass *= 0.4;
  }
  RegularNodes regular() const {
    return {to_nodes,
            to_cells,
            PreparedUpdate(problem, dt, solid, fluid),
            problem.material.solid_fraction(),
            problem.material.porosity,
            nodes};
  }
};

void check_runs(const RegularNodes& found, const std::vector<IndexRange>& expected) {
  for (std::size_t block = 0; block < expected.size(); ++block) {
    BOOST_TEST_CONTEXT("block " << block) {
      BOOST_TEST(found.in_block(block).first == expected[block].first);
      BOOST_TEST(found.in_block(block).last == expected[block].last);
    }
  }
}

const std::vector<IndexRange> none{{0, 0}, {0, 0}, {0, 0}};
// Eight 74 holds node and cell 599, the last ones before the end.
const std::vector<IndexRange> interior{{1, 32}, {32, 64}, {64, 74}};
const std::vector<IndexRange> up_to_the_end{{1, 32}, {32, 64}, {64, 75}};

}  // namespace

BOOST_AUTO_TEST_CASE(regular_points_make_all_nodes_regular_but_those_at_the_ends) {
  for (const int per_cell : {1, 2, 3, 4, 8}) {
    for (const Discretization& choice : test::column_choices()) {
      BOOST_TEST_CONTEXT(test::title(choice)
                         << test::strain_title(choice) << ", " << per_cell << " points a cell") {
        const RegularNodes found = Rows(test::regular_points(per_cell), choice).regular();
        const bool cells_see_themselves_only = found.stencil().force.size() == 1;
        const bool more = cells_see_themselves_only && choice.basis_order < 2;
        check_runs(found, more ? up_to_the_end : interior);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_gap_leaves_the_longest_run_beside_it) {
  // Element 300 is empty: nodes 299 to 302 and cells 299 to 301 have points within 1.5 h missing.
  const Discretization choice = test::mls<BSpline2>(1.5, 1);
  check_runs(Rows(test::regular_points(4, {3.005}), choice).regular(),
             {{1, 32}, {38, 64}, {64, 74}});
}

BOOST_AUTO_TEST_CASE(points_at_random_make_no_node_regular) {
  for (const int per_cell : {1, 4, 7}) {
    for (const Discretization& choice : test::column_choices()) {
      check_runs(Rows(test::column_points(per_cell), choice).regular(), none);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_moved_point_is_seen) {
  const auto run_with_moved = [](std::size_t point) {
    PointSet<1> points = test::regular_points(4);
    points.x[point][0] += 0.01 * 1e-10;
    return Rows(points, test::mls<BSpline2>(1.5, 1)).regular().in_block(1);
  };
  // At 400.375 h: nodes 399 to 401 and cells 399 to 401 see it, which are in eights 49 and 50.
  BOOST_TEST(run_with_moved(4 * 400 + 1).first == 32);
  BOOST_TEST(run_with_moved(4 * 400 + 1).last == 49);
  // At 270.125 h: nodes and cells 269 to 271 see it. Cell 271 is beside node 272, of eight 34.
  BOOST_TEST(run_with_moved(4 * 270).first == 35);
  BOOST_TEST(run_with_moved(4 * 270).last == 64);
}

BOOST_AUTO_TEST_CASE(another_mass_is_seen) {
  Rows column(test::regular_points(4), test::mls<BSpline2>(1.5, 1));
  column.fluid.mass[450] *= 1.0 + 1e-10;  // in eight 56
  const IndexRange run = column.regular().in_block(1);
  BOOST_TEST(run.first == 32);
  BOOST_TEST(run.last == 56);
}

BOOST_AUTO_TEST_CASE(the_stencil_keeps_constants_and_slopes) {
  for (const Discretization& choice : test::column_choices()) {
    BOOST_TEST_CONTEXT(test::title(choice) << test::strain_title(choice)) {
      const RegularNodes found = Rows(test::regular_points(4), choice).regular();
      const RegularStencil& stencil = found.stencil();
      double sum = -stencil.velocity[0];
      for (const double weight : stencil.velocity) sum += 2.0 * weight;
      BOOST_TEST(std::abs(sum - 1.0) < 1e-13);
      double slope = 0.0;  // of a stress that rises by one from cell to cell
      for (std::size_t k = 0; k < stencil.force.size(); ++k) {
        slope += static_cast<double>(2 * k + 1) * stencil.force[k];
      }
      BOOST_TEST(std::abs(slope - 1.0) < 1e-13);
    }
  }
}

// As update_node moves it, for a node in the middle.
BOOST_AUTO_TEST_CASE(the_stencil_moves_a_node_as_update_node_does) {
  Rows column(test::regular_points(4), test::mls<BSpline2>(1.5, 1));
  for (const double permeability : {1e-8, 1e-11, 1e-16}) {
    column.problem.material.intrinsic_permeability = permeability;
    const RegularNodes found = column.regular();
    const RegularStencil& stencil = found.stencil();
    const double ns = column.problem.material.solid_fraction();
    const double nf = column.problem.material.porosity;
    const double effective = 5.0e4;
    const double pressure = -3.0e4;
    const std::size_t i = 300;
    column.solid.velocity[i] = 0.3;
    column.fluid.velocity[i] = -0.2;
    column.solid.force[i] = effective - ns * pressure;
    column.fluid.force[i] = -nf * pressure;
    update_node(column.problem, {1.0, 1.0, 1.0}, dt, i, column.solid, column.fluid);
    const auto change = [&](const RegularStencil::Change& by) {
      return by.relative * -0.5 + by.effective * effective + by.pressure * pressure;
    };
    const double vs = 0.3 + change(stencil.solid);
    const double lag = -0.5 + change(stencil.lag);
    BOOST_TEST(std::abs(vs - column.solid.new_velocity[i]) < 1e-14);
    BOOST_TEST(std::abs(vs + lag - column.fluid.new_velocity[i]) < 1e-14);
  }
}

BOOST_AUTO_TEST_SUITE_END()
