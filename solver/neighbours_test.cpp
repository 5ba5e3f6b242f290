#include "solver/neighbours.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "solver/test_points.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(neighbours)

namespace {

template <int Dim>
Grid<Dim> unit_grid() {
  return {Vector<Dim>::Zero(), 0.125, CellIndex<Dim>::Constant(8)};
}

// Points in and a little outside of the unit cube, points exactly on cell faces, and doubles.
template <int Dim>
std::vector<Vector<Dim>> awkward_points() {
  auto points = test::random_points<Dim>(400, 5, -0.1, 1.1);
  for (std::size_t p = 0; p < 100; ++p) {
    for (int a = 0; a < Dim; ++a) points[p][a] = std::round(8.0 * points[p][a]) / 8.0;
  }
  for (std::size_t p = 0; p < 10; ++p) points.push_back(points[p]);
  return points;
}

template <int Dim>
std::vector<std::int32_t> brute_force(const std::vector<Vector<Dim>>& points, const Vector<Dim>& x,
                                      double radius) {
  std::vector<std::int32_t> found;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if ((points[p] - x).template lpNorm<Eigen::Infinity>() <= radius) {
      found.push_back(static_cast<std::int32_t>(p));
    }
  }
  return found;
}

template <int Dim>
void check_against_brute_force(const Grid<Dim>& grid, const std::vector<Vector<Dim>>& points) {
  const CellList<Dim> cells(points, grid);
  BOOST_TEST(cells.size() == points.size());
  std::vector<std::int32_t> found;
  std::size_t total = 0;
  // 0.125 and 0.25 are on faces exactly when x is: the box is closed
  for (const double radius : {0.0, 0.03, 0.125, 0.25, 0.4, 5.0}) {
    for (const Vector<Dim>& x : points) {
      cells.query(x, radius, found);
      std::sort(found.begin(), found.end());
      BOOST_TEST(found == brute_force<Dim>(points, x, radius), boost::test_tools::per_element());
      total += found.size();
    }
  }
  BOOST_TEST(total > 6 * points.size());
}

BOOST_AUTO_TEST_CASE_TEMPLATE(finds_what_brute_force_finds, D, test::Dimensions) {
  const auto points = awkward_points<D::value>();
  check_against_brute_force<D::value>(unit_grid<D::value>(), points);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(finds_the_same_on_the_grid_around_the_points, D, test::Dimensions) {
  const auto points = awkward_points<D::value>();
  check_against_brute_force<D::value>(grid_around<D::value>(points, 0.17), points);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(answers_by_cell_then_by_point, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto points = awkward_points<Dim>();
  const auto grid = unit_grid<Dim>();
  const CellList<Dim> cells(points, grid);
  std::vector<std::int32_t> found;
  cells.query(Vector<Dim>::Constant(0.5), 1.0, found);
  BOOST_REQUIRE(found.size() == points.size());
  for (std::size_t k = 1; k < found.size(); ++k) {
    const auto p = static_cast<std::size_t>(found[k - 1]);
    const auto q = static_cast<std::size_t>(found[k]);
    const int cell_p = grid.cell_number(grid.cell_of(points[p]));
    const int cell_q = grid.cell_number(grid.cell_of(points[q]));
    BOOST_TEST((cell_p < cell_q || (cell_p == cell_q && p < q)));
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(hands_over_the_position_of_the_point, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto points = awkward_points<Dim>();
  const CellList<Dim> cells(points, unit_grid<Dim>());
  cells.for_each_in_box(points[3], 0.3, [&](std::int32_t p, const Vector<Dim>& x) {
    BOOST_TEST((x == points[static_cast<std::size_t>(p)]));
  });
}

BOOST_AUTO_TEST_CASE(no_points_have_no_neighbours) {
  const std::vector<Vector<2>> none;
  const CellList<2> cells(none, grid_around<2>(none, 0.1));
  std::vector<std::int32_t> found{1, 2, 3};
  cells.query(Vector<2>::Zero(), 10.0, found);
  BOOST_TEST(found.empty());
}

BOOST_AUTO_TEST_CASE(grid_around_points_holds_them_in_few_cells) {
  const auto points = test::random_points<3>(50, 9, -2.0, 3.0);
  const auto fine = grid_around<3>(points, 1e-6);
  BOOST_TEST(fine.cell_count() <= 101);
  for (const auto& x : points) BOOST_TEST(fine.contains(x));
  const std::vector<Vector<1>> coincident(5, Vector<1>(0.3));
  BOOST_TEST(grid_around<1>(coincident, 0.1).cell_count() == 1);
}

BOOST_AUTO_TEST_CASE(refuses_positions_that_are_not_finite) {
  const std::vector<Vector<1>> bad{Vector<1>(0.1), Vector<1>(std::nan(""))};
  const std::vector<Vector<1>> far{Vector<1>(std::numeric_limits<double>::infinity())};
  BOOST_CHECK_THROW(CellList<1>(bad, unit_grid<1>()), std::invalid_argument);
  BOOST_CHECK_THROW(grid_around<1>(bad, 0.1), std::invalid_argument);
  BOOST_CHECK_THROW(grid_around<1>(far, 0.1), std::invalid_argument);
  BOOST_CHECK_THROW(grid_around<1>({}, 0.0), std::invalid_argument);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
