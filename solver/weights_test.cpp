#include "solver/weights.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>

#include "solver/test_points.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(weights)

namespace {

template <int Dim>
std::vector<Vector<Dim>> cloud() {
  return test::random_points<Dim>(Dim == 1 ? 40 : 400, 31);
}

template <int Dim>
Grid<Dim> unit_grid() {
  return {Vector<Dim>::Zero(), 0.25, CellIndex<Dim>::Constant(4)};
}

template <int Dim>
std::vector<Vector<Dim>> nodes(const Grid<Dim>& grid) {
  std::vector<Vector<Dim>> x;
  for (int i = 0; i < grid.node_count(); ++i) x.push_back(grid.node_position(i));
  return x;
}

// u(x) at every point
template <int Dim, class F>
std::vector<double> sample(const std::vector<Vector<Dim>>& points, F&& u) {
  std::vector<double> values;
  for (const Vector<Dim>& x : points) values.push_back(u(x));
  return values;
}

BOOST_AUTO_TEST_CASE(products_agree_with_the_dense_matrix) {
  // [1 0 2; 0 0 0; 0 3 4]
  const SparseRows rows{{0, 2, 2, 4}, {0, 2, 1, 2}, {1.0, 2.0, 3.0, 4.0}, 3};
  const std::vector<double> in{5.0, 6.0, 7.0};
  std::vector<double> out(3, -1.0);
  multiply(rows, in, out);
  BOOST_TEST(out == (std::vector<double>{19.0, 0.0, 46.0}), boost::test_tools::per_element());
  multiply_transposed(rows, in, out);
  BOOST_TEST(out == (std::vector<double>{5.0, 21.0, 38.0}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(products_refuse_vectors_of_another_length) {
  const SparseRows rows{{0, 1, 2}, {0, 2}, {1.0, 1.0}, 3};
  std::vector<double> two(2);
  std::vector<double> three(3);
  BOOST_CHECK_NO_THROW(multiply(rows, three, two));
  BOOST_CHECK_NO_THROW(multiply_transposed(rows, two, three));
  BOOST_CHECK_THROW(multiply(rows, two, two), std::invalid_argument);
  BOOST_CHECK_THROW(multiply(rows, three, three), std::invalid_argument);
  BOOST_CHECK_THROW(multiply_transposed(rows, three, two), std::invalid_argument);
}

// Every kernel and order of the run-time table against the compile-time evaluation at all points.
BOOST_AUTO_TEST_CASE_TEMPLATE(rows_are_the_values_at_each_evaluation_point, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto points = cloud<Dim>();
  const auto x = nodes(unit_grid<Dim>());
  const double radius = 0.4;
  std::apply(
      [&](auto... kernel) {
        const auto check = [&]<class Kernel>(Kernel) {
          MlsReport report;
          const auto rows = mls_rows<Dim>(x, points, kernel_name<Kernel>, radius, 1, report);
          const MovingLeastSquares<Kernel, Dim, 1> mls(radius);
          std::vector<double> phi(points.size());
          std::vector<double> row(points.size());
          std::vector<double> unit(x.size(), 0.0);
          for (std::size_t r = 0; r < x.size(); ++r) {
            mls.evaluate(x[r], points, phi);
            std::fill(unit.begin(), unit.end(), 0.0);
            unit[r] = 1.0;
            multiply_transposed(rows, unit, row);
            for (std::size_t p = 0; p < points.size(); ++p) {
              BOOST_TEST(std::abs(row[p] - phi[p]) < 1e-11);
            }
          }
        };
        (check(kernel), ...);
      },
      Kernels{});
}

BOOST_AUTO_TEST_CASE_TEMPLATE(rows_reproduce_the_degree_asked_for, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto points = cloud<Dim>();
  const auto x = nodes(unit_grid<Dim>());
  for (int order = 0; order <= 3; ++order) {
    const auto power = [&](int degree) {
      return [degree](const Vector<Dim>& y) { return std::pow(0.3 + y.sum(), degree); };
    };
    MlsReport report;
    const auto rows = mls_rows<Dim>(x, points, kernel_name<WendlandC2>, 0.8, order, report);
    BOOST_TEST(report.rows_of_reduced_order == 0U);
    BOOST_TEST(report.rows_without_point == 0U);
    std::vector<double> u(x.size());
    const auto largest_error = [&](int degree) {
      multiply(rows, sample<Dim>(points, power(degree)), u);
      const auto exact = sample<Dim>(x, power(degree));
      double error = 0.0;
      for (std::size_t r = 0; r < x.size(); ++r) error = std::max(error, std::abs(u[r] - exact[r]));
      return error;
    };
    BOOST_TEST(largest_error(order) < 1e-10);
    BOOST_TEST(largest_error(order + 1) > 1e-5);
  }
}

BOOST_AUTO_TEST_CASE(report_counts_what_happened) {
  // rows: 4 points around, 1 point in reach, none in reach
  const std::vector<Vector<1>> points{Vector<1>(0.0), Vector<1>(0.1), Vector<1>(0.2),
                                      Vector<1>(0.3), Vector<1>(5.0)};
  const std::vector<Vector<1>> x{Vector<1>(0.15), Vector<1>(5.1), Vector<1>(9.0)};
  MlsReport report;
  report.rows_without_point = 99;  // must be overwritten
  const auto rows = mls_rows<1>(x, points, kernel_name<BSpline2>, 0.5, 2, report);
  BOOST_TEST(report.rows_of_reduced_order == 1U);
  BOOST_TEST(report.rows_without_point == 1U);
  BOOST_TEST((report.order_used == std::vector<std::int8_t>{2, 0, -1}));
  BOOST_TEST(report.worst_condition > 1.0);
  BOOST_TEST(report.worst_condition < default_max_condition);
  BOOST_TEST((rows.row_offsets == std::vector<std::size_t>{0, 4, 5, 5}));
  BOOST_TEST(rows.columns[4] == 4);
  BOOST_TEST(rows.column_count == 5U);

  MlsReport strict;
  mls_rows<1>(x, points, kernel_name<BSpline2>, 0.5, 2, strict, 1.0 + 1e-9);
  BOOST_TEST(strict.rows_of_reduced_order == 2U);
}

BOOST_AUTO_TEST_CASE(no_points_give_empty_rows) {
  const std::vector<Vector<2>> x(3, Vector<2>::Zero());
  MlsReport report;
  const auto rows = mls_rows<2>(x, {}, kernel_name<BSpline1>, 1.0, 1, report);
  BOOST_TEST(rows.row_count() == 3U);
  BOOST_TEST(rows.values.empty());
  BOOST_TEST(report.rows_without_point == 3U);
  const auto none = mls_rows<2>({}, x, kernel_name<BSpline1>, 1.0, 1, report);
  BOOST_TEST(none.row_count() == 0U);
}

BOOST_AUTO_TEST_CASE(arguments_out_of_range_are_refused) {
  const std::vector<Vector<1>> x{Vector<1>(0.0)};
  const std::vector<Vector<1>> bad{Vector<1>(std::nan(""))};
  MlsReport report;
  const auto make = [&](const auto& at, const auto& points, double radius, int order,
                        double condition = default_max_condition) {
    return mls_rows<1>(at, points, kernel_name<BSpline1>, radius, order, report, condition);
  };
  BOOST_CHECK_NO_THROW(make(x, x, 1.0, 1));
  BOOST_CHECK_THROW(make(x, x, 0.0, 1), std::invalid_argument);
  BOOST_CHECK_THROW(make(x, x, std::nan(""), 1), std::invalid_argument);
  BOOST_CHECK_THROW(make(x, x, 1.0, -1), std::invalid_argument);
  BOOST_CHECK_THROW(make(x, x, 1.0, 4), std::invalid_argument);
  BOOST_CHECK_THROW(make(x, x, 1.0, 1, 0.5), std::invalid_argument);
  BOOST_CHECK_THROW(make(bad, x, 1.0, 1), std::invalid_argument);
  BOOST_CHECK_THROW(make(x, bad, 1.0, 1), std::invalid_argument);
  BOOST_CHECK_THROW(linear_rows<1>(bad, unit_grid<1>()), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(linear_rows_interpolate_and_differentiate, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto points = cloud<Dim>();
  const auto grid = unit_grid<Dim>();
  const Vector<Dim> slope = Vector<Dim>::LinSpaced(-1.0, 2.0);
  const auto field = [&](const Vector<Dim>& x) { return 0.7 + slope.dot(x); };
  const auto rows = linear_rows<Dim>(points, grid);
  const auto nodal = sample<Dim>(nodes(grid), field);
  std::vector<double> at_points(points.size());
  multiply(rows.values, nodal, at_points);
  for (std::size_t p = 0; p < points.size(); ++p) {
    BOOST_TEST(std::abs(at_points[p] - field(points[p])) < 1e-14);
  }
  for (int a = 0; a < Dim; ++a) {
    multiply(rows.gradients[static_cast<std::size_t>(a)], nodal, at_points);
    for (const double du : at_points) BOOST_TEST(std::abs(du - slope[a]) < 1e-13);
  }
}

// The classical P2G: mass and first moment arrive whole on the grid.
BOOST_AUTO_TEST_CASE_TEMPLATE(transposed_linear_rows_conserve_mass_and_its_centre, D,
                              test::Dimensions) {
  constexpr int Dim = D::value;
  const auto points = cloud<Dim>();
  const auto grid = unit_grid<Dim>();
  const auto rows = linear_rows<Dim>(points, grid);
  std::vector<double> nodal(static_cast<std::size_t>(grid.node_count()));
  multiply_transposed(rows.values, std::vector<double>(points.size(), 1.0), nodal);
  double mass = 0.0;
  Vector<Dim> moment = Vector<Dim>::Zero();
  for (int i = 0; i < grid.node_count(); ++i) {
    mass += nodal[static_cast<std::size_t>(i)];
    moment += nodal[static_cast<std::size_t>(i)] * grid.node_position(i);
  }
  for (const Vector<Dim>& x : points) moment -= x;
  BOOST_TEST(std::abs(mass - static_cast<double>(points.size())) < 1e-11);
  BOOST_TEST(moment.norm() < 1e-11);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
