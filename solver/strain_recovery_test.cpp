#include "solver/strain_recovery.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "solver/test_points.hpp"
#include "solver/transfer_fixtures.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(strain_recovery)

namespace {

const int cells = 8;
const Grid<1> grid(Vector<1>(-0.3), 0.25, CellIndex<1>(cells));
const std::vector<bool> all(cells, true);

std::vector<double> nodal(double (*u)(double)) {
  std::vector<double> values;
  for (int i = 0; i <= cells; ++i) values.push_back(u(grid.node_position(i)[0]));
  return values;
}

std::vector<double> strains(const std::vector<Vector<1>>& points,
                            const std::vector<bool>& is_material, StrainSharing sharing,
                            const std::vector<double>& u) {
  std::vector<double> values(points.size());
  multiply(shared_strain_rows(points, grid, is_material, sharing), u, values);
  return values;
}

double cell_strain(const std::vector<double>& u, int cell) {
  const auto c = static_cast<std::size_t>(cell);
  return (u[c + 1] - u[c]) / grid.spacing;
}

double square(double x) {
  return 0.2 + 1.5 * x - 2.0 * x * x;
}

BOOST_AUTO_TEST_CASE(linear_strains_are_exact_up_to_the_ends) {
  const auto points = test::random_points<1>(200, 3, -0.3, 1.7);
  const auto e = strains(points, all, StrainSharing::recovered, nodal(square));
  for (std::size_t p = 0; p < points.size(); ++p) {
    BOOST_TEST(std::abs(e[p] - (1.5 - 4.0 * points[p][0])) < 1e-12);
  }
}

// In the middle of a cell it is the strain of the cell, between middles it does not jump.
BOOST_AUTO_TEST_CASE(it_interpolates_between_middles) {
  const auto u = test::noise(cells + 1, 5);
  for (int c = 0; c < cells; ++c) {
    const Vector<1> middle = grid.cell_centre(c);
    const auto e = strains({middle}, all, StrainSharing::recovered, u);
    BOOST_TEST(std::abs(e[0] - cell_strain(u, c)) < 1e-12);
    if (c == 0) continue;
    const Vector<1> face = grid.node_position(c);
    const Vector<1> below(face[0] - 1e-9);
    const auto near = strains({face, below}, all, StrainSharing::recovered, u);
    const double mean = 0.5 * (cell_strain(u, c - 1) + cell_strain(u, c));
    BOOST_TEST(std::abs(near[0] - mean) < 1e-12);
    BOOST_TEST(std::abs(near[1] - mean) < 1e-6);
  }
}

// Across a crack nothing is interpolated: on both sides the line of the own side goes on.
BOOST_AUTO_TEST_CASE(a_crack_is_not_looked_across) {
  std::vector<bool> is_material = all;
  is_material[3] = false;
  auto u = nodal(square);
  for (std::size_t i = 4; i < u.size(); ++i) u[i] += 100.0;  // the crack opens
  const std::vector<Vector<1>> points{Vector<1>(0.42), Vector<1>(0.33), Vector<1>(0.75)};
  const auto e = strains(points, is_material, StrainSharing::recovered, u);
  for (std::size_t p = 0; p < points.size(); ++p) {
    BOOST_TEST(std::abs(e[p] - (1.5 - 4.0 * points[p][0])) < 1e-10);
  }
  // Alone between two cracks: the strain of the cell.
  is_material[5] = false;
  const auto alone = strains({Vector<1>(0.75)}, is_material, StrainSharing::recovered, u);
  BOOST_TEST(std::abs(alone[0] - cell_strain(u, 4)) < 1e-12);
}

// Points in cells 0 to 7 without 3: only those in the halves next to it feel it.
BOOST_AUTO_TEST_CASE(an_empty_cell_lends_its_strain_to_the_points_next_to_it) {
  std::vector<Vector<1>> points;
  for (int c = 0; c < cells; ++c) {
    for (const double t : {0.1, 0.3, 0.8}) {
      if (c != 3) points.emplace_back(grid.origin[0] + (c + t) * grid.spacing);
    }
  }
  const auto u = test::noise(cells + 1, 5);
  const auto e = strains(points, all, StrainSharing::lend_empty, u);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const int c = grid.cell_of(points[p])[0];
    const double t = (points[p][0] - grid.origin[0]) / grid.spacing - c;
    const bool is_next = (c == 2 && t > 0.5) || (c == 4 && t < 0.5);
    const double share = is_next ? std::abs(t - 0.5) : 0.0;
    const double expected = (1.0 - share) * cell_strain(u, c) + share * cell_strain(u, 3);
    BOOST_TEST(std::abs(e[p] - expected) < 1e-12);
  }
  // A hole that is not bridged lends nothing.
  std::vector<bool> is_material = all;
  is_material[3] = false;
  const auto cracked = strains(points, is_material, StrainSharing::lend_empty, u);
  for (std::size_t p = 0; p < points.size(); ++p) {
    BOOST_TEST(std::abs(cracked[p] - cell_strain(u, grid.cell_of(points[p])[0])) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(the_transfer_uses_it_where_it_is_chosen) {
  PointSet<1> points;
  points.x = test::random_points<1>(64, 3, -0.3, 1.7);
  points.volume.assign(64, 1.0);
  points.mass.assign(64, 1.0);
  Discretization choice = test::mls<BSpline2>(1.5, 1);
  choice.strain = Strain::recovered;
  std::vector<double> e(64);
  Transfer<1>(points, grid, choice).gradient_at_points(nodal(square), 0, e);
  for (std::size_t p = 0; p < 64; ++p) {
    BOOST_TEST(std::abs(e[p] - (1.5 - 4.0 * points.x[p][0])) < 1e-12);
  }
  choice.strain = Strain::cell;
  Transfer<1>(points, grid, choice).gradient_at_points(nodal(square), 0, e);
  BOOST_TEST(std::abs(e[0] - cell_strain(nodal(square), grid.cell_of(points.x[0])[0])) < 1e-12);
}

BOOST_AUTO_TEST_CASE(what_does_not_fit_is_refused) {
  const std::vector<Vector<1>> bad{Vector<1>(std::numeric_limits<double>::quiet_NaN())};
  BOOST_CHECK_THROW(shared_strain_rows(bad, grid, all, StrainSharing::recovered),
                    std::invalid_argument);
  BOOST_CHECK_THROW(shared_strain_rows({}, grid, {true}, StrainSharing::recovered),
                    std::invalid_argument);
  Discretization choice = test::mls<BSpline2>(1.5, 1);
  choice.strain = Strain::recovered;
  BOOST_CHECK_THROW(Transfer<2>(test::regular<2>(), test::test_grid<2>(), choice),
                    std::invalid_argument);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
