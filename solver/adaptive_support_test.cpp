#include "solver/adaptive_support.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "solver/weights.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(adaptive_support)

namespace {

const double natural = 1.0;  // h = 1 in these tests

// Four points a cell in `cells` cells, none in those from `first` to `last`.
std::vector<Vector<1>> column(int cells, int first, int last) {
  std::vector<Vector<1>> x;
  for (int c = 0; c < cells; ++c) {
    if (c >= first && c <= last) continue;
    for (int k = 0; k < 4; ++k) x.emplace_back(c + (k + 0.5) / 4);
  }
  return x;
}

std::vector<Vector<1>> nodes_and_middles(int cells) {
  std::vector<Vector<1>> x;
  for (int k = 0; k <= 2 * cells; ++k) x.emplace_back(0.5 * k);
  return x;
}

Support adaptive(int order) {
  return {natural, largest_adaptive_radius, well_conditioned_limit(order)};
}

BOOST_AUTO_TEST_CASE(a_fixed_support_is_evaluated_once_whatever_it_gives) {
  int calls = 0;
  const double radius = grow_support(Support(2.0), 1, [&](double r) {
    ++calls;
    BOOST_TEST(r == 2.0);
    return MlsResult{-1, 0.0};
  });
  BOOST_TEST(radius == 2.0);
  BOOST_TEST(calls == 1);
}

BOOST_AUTO_TEST_CASE(the_first_good_radius_is_taken) {
  std::vector<double> tried;
  const double radius = grow_support(Support(1.0, 5.0, 10.0), 1, [&](double r) {
    tried.push_back(r);
    if (r < 1.4) return MlsResult{0, 1.0};   // order too low
    if (r < 1.7) return MlsResult{1, 11.0};  // badly conditioned
    return MlsResult{1, 9.0};
  });
  BOOST_TEST(radius == tried.back());
  BOOST_TEST(tried.size() == 4U);
  for (std::size_t k = 1; k < tried.size(); ++k) {
    BOOST_TEST(std::abs(tried[k] / tried[k - 1] - support_growth) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(without_a_good_one_the_best_is_evaluated_last) {
  double last = 0.0;
  const double radius = grow_support(Support(1.0, 3.0, 10.0), 2, [&](double r) {
    BOOST_TEST(r <= 3.0);
    last = r;
    if (r < 1.1) return MlsResult{0, 1.0};
    if (r < 1.3) return MlsResult{1, 40.0};
    if (r < 1.5) return MlsResult{1, 20.0};  // the highest order, and its smallest condition
    return MlsResult{1, 30.0};
  });
  BOOST_TEST(std::abs(radius - support_growth * support_growth) < 1e-14);
  BOOST_TEST(last == radius);
}

BOOST_AUTO_TEST_CASE(nothing_is_enlarged_where_points_are_enough) {
  for (const int order : {0, 1}) {
    MlsReport report;
    const SparseRows rows = mls_rows<1>(nodes_and_middles(20), column(20, 1, 0),
                                        kernel_name<BSpline1>, adaptive(order), order, report);
    BOOST_TEST(report.rows_of_enlarged_support == 0U);
    BOOST_TEST(report.largest_radius == natural);
    MlsReport fixed;
    const SparseRows same = mls_rows<1>(nodes_and_middles(20), column(20, 1, 0),
                                        kernel_name<BSpline1>, natural, order, fixed);
    BOOST_TEST(rows.values == same.values, boost::test_tools::per_element());
    BOOST_TEST(rows.columns == same.columns, boost::test_tools::per_element());
  }
}

// Up to nine (eight) elements in a row: the basis keeps its order, and so linear fields (of order
// 2: quadratic ones) are reproduced everywhere, without a fixed wide support.
BOOST_AUTO_TEST_CASE(holes_are_bridged_at_the_full_order) {
  for (const int order : {1, 2}) {
    for (const int hole : {1, 2, 3, 6, order == 1 ? 9 : 8}) {
      const auto points = column(30, 10, 9 + hole);
      const auto places = nodes_and_middles(30);
      MlsReport report;
      const SparseRows rows =
          mls_rows<1>(places, points, kernel_name<BSpline2>, adaptive(order), order, report);
      BOOST_TEST(report.rows_of_reduced_order == 0U);
      BOOST_TEST(report.rows_without_point == 0U);
      BOOST_TEST(report.largest_radius <= largest_adaptive_radius);
      const auto u = [&](double x) { return 2.0 - 0.3 * x + (order == 2 ? 0.05 * x * x : 0.0); };
      std::vector<double> values;
      for (const Vector<1>& x : points) values.push_back(u(x[0]));
      std::vector<double> field(places.size());
      multiply(rows, values, field);
      for (std::size_t k = 0; k < places.size(); ++k) {
        BOOST_TEST(std::abs(field[k] - u(places[k][0])) < 1e-10);
      }
    }
  }
}

// Within a hole of three the evaluation must see both sides: extrapolation would be several times
// as large as the values at the points.
BOOST_AUTO_TEST_CASE(a_hole_is_not_extrapolated_from_one_side) {
  const auto points = column(30, 10, 12);
  MlsReport report;
  const SparseRows rows =
      mls_rows<1>(nodes_and_middles(30), points, kernel_name<BSpline1>, adaptive(1), 1, report);
  for (std::size_t r = 0; r < rows.row_count(); ++r) {
    double size = 0.0;
    for (std::size_t k = rows.row_offsets[r]; k < rows.row_offsets[r + 1]; ++k) {
      size += std::abs(rows.values[k]);
    }
    BOOST_TEST(size < std::sqrt(well_conditioned_limit(1)));
  }
}

BOOST_AUTO_TEST_CASE(beyond_the_limit_the_order_falls_and_then_nothing_is_known) {
  const auto points = column(40, 10, 29);
  MlsReport report;
  mls_rows<1>(std::vector<Vector<1>>{Vector<1>(14.8), Vector<1>(20.0)}, points,
              kernel_name<BSpline2>, adaptive(1), 1, report);
  BOOST_TEST(report.order_used[0] == 0);  // one point is within five element lengths
  BOOST_TEST(report.order_used[1] == -1);
}

BOOST_AUTO_TEST_CASE(supports_that_make_no_sense_are_refused) {
  MlsReport report;
  const auto rows = [&](const Support& support) {
    mls_rows<1>(nodes_and_middles(3), column(3, 1, 0), kernel_name<BSpline1>, support, 1, report);
  };
  BOOST_CHECK_NO_THROW(rows({1.0, 2.0, 1.0}));
  BOOST_CHECK_THROW(rows({0.0, 2.0, 10.0}), std::invalid_argument);
  BOOST_CHECK_THROW(rows({2.0, 1.0, 10.0}), std::invalid_argument);
  BOOST_CHECK_THROW(rows({1.0, 2.0, 0.5}), std::invalid_argument);
  BOOST_CHECK_THROW(rows({1.0, INFINITY, 10.0}), std::invalid_argument);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
