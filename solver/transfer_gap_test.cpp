#include "solver/transfer.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "solver/placement.hpp"
#include "solver/test_points.hpp"
#include "solver/transfer_fixtures.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(transfer_gap)

namespace {

using namespace test;

// Points in the first layer of cells only, in a grid that is six cells long.
template <int Dim>
struct FirstLayer {
  Grid<Dim> grid;
  PointSet<Dim> points;

  FirstLayer() : grid(Vector<Dim>::Zero(), 0.2, cells(6)) {
    points = points_in(Grid<Dim>(grid.origin, grid.spacing, cells(1)), 0.0);
  }
  static CellIndex<Dim> cells(int along) {
    CellIndex<Dim> count = CellIndex<Dim>::Constant(2);
    count[0] = along;
    return count;
  }
  // To the nearest point, in h.
  double distance(const Vector<Dim>& x, bool radial) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vector<Dim>& xp : points.x) {
      const Vector<Dim> offset = xp - x;
      nearest = std::min(nearest, radial ? offset.norm() : offset.cwiseAbs().maxCoeff());
    }
    return nearest / grid.spacing;
  }
  bool reaches_node(int node, const Discretization& choice) const {
    const bool is_shape = choice.transfer == TransferName::shape;
    return distance(grid.node_position(node), is_radial(choice) && !is_shape) <
           (is_shape ? 1.0 : choice.support_radius);
  }
  bool reaches_centre(int cell, const Discretization& choice) const {
    if (choice.transfer == TransferName::shape) return grid.cell_index(cell)[0] == 0;
    return distance(grid.cell_centre(cell), is_radial(choice)) < choice.support_radius;
  }
  static bool is_radial(const Discretization& choice) {
    return to_string(choice.kernel).starts_with("wendland");
  }
};

// Gives the number of nodes out of reach.
template <int Dim>
std::size_t check_reach_of_nodes(const FirstLayer<Dim>& layer, const Transfer<Dim>& transfer,
                                 const Discretization& choice) {
  const auto velocity = at_nodes(transfer, std::vector<double>(layer.points.x.size(), 4.0));
  std::size_t empty = 0;
  for (int i = 0; i < layer.grid.node_count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool reached = layer.reaches_node(i, choice);
    BOOST_TEST((transfer.nodal_mass()[k] > 0.0) == reached);
    BOOST_TEST((transfer.nodal_volume()[k] > 0.0) == reached);
    BOOST_TEST(std::abs(velocity[k] - (reached ? 4.0 : 0.0)) < 1e-9);
    if (reached) continue;
    ++empty;
    BOOST_TEST(transfer.nodal_mass()[k] == 0.0);
    BOOST_TEST(velocity[k] == 0.0);
  }
  return empty;
}

// Gives the number of cell middles out of reach.
template <int Dim>
std::size_t check_reach_of_centres(const FirstLayer<Dim>& layer, const Transfer<Dim>& transfer,
                                   const Discretization& choice) {
  const auto field = transfer.at_cell_centres(std::vector<double>(layer.points.x.size(), 4.0));
  std::size_t empty = 0;
  for (int c = 0; c < layer.grid.cell_count(); ++c) {
    const bool reached = layer.reaches_centre(c, choice);
    const double value = field[static_cast<std::size_t>(c)];
    BOOST_TEST(std::abs(value - (reached ? 4.0 : 0.0)) < 1e-9);
    if (reached) continue;
    ++empty;
    BOOST_TEST(value == 0.0);
  }
  return empty;
}

// A column with one regular point per cell and every third element empty, from element `first` on.
struct ColumnWithGaps {
  int first;
  Grid<1> grid;
  PointSet<1> points;

  ColumnWithGaps(double length, int elements, int first_gap, int points_per_element = 1)
      : first(first_gap), grid(Vector<1>(0.0), length / elements, CellIndex<1>(elements)) {
    Discretization d;
    d.elements = elements;
    d.points_per_element = points_per_element;
    for (int gap = first; gap + 1 < elements; gap += 3) {
      d.empty_elements.push_back((gap + 0.5) * grid.spacing);
    }
    const auto placed = place_points(d, grid.spacing, Phase::solid);
    for (const double x : placed.x) points.x.emplace_back(x);
    points.volume = placed.volume;
    points.mass.assign(placed.x.size(), density * grid.spacing);
  }
  bool is_gap(int cell) const {
    return cell >= first && (cell - first) % 3 == 0 && cell + 1 < grid.cells[0];
  }
};

// What is within reach of a point has its density, all else has nothing. At the edge of the reach
// the moment matrix may be as badly conditioned as is accepted, 1e4, so rounding is amplified by as
// much.
BOOST_AUTO_TEST_CASE_TEMPLATE(what_no_point_reaches_is_empty, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const FirstLayer<Dim> layer;
  for (const auto& choice : all_choices()) {
    const Transfer<Dim> transfer(layer.points, layer.grid, choice);
    BOOST_TEST_CONTEXT(title(choice)) {
      const std::size_t no_nodes = check_reach_of_nodes(layer, transfer, choice);
      BOOST_TEST(no_nodes > 0U);
      const std::size_t no_centres = check_reach_of_centres(layer, transfer, choice);
      const bool is_shape = choice.transfer == TransferName::shape;
      BOOST_TEST(transfer.empty_rows() == (is_shape ? 0U : no_nodes + no_centres));
    }
  }
}

// A point on a node belongs to a cell whose other node it does not reach: N = 0 there.
BOOST_AUTO_TEST_CASE(a_point_on_a_node_reaches_that_node_only) {
  const Grid<1> grid(Vector<1>(0.0), 1.0, CellIndex<1>(3));
  const PointSet<1> points{{Vector<1>(1.0)}, {1.0}, {2.0}};
  const Transfer<1> transfer(points, grid, shape());
  const auto per_element = boost::test_tools::per_element();
  BOOST_TEST(transfer.nodal_mass() == (std::vector<double>{0.0, 2.0, 0.0, 0.0}), per_element);
  BOOST_TEST(at_nodes(transfer, {4.0}) == (std::vector<double>{0.0, 4.0, 0.0, 0.0}), per_element);
}

// The middle of an empty element is exactly one h from the nearest points: bspline1 of radius 1
// gives them no weight. Rounding may put them inside the radius, and then moving least squares
// would give such a point all the weight there is.
BOOST_AUTO_TEST_CASE(points_at_the_support_radius_do_not_count) {
  const std::vector<std::pair<double, int>> columns{
      {0.1, 101}, {0.1, 100}, {1.0, 3000}, {0.07, 57}, {0.3, 1003}, {1e3, 777}, {0.1, 1'000'000}};
  for (const auto& [length, elements] : columns) {
    for (int first = 1; first <= (elements > 10'000 ? 1 : 3); ++first) {
      const ColumnWithGaps column(length, elements, first);
      for (const int order : {0, 1}) {
        const Transfer<1> transfer(column.points, column.grid, mls<BSpline1>(1.0, order));
        const auto field =
            transfer.at_cell_centres(std::vector<double>(column.points.x.size(), 1.0));
        std::size_t gaps = 0;
        std::size_t wrong = 0;
        for (int cell = 0; cell < elements; ++cell) {
          const double value = field[static_cast<std::size_t>(cell)];
          gaps += column.is_gap(cell) ? 1U : 0U;
          wrong += std::abs(value - (column.is_gap(cell) ? 0.0 : 1.0)) > 1e-12 ? 1U : 0U;
        }
        BOOST_TEST_CONTEXT(length << "/" << elements << ", order " << order) {
          BOOST_TEST(gaps > 10U);
          BOOST_TEST(wrong == 0U);
          BOOST_TEST(transfer.empty_rows() == gaps);  // all nodes are reached
        }
      }
    }
  }
}

// Forces at the two nodes of an empty element under a constant stress: free surfaces where nothing
// reaches across, no force where the support does.
BOOST_AUTO_TEST_CASE(an_empty_element_is_a_crack_unless_the_support_reaches_across) {
  const double stress = 5.0;
  const auto largest_error = [&](const ColumnWithGaps& column, const Discretization& choice,
                                 bool crack) {
    const Transfer<1> transfer(column.points, column.grid, choice);
    const auto f = force(transfer, std::vector<double>(column.points.x.size(), stress), 0);
    double error = 0.0;
    for (int i = 1; i < column.grid.cells[0]; ++i) {
      const double jump =
          (column.is_gap(i) ? -stress : 0.0) + (column.is_gap(i - 1) ? stress : 0.0);
      error = std::max(error, std::abs(f[static_cast<std::size_t>(i)] - (crack ? jump : 0.0)));
    }
    return error;
  };
  for (int first = 1; first <= 3; ++first) {
    const ColumnWithGaps one(0.1, 101, first);
    BOOST_TEST(largest_error(one, shape(), true) < 1e-11);
    BOOST_TEST(largest_error(one, mls<BSpline1>(1.0, 0), true) < 1e-11);
    BOOST_TEST(largest_error(one, mls<BSpline1>(1.0, 1), true) < 1e-11);
    BOOST_TEST(largest_error(one, mls<BSpline1>(1.0, 1), false) > 4.9);
    for (const int order : {0, 1, 2}) {
      BOOST_TEST(largest_error(one, mls<WendlandC2>(5.0, order), false) < 1e-10);
    }
    // With two points per cell bspline1 reaches across, shape never does.
    const ColumnWithGaps two(0.1, 101, first, 2);
    BOOST_TEST(largest_error(two, mls<BSpline1>(1.0, 1), false) < 1e-10);
    BOOST_TEST(largest_error(two, shape(), true) < 1e-11);
  }
}

// What happens beyond the gap is not felt on this side.
BOOST_AUTO_TEST_CASE(only_a_wide_support_passes_forces_across_an_empty_element) {
  const int gap = 50;
  Discretization d;
  d.elements = 101;
  d.points_per_element = 1;
  d.empty_elements = {0.05};
  const Grid<1> grid(Vector<1>(0.0), 0.1 / 101, CellIndex<1>(101));
  const auto placed = place_points(d, grid.spacing, Phase::fluid);
  PointSet<1> points{{}, placed.volume, std::vector<double>(placed.x.size(), 1.0)};
  std::vector<double> beyond;  // stress and velocity on the far side only
  for (const double x : placed.x) {
    points.x.emplace_back(x);
    beyond.push_back(x > 0.05 ? 1.0 : 0.0);
  }
  const auto felt = [&](const Discretization& choice) {
    const Transfer<1> transfer(points, grid, choice);
    const auto f = force(transfer, beyond, 0);
    const auto v = at_nodes(transfer, beyond);
    double largest = 0.0;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(gap); ++i) {
      largest = std::max({largest, std::abs(f[i]), std::abs(v[i])});
    }
    return largest;
  };
  BOOST_TEST(felt(shape()) == 0.0);
  BOOST_TEST(felt(mls<BSpline1>(1.0, 1)) == 0.0);
  BOOST_TEST(felt(mls<WendlandC2>(5.0, 1)) > 0.1);
  BOOST_TEST(felt(mls<WendlandC2>(5.0, 0)) > 0.1);
}

BOOST_AUTO_TEST_CASE(no_points_at_all_are_a_vacuum) {
  const Grid<1> grid(Vector<1>(0.0), 0.1, CellIndex<1>(4));
  for (const auto& choice : {shape(), mls<BSpline2>(1.5, 1)}) {
    const Transfer<1> transfer({}, grid, choice);
    BOOST_TEST(transfer.nodal_mass() == std::vector<double>(5, 0.0),
               boost::test_tools::per_element());
    BOOST_TEST(at_nodes(transfer, {}) == std::vector<double>(5, 0.0),
               boost::test_tools::per_element());
    BOOST_TEST(force(transfer, {}, 0) == std::vector<double>(5, 0.0),
               boost::test_tools::per_element());
    BOOST_TEST(transfer.at_cell_centres(std::vector<double>{}) == std::vector<double>(4, 0.0),
               boost::test_tools::per_element());
  }
}

// Three points carry a quadratic; two only a line, one a constant: counted, not hidden.
BOOST_AUTO_TEST_CASE(lowered_orders_are_counted) {
  const Grid<1> grid(Vector<1>(0.0), 1.0, CellIndex<1>(1));  // nodes 0 and 1, middle 0.5
  const auto reduced = [&](const std::vector<double>& x, int order) {
    PointSet<1> points;
    for (const double y : x) points.x.emplace_back(y);
    points.volume = points.mass = std::vector<double>(x.size(), 1.0);
    return Transfer<1>(points, grid, mls<WendlandC2>(3.0, order)).reduced_rows();
  };
  BOOST_TEST(reduced({0.2, 0.5, 0.9}, 2) == 0U);
  BOOST_TEST(reduced({0.2, 0.9}, 2) == 3U);
  BOOST_TEST(reduced({0.2, 0.9}, 1) == 0U);
  BOOST_TEST(reduced({0.2}, 1) == 3U);
  BOOST_TEST(reduced({0.2}, 0) == 0U);
}

BOOST_AUTO_TEST_CASE(positions_that_are_not_finite_are_refused) {
  const Grid<2> grid(Vector<2>::Zero(), 0.1, CellIndex<2>::Constant(4));
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const PointSet<2> points{{Vector<2>(0.1, 0.1), Vector<2>(0.1, bad)}, {1.0, 1.0}, {1.0, 1.0}};
    BOOST_CHECK_THROW(Transfer<2>(points, grid, shape()), std::invalid_argument);
    BOOST_CHECK_THROW(Transfer<2>(points, grid, mls<BSpline2>(1.5, 1)), std::invalid_argument);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
