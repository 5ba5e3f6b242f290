#include "solver/frozen_phase.hpp"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "solver/column_fixtures.hpp"
#include "solver/general_operators.hpp"

using namespace porowave::solver;
using test::largest_difference;
using test::noise;

namespace {

constexpr std::size_t cells = test::column_cells;
constexpr std::size_t nodes = cells + 1;

// The same random updates for a frozen phase and for the points themselves, and after each of them
// the same nodal values from both.
void compare(const PointSet<1>& points, const Grid<1>& grid, const Discretization& choice,
             double flip, double first_values) {
  const auto operators = prepare_phase(points, grid, choice).operators;
  PointValues values{noise(points.x.size(), 1, -first_values, first_values),
                     noise(points.x.size(), 2, -first_values, first_values),
                     {}};
  auto& [velocity, stress, none] = values;
  auto settled_velocity = velocity;
  auto settled_stress = stress;
  FrozenPhase frozen(operators, velocity, stress);
  BOOST_TEST(frozen.started_at_rest() == (first_values == 0.0));
  for (unsigned step = 0; step < 5; ++step) {
    const auto before = noise(nodes, 10 + step);
    const auto after = noise(nodes, 20 + step);
    const PointUpdate update{flip, before.data(), after.data(), after.data(), 0.01};
    operators->scatter(update, {0, cells}, values);
    for (std::size_t first = 0; first < cells; first += 256) {
      frozen.scatter(
          {flip, before.data() + first, after.data() + first, after.data() + first, 0.01},
          {first, std::min(first + 256, cells)});
    }
    frozen.end_step(flip);
    std::vector<double> v(nodes), f(nodes), frozen_v(nodes), frozen_f(nodes);
    operators->gather(values, {0, nodes}, v.data(), f.data());
    frozen.gather({0, nodes}, frozen_v.data(), frozen_f.data());
    BOOST_TEST(largest_difference(v, frozen_v) < 1e-11);
    BOOST_TEST(largest_difference(f, frozen_f) < 1e-11);
    // Any part gives the bits of the whole.
    std::vector<double> part_v(100), part_f(100);
    frozen.gather({256, 356}, part_v.data(), part_f.data());
    for (std::size_t k = 0; k < 100; ++k) {
      BOOST_TEST_REQUIRE(part_v[k] == frozen_v[256 + k]);
      BOOST_TEST_REQUIRE(part_f[k] == frozen_f[256 + k]);
    }
  }
  frozen.settle(settled_velocity, settled_stress);
  BOOST_TEST(largest_difference(velocity, settled_velocity) < 1e-13);
  BOOST_TEST(largest_difference(stress, settled_stress) < 1e-13);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(frozen_phase)

BOOST_AUTO_TEST_CASE(nodes_see_the_same_as_with_points) {
  test::for_all_columns([](const auto& points, const auto& grid, const auto& choice) {
    for (const double flip : {1.0, 0.9, 0.0}) compare(points, grid, choice, flip, 0.0);
  });
}

BOOST_AUTO_TEST_CASE(points_may_start_with_any_values) {
  test::for_all_columns([](const auto& points, const auto& grid, const auto& choice) {
    for (const double flip : {1.0, 0.9, 0.0}) compare(points, grid, choice, flip, 1.0);
  });
}

BOOST_AUTO_TEST_CASE(other_operators_are_refused) {
  const auto points = test::column_points(4);
  const auto general = std::make_shared<GeneralOperators>(
      Transfer<1>(points, test::column_grid(), test::shape()), points.x.size());
  BOOST_TEST(!FrozenPhase::possible(*general));
  const std::vector<double> zero(points.x.size());
  BOOST_CHECK_THROW(FrozenPhase(general, zero, zero), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
