#include "solver/moving/cell_order.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "solver/test_points.hpp"

BOOST_AUTO_TEST_SUITE(cell_order)

using namespace porowave::solver;

namespace {

constexpr double spacing = 0.1;

long cell_of(const Vector<1>& x) {
  return std::lround(std::floor(x[0] / spacing));
}

std::vector<Vector<1>> sorted_points(std::size_t count, double low, double high) {
  auto x = test::random_points<1>(count, 5, low, high);
  reorder(order_along(x), x);
  return x;
}

/// Every point is in the range of its own cell, and in no other.
void check_cells(const CellOrder& order, const std::vector<Vector<1>>& x, long first, long last) {
  std::size_t next = 0;
  for (long c = first; c < last; ++c) {
    const IndexRange points = order.points_of(c);
    BOOST_TEST_REQUIRE(points.first == next);
    for (std::size_t p = points.first; p < points.last; ++p) BOOST_TEST(cell_of(x[p]) == c);
    next = points.last;
  }
  BOOST_TEST(next == x.size());
}

}  // namespace

BOOST_AUTO_TEST_CASE(sorting_is_stable_and_leaves_sorted_points_alone) {
  std::vector<Vector<1>> x;
  for (const double place : {0.3, 0.1, 0.2, 0.1}) x.emplace_back(place);
  std::vector<int> label{0, 1, 2, 3};
  const auto order = order_along(x);
  reorder(order, x);
  reorder(order, label);
  BOOST_TEST((label == std::vector<int>{1, 3, 2, 0}));
  BOOST_TEST(x[0][0] == 0.1);
  BOOST_TEST(x[3][0] == 0.3);
  BOOST_TEST(order_along(x).empty());
  reorder(order_along(x), label);
  BOOST_TEST((label == std::vector<int>{1, 3, 2, 0}));
}

BOOST_AUTO_TEST_CASE(cells_hold_their_points_wherever_these_and_the_cells_go) {
  auto x = sorted_points(200, -0.95, 1.95);
  CellOrder order;
  order.renew(x, spacing, -10, 30);
  check_cells(order, x, -10, 20);
  for (const double shift : {0.004, -0.03, 0.25, 1.7, -4.1}) {
    std::size_t expected = 0;
    for (Vector<1>& point : x) {
      const long before = cell_of(point);
      point[0] = 1.01 * point[0] + shift;  // they spread as well
      expected += static_cast<std::size_t>(std::abs(cell_of(point) - before));
    }
    const long first = cell_of(x.front());
    const auto cells = static_cast<std::size_t>(cell_of(x.back()) - first) + 1;
    // Another set of cells as well; what is counted are passages of bounds that were known before.
    const std::size_t passed = order.renew(x, spacing, first, cells);
    check_cells(order, x, first, first + static_cast<long>(cells));
    if (std::abs(shift) < 0.01) BOOST_TEST(passed == expected);
    BOOST_TEST(order.renew(x, spacing, first, cells) == 0u);
  }
}

BOOST_AUTO_TEST_CASE(a_point_on_a_node_is_in_the_cell_above) {
  std::vector<Vector<1>> x;
  for (const double place : {0.1, 0.2}) x.emplace_back(place);
  CellOrder order;
  order.renew(x, spacing, 0, 4);
  BOOST_TEST(order.points_of(0).last == 0u);
  BOOST_TEST(order.points_of(1).last == 1u);
  BOOST_TEST(order.points_of(2).last == 2u);
  BOOST_TEST(order.points_of(3).last == 2u);
}

BOOST_AUTO_TEST_SUITE_END()
