#include "solver/shape_functions.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "solver/test_points.hpp"
#include "solver/transfer_fixtures.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(shape_functions)

namespace {

using namespace test;

// Random points up to the ends of the grid, the ends themselves, and domains of many sizes.
template <int Dim>
struct Sample {
  Grid<Dim> grid = test_grid<Dim>();
  std::vector<Vector<Dim>> points;
  std::vector<double> domain;

  Sample() {
    const auto unit = random_points<Dim>(300, 17);
    for (const Vector<Dim>& u : unit) {
      points.push_back(grid.origin +
                       grid.spacing * u.cwiseProduct(grid.cells.template cast<double>()));
    }
    points.push_back(grid.origin);
    points.push_back(grid.node_position(grid.node_count() - 1));
    domain = noise(points.size(), 4, 0.1 * grid.spacing, grid.spacing);
  }
  LinearRows<Dim> rows(ShapeName shape) const {
    return shape_rows<Dim>(points, domain, grid, shape);
  }
};

template <class F>
void for_all_shapes(F&& check) {
  for (std::size_t s = 0; s < shape_count; ++s) {
    BOOST_TEST_CONTEXT(std::string(to_string(ShapeName{s}))) check(ShapeName{s});
  }
}

std::vector<double> product(const SparseRows& rows, const std::vector<double>& nodal) {
  std::vector<double> values(rows.row_count());
  multiply(rows, nodal, values);
  return values;
}

// N_i at one coordinate of a grid of ten cells of size 1.
std::vector<double> functions_at(double x, ShapeName shape, double domain = 0.5) {
  const Grid<1> grid(Vector<1>(0.0), 1.0, CellIndex<1>(10));
  const std::vector<Vector<1>> points{Vector<1>(x)};
  const auto rows = shape_rows<1>(points, std::vector<double>{domain}, grid, shape);
  std::vector<double> values(11, 0.0);
  for (std::size_t k = 0; k < rows.values.columns.size(); ++k) {
    values[static_cast<std::size_t>(rows.values.columns[k])] += rows.values.values[k];
  }
  return values;
}

BOOST_AUTO_TEST_CASE_TEMPLATE(they_sum_to_one_and_are_not_negative, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const Sample<Dim> sample;
  const std::vector<double> ones(static_cast<std::size_t>(sample.grid.node_count()), 1.0);
  for_all_shapes([&](ShapeName shape) {
    const auto rows = sample.rows(shape);
    for (const double sum : product(rows.values, ones)) BOOST_TEST(std::abs(sum - 1.0) < 1e-13);
    for (const SparseRows& gradient : rows.gradients) {
      for (const double sum : product(gradient, ones)) BOOST_TEST(std::abs(sum) < 1e-11);
    }
    for (const double value : rows.values.values) BOOST_TEST(value > -1e-14);
  });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(linear_fields_are_reproduced_up_to_the_ends, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const Sample<Dim> all;
  const auto u = sample<Dim>(nodes(all.grid), Linear<Dim>::at);
  const auto expected = sample<Dim>(all.points, Linear<Dim>::at);
  for_all_shapes([&](ShapeName shape) {
    const auto rows = all.rows(shape);
    BOOST_TEST(largest_difference(product(rows.values, u), expected) < 1e-13);
    for (int axis = 0; axis < Dim; ++axis) {
      const auto slopes = product(rows.gradients[static_cast<std::size_t>(axis)], u);
      const std::vector<double> slope(all.points.size(), Linear<Dim>::slope(axis));
      BOOST_TEST(largest_difference(slopes, slope) < 1e-11);
    }
  });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(gradients_are_those_of_the_values, D, test::Dimensions) {
  constexpr int Dim = D::value;
  Sample<Dim> middle;
  middle.points.resize(300);  // without the ends
  middle.domain.resize(300);
  const double step = 1e-6 * middle.grid.spacing;
  const auto u = noise(static_cast<std::size_t>(middle.grid.node_count()), 9);
  for_all_shapes([&](ShapeName shape) {
    for (int axis = 0; axis < Dim; ++axis) {
      auto moved = middle;
      for (auto& x : moved.points) x[axis] += step;
      const auto above = product(moved.rows(shape).values, u);
      for (auto& x : moved.points) x[axis] -= 2.0 * step;
      const auto below = product(moved.rows(shape).values, u);
      const auto slopes = product(middle.rows(shape).gradients[static_cast<std::size_t>(axis)], u);
      for (std::size_t p = 0; p < slopes.size(); ++p) {
        BOOST_TEST(std::abs(slopes[p] - (above[p] - below[p]) / (2.0 * step)) < 1e-4);
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(the_ends_belong_to_their_nodes) {
  for_all_shapes([](ShapeName shape) {
    BOOST_TEST(std::abs(functions_at(0.0, shape)[0] - 1.0) < 1e-14);
    BOOST_TEST(std::abs(functions_at(10.0, shape)[10] - 1.0) < 1e-14);
    // Outside the linear functions go on; nothing jumps.
    const auto outside = functions_at(-1e-9, shape);
    const auto inside = functions_at(1e-9, shape);
    for (std::size_t i = 0; i < 11; ++i) BOOST_TEST(std::abs(outside[i] - inside[i]) < 1e-8);
  });
}

BOOST_AUTO_TEST_CASE(values_by_hand) {
  const auto is = [](const std::vector<double>& values, std::size_t node, double expected) {
    BOOST_TEST(std::abs(values[node] - expected) < 1e-14);
  };
  const ShapeName quadratic = shape_name<SplineShape<BSpline2>>;
  is(functions_at(5.0, quadratic), 5, 0.75);
  is(functions_at(5.0, quadratic), 4, 0.125);
  is(functions_at(5.3, quadratic), 6, 0.32);   // (1.5 − 0.7)²/2
  is(functions_at(0.25, quadratic), 0, 0.75);  // linear in the first half cell
  is(functions_at(0.25, quadratic), 1, 0.25);
  const ShapeName cubic = shape_name<SplineShape<BSpline3>>;
  is(functions_at(5.0, cubic), 5, 2.0 / 3.0);
  is(functions_at(5.5, cubic), 4, 1.0 / 48.0);
  is(functions_at(0.5, cubic), 0, 1.0 - 0.5 + 0.125 / 6.0);  // 1 − r + r³/6
  is(functions_at(9.5, cubic), 10, 1.0 - 0.5 + 0.125 / 6.0);
  const ShapeName gimp = shape_name<GimpShape<false>>;
  is(functions_at(5.0, gimp, 0.5), 5, 0.875);   // 1 − l/4 of the domain's edge l
  is(functions_at(5.0, gimp, 0.5), 6, 0.0625);  // l/8
  is(functions_at(5.5, gimp, 0.5), 5, 0.5);     // within the cell: the linear function
  is(functions_at(0.1, gimp, 0.5), 0, 0.9);     // sticking out of the column as well
}

BOOST_AUTO_TEST_CASE(a_small_domain_sees_the_linear_functions) {
  for (const double x : {0.3, 4.9, 5.2, 9.99}) {
    const auto linear = functions_at(x, shape_name<LinearSpline>);
    const auto gimp = functions_at(x, shape_name<GimpShape<false>>, 1e-5);
    for (std::size_t i = 0; i < 11; ++i) BOOST_TEST(std::abs(gimp[i] - linear[i]) < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(names_find_their_shape) {
  for_all_shapes([](ShapeName shape) {
    BOOST_CHECK(shape_from_name(to_string(shape)) == shape);
    BOOST_TEST(convects_domains(shape) == (to_string(shape) == "cpgimp"));
  });
  BOOST_TEST(!shape_from_name("wendland_c2"));
}

// Whatever the shape, the classical transfers conserve mass and momentum, and forces balance.
BOOST_AUTO_TEST_CASE_TEMPLATE(the_transfer_conserves_with_every_shape, D, test::Dimensions) {
  constexpr int Dim = D::value;
  auto points = scattered<Dim>();
  points.mass = noise(points.x.size(), 3, 0.1, 2.0);
  points.domain.assign(points.x.size(), test_grid<Dim>().spacing / per_axis);
  for_all_shapes([&](ShapeName name) {
    Discretization choice = shape();
    choice.shape = name;
    const Transfer<Dim> transfer(points, test_grid<Dim>(), choice);
    BOOST_TEST(std::abs(sum(transfer.nodal_mass()) / sum(points.mass) - 1.0) < 1e-13);
    const auto v = noise(points.x.size(), 6);
    BOOST_TEST(std::abs(dot(transfer.nodal_mass(), at_nodes(transfer, v)) - dot(points.mass, v)) <
               1e-12 * sum(points.mass));
    for (int axis = 0; axis < Dim; ++axis) {
      BOOST_TEST(std::abs(sum(force(transfer, noise(points.x.size(), 8), axis))) < 1e-12);
    }
  });
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused) {
  const Grid<1> grid(Vector<1>(0.0), 1.0, CellIndex<1>(10));
  const std::vector<Vector<1>> points{Vector<1>(0.5)};
  const std::vector<Vector<1>> bad{Vector<1>(std::numeric_limits<double>::quiet_NaN())};
  for_all_shapes([&](ShapeName shape) {
    const bool has_domain = to_string(shape).ends_with("gimp");
    const auto rows = [&](const auto& x, const std::vector<double>& domain) {
      shape_rows<1>(x, domain, grid, shape);
    };
    BOOST_CHECK_THROW(rows(bad, {0.1}), std::invalid_argument);
    BOOST_CHECK_NO_THROW(rows(points, {0.1}));
    if (!has_domain) {
      BOOST_CHECK_NO_THROW(rows(points, {}));
      return;
    }
    BOOST_CHECK_THROW(rows(points, {}), std::invalid_argument);
    BOOST_CHECK_THROW(rows(points, {0.0}), std::invalid_argument);
    BOOST_CHECK_THROW(rows(points, {INFINITY}), std::invalid_argument);
  });
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
