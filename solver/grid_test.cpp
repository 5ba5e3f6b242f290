#include "solver/grid.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "solver/test_points.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(grid)

namespace {

// A grid with a different number of cells along each axis: 3, 4, 5.
template <int Dim>
Grid<Dim> small_grid() {
  CellIndex<Dim> cells;
  Vector<Dim> origin;
  for (int a = 0; a < Dim; ++a) {
    cells[a] = 3 + a;
    origin[a] = 0.5 - a;
  }
  return {origin, 0.2, cells};
}

// Points in the unit cube moved into the grid's box.
template <int Dim>
std::vector<Vector<Dim>> points_in(const Grid<Dim>& grid, unsigned seed) {
  auto points = test::random_points<Dim>(200, seed);
  for (Vector<Dim>& x : points) {
    x = grid.origin + grid.spacing * x.cwiseProduct(grid.cells.template cast<double>());
  }
  return points;
}

template <int Dim>
double linear_field(const Vector<Dim>& x) {
  return 1.5 + x.dot(Vector<Dim>::LinSpaced(-1.0, 2.0));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(shape_functions_are_a_partition_of_unity, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto g = small_grid<Dim>();
  for (const Vector<Dim>& x : points_in(g, 11)) {
    const auto shape = g.linear_shape(x);
    double sum = 0.0;
    Vector<Dim> slope = Vector<Dim>::Zero();
    for (std::size_t c = 0; c < shape.nodes.size(); ++c) {
      BOOST_TEST(shape.values[c] >= -1e-15);
      sum += shape.values[c];
      slope += shape.gradients[c];
    }
    BOOST_TEST(std::abs(sum - 1.0) < 1e-15);
    BOOST_TEST(slope.norm() < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(shape_functions_reproduce_linear_fields, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto g = small_grid<Dim>();
  auto points = points_in(g, 12);
  points.push_back(g.origin - Vector<Dim>::Constant(0.07));  // outside: continued
  const Vector<Dim> exact_slope = Vector<Dim>::LinSpaced(-1.0, 2.0);
  for (const Vector<Dim>& x : points) {
    const auto shape = g.linear_shape(x);
    double value = 0.0;
    Vector<Dim> slope = Vector<Dim>::Zero();
    for (std::size_t c = 0; c < shape.nodes.size(); ++c) {
      const double u = linear_field<Dim>(g.node_position(shape.nodes[c]));
      value += shape.values[c] * u;
      slope += shape.gradients[c] * u;
    }
    BOOST_TEST(std::abs(value - linear_field<Dim>(x)) < 1e-13);
    BOOST_TEST((slope - exact_slope).norm() < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(gradients_agree_with_differences, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto g = small_grid<Dim>();
  const double e = 1e-6;
  for (int cell = 0; cell < g.cell_count(); ++cell) {
    const Vector<Dim> x = g.cell_centre(cell) + Vector<Dim>::Constant(0.03);
    const auto shape = g.linear_shape(x);
    for (int a = 0; a < Dim; ++a) {
      const auto up = g.linear_shape(x + e * Vector<Dim>::Unit(a));
      const auto down = g.linear_shape(x - e * Vector<Dim>::Unit(a));
      for (std::size_t c = 0; c < shape.nodes.size(); ++c) {
        const double difference = (up.values[c] - down.values[c]) / (2.0 * e);
        BOOST_TEST(std::abs(shape.gradients[c][a] - difference) < 1e-8);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(shape_functions_are_one_at_their_node, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto g = small_grid<Dim>();
  for (int node = 0; node < g.node_count(); ++node) {
    const auto shape = g.linear_shape(g.node_position(node));
    for (std::size_t c = 0; c < shape.nodes.size(); ++c) {
      const double delta = shape.nodes[c] == node ? 1.0 : 0.0;
      BOOST_TEST(std::abs(shape.values[c] - delta) < 1e-13);
    }
  }
}

// Gauss's two points an axis integrate N_i exactly.
BOOST_AUTO_TEST_CASE_TEMPLATE(nodal_volumes_are_integrals, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto g = small_grid<Dim>();
  std::vector<double> integral(static_cast<std::size_t>(g.node_count()), 0.0);
  const double volume = std::pow(g.spacing, Dim);
  for (int cell = 0; cell < g.cell_count(); ++cell) {
    for (int q = 0; q < (1 << Dim); ++q) {
      Vector<Dim> x = g.cell_centre(cell);
      for (int a = 0; a < Dim; ++a) {
        x[a] += ((q >> a) & 1 ? 0.5 : -0.5) * g.spacing / std::sqrt(3.0);
      }
      const auto shape = g.linear_shape(x);
      for (std::size_t c = 0; c < shape.nodes.size(); ++c) {
        integral[static_cast<std::size_t>(shape.nodes[c])] += shape.values[c] * volume / (1 << Dim);
      }
    }
  }
  double sum = 0.0;
  for (int node = 0; node < g.node_count(); ++node) {
    BOOST_TEST(std::abs(g.nodal_volume(node) - integral[static_cast<std::size_t>(node)]) < 1e-15);
    sum += g.nodal_volume(node);
  }
  BOOST_TEST(std::abs(sum - volume * g.cell_count()) < 1e-14);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(numbers_and_indices_are_inverse, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto g = small_grid<Dim>();
  BOOST_TEST(g.cell_count() == (Dim == 1 ? 3 : Dim == 2 ? 12 : 60));
  BOOST_TEST(g.node_count() == (Dim == 1 ? 4 : Dim == 2 ? 20 : 120));
  for (int node = 0; node < g.node_count(); ++node) {
    BOOST_TEST(g.node_number(g.node_index(node)) == node);
  }
  for (int cell = 0; cell < g.cell_count(); ++cell) {
    BOOST_TEST(g.cell_number(g.cell_index(cell)) == cell);
    BOOST_TEST(g.cell_number(g.cell_of(g.cell_centre(cell))) == cell);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(corners_surround_the_centre, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto g = small_grid<Dim>();
  for (int cell = 0; cell < g.cell_count(); ++cell) {
    for (int corner = 0; corner < (1 << Dim); ++corner) {
      const int node = g.node_of(g.cell_index(cell), corner);
      const Vector<Dim> offset = g.node_position(node) - g.cell_centre(cell);
      for (int a = 0; a < Dim; ++a) {
        const double expected = ((corner >> a) & 1 ? 0.5 : -0.5) * g.spacing;
        BOOST_TEST(std::abs(offset[a] - expected) < 1e-14);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(cell_search_is_clamped_to_the_grid) {
  const Grid<1> g(Vector<1>(0.0), 0.25, CellIndex<1>(4));
  const auto cell = [&](double x) { return g.cell_of(Vector<1>(x))[0]; };
  const double infinity = std::numeric_limits<double>::infinity();
  BOOST_TEST(cell(-1e-9) == 0);
  BOOST_TEST(cell(0.0) == 0);
  BOOST_TEST(cell(0.25) == 1);  // a face belongs to the upper cell
  BOOST_TEST(cell(1.0) == 3);   // the last one to the last cell
  BOOST_TEST(cell(1e300) == 3);
  BOOST_TEST(cell(-infinity) == 0);
  BOOST_TEST(cell(infinity) == 3);
  BOOST_TEST(cell(std::numeric_limits<double>::quiet_NaN()) == 0);
  BOOST_TEST(g.contains(Vector<1>(1.0)));
  BOOST_TEST(!g.contains(Vector<1>(1.0000001)));
  BOOST_TEST(!g.contains(Vector<1>(-1e-9)));
}

BOOST_AUTO_TEST_CASE(refuses_a_grid_that_is_none) {
  const Vector<2> zero = Vector<2>::Zero();
  BOOST_CHECK_THROW(Grid<2>(zero, 0.0, {2, 2}), std::invalid_argument);
  BOOST_CHECK_THROW(Grid<2>(zero, -1.0, {2, 2}), std::invalid_argument);
  BOOST_CHECK_THROW(Grid<2>(zero, std::nan(""), {2, 2}), std::invalid_argument);
  BOOST_CHECK_THROW(Grid<2>(zero, 1.0, {2, 0}), std::invalid_argument);
  BOOST_CHECK_THROW(Grid<2>(zero, 1.0, {100000, 100000}), std::invalid_argument);
  BOOST_CHECK_THROW(Grid<2>({std::nan(""), 0.0}, 1.0, {2, 2}), std::invalid_argument);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
