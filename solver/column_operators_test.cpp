#include "solver/column_operators.hpp"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "solver/column_fixtures.hpp"
#include "solver/general_operators.hpp"

BOOST_AUTO_TEST_SUITE(column_operators)

using namespace porowave::solver;
using test::largest_difference;
using test::noise;

namespace {

constexpr std::size_t cells = test::column_cells;
constexpr std::size_t nodes = cells + 1;

PointValues some_points(const PointSet<1>& points) {
  return {noise(points.x.size(), 1), noise(points.x.size(), 2), {}};
}

struct Nodes {
  std::vector<double> velocity = std::vector<double>(nodes);
  std::vector<double> force = std::vector<double>(nodes);
};

Nodes gather(const ColumnOperators& operators, const PointValues& points, std::size_t part) {
  Nodes result;
  for (std::size_t first = 0; first < nodes; first += part) {
    operators.gather(points, {first, std::min(first + part, nodes)}, result.velocity.data() + first,
                     result.force.data() + first);
  }
  return result;
}

void scatter(const ColumnOperators& operators, std::size_t part, PointValues& points) {
  const auto before = noise(nodes, 3);
  const auto after = noise(nodes, 4);
  const auto b = noise(nodes, 5);
  for (std::size_t first = 0; first < cells; first += part) {
    operators.scatter({0.75, before.data() + first, after.data() + first, b.data() + first, 0.01},
                      {first, std::min(first + part, cells)}, points);
  }
}

// How far from a node the points that it moves are felt.
std::size_t felt_from(std::size_t node, const ColumnOperators& operators, std::size_t points) {
  std::vector<double> nodal(nodes);
  nodal[node] = 1.0;
  PointValues moved{std::vector<double>(points), std::vector<double>(points), {}};
  const std::vector<double> zero(nodes);
  operators.scatter({1.0, zero.data(), nodal.data(), nodal.data(), 1.0}, {0, cells}, moved);
  const Nodes felt = gather(operators, moved, nodes);
  std::size_t farthest = 0;
  for (std::size_t i = 0; i < nodes; ++i) {
    if (felt.velocity[i] == 0.0 && felt.force[i] == 0.0) continue;
    farthest = std::max(farthest, i > node ? i - node : node - i);
  }
  return farthest;
}

}  // namespace

BOOST_AUTO_TEST_CASE(nothing_is_felt_beyond_the_reach) {
  test::for_all_columns([](const auto& points, const auto& grid, const auto& choice) {
    const auto operators = prepare_phase(points, grid, choice).operators;
    // At both ends, in the middle, and around the empty element 300.
    for (const std::size_t node : {0, 150, 298, 299, 300, 301, 302, 303, 450, 600}) {
      BOOST_TEST(felt_from(node, *operators, points.x.size()) <= operators->reach());
    }
  });
}

BOOST_AUTO_TEST_CASE(the_compact_form_is_the_transfer_to_rounding) {
  test::for_all_columns([](const auto& points, const auto& grid, const auto& choice) {
    const Transfer<1> transfer(points, grid, choice);
    const PreparedPhase phase = prepare_phase(points, grid, choice);
    BOOST_TEST(phase.operators->works_on_parts());
    BOOST_TEST(phase.nodal_mass == transfer.nodal_mass());
    BOOST_TEST(phase.nodal_volume == transfer.nodal_volume());
    BOOST_TEST(phase.reduced_rows == transfer.reduced_rows());
    BOOST_TEST(phase.empty_rows == transfer.empty_rows());

    const PointValues values = some_points(points);
    const Nodes found = gather(*phase.operators, values, nodes);
    // Weights of lowered or barely accepted order can be large.
    BOOST_TEST(largest_difference(found.velocity, test::at_nodes(transfer, values.velocity)) <
               1e-12);
    BOOST_TEST(largest_difference(found.force, test::force(transfer, values.stress, 0)) < 1e-12);
    BOOST_TEST(largest_difference(phase.operators->at_cell_centres(values.stress),
                                  transfer.at_cell_centres(values.stress)) < 1e-12);

    const auto nodal = noise(nodes, 6);
    std::vector<double> at_points(points.x.size());
    std::vector<double> expected(points.x.size());
    phase.operators->to_points(nodal.data(), at_points.data());
    transfer.to_points(nodal, expected);
    BOOST_TEST(largest_difference(at_points, expected) < 1e-14);
    phase.operators->gradient_at_points(nodal.data(), at_points.data());
    transfer.gradient_at_points(nodal, 0, expected);
    BOOST_TEST(largest_difference(at_points, expected) < 1e-14 / grid.spacing);
  });
}

BOOST_AUTO_TEST_CASE(both_forms_agree) {
  test::for_all_columns([](const auto& points, const auto& grid, const auto& choice) {
    const PreparedPhase phase = prepare_phase(points, grid, choice);
    const GeneralOperators general(Transfer<1>(points, grid, choice), points.x.size());
    BOOST_TEST(!general.works_on_parts());
    const PointValues values = some_points(points);
    const Nodes a = gather(*phase.operators, values, nodes);
    const Nodes b = gather(general, values, nodes);
    BOOST_TEST(largest_difference(a.velocity, b.velocity) < 1e-12);
    BOOST_TEST(largest_difference(a.force, b.force) < 1e-12);
    PointValues one = values;
    PointValues other = values;
    scatter(*phase.operators, cells, one);
    scatter(general, cells, other);
    BOOST_TEST(largest_difference(one.velocity, other.velocity) < 1e-14);
    BOOST_TEST(largest_difference(one.stress, other.stress) < 1e-13);
  });
}

BOOST_AUTO_TEST_CASE(parts_give_the_same_bits_as_the_whole) {
  test::for_all_columns([](const auto& points, const auto& grid, const auto& choice) {
    const PreparedPhase phase = prepare_phase(points, grid, choice);
    const PointValues values = some_points(points);
    const Nodes whole = gather(*phase.operators, values, nodes);
    const Nodes parts = gather(*phase.operators, values, 64);
    BOOST_TEST(whole.velocity == parts.velocity);
    BOOST_TEST(whole.force == parts.force);
    PointValues one = values;
    PointValues other = values;
    scatter(*phase.operators, cells, one);
    scatter(*phase.operators, 64, other);
    BOOST_TEST(one.velocity == other.velocity);
    BOOST_TEST(one.stress == other.stress);
  });
}

BOOST_AUTO_TEST_CASE(what_the_compact_form_leaves_out_is_not_mistaken_for_zero) {
  const auto points = test::column_points(4);
  const Transfer<1> transfer(points, test::column_grid(), test::mls<BSpline2>(1.5, 1),
                             TransferUse::compact_form);
  std::vector<double> values(points.x.size());
  BOOST_CHECK_THROW(transfer.to_points(noise(nodes, 1), values), std::invalid_argument);
  BOOST_CHECK_THROW(transfer.gradient_at_points(noise(nodes, 1), 0, values), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(points_out_of_order_are_refused) {
  auto points = test::column_points(4);
  std::swap(points.x[3], points.x[40]);
  BOOST_CHECK_THROW(prepare_phase(points, test::column_grid(), test::shape()),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
