#include "solver/moving/moving_rows.hpp"

#include <boost/test/unit_test.hpp>

#include "solver/test_points.hpp"

BOOST_AUTO_TEST_SUITE(moving_rows)

using namespace porowave::solver;

namespace {

constexpr double h = 0.1;
const KernelName kernel = kernel_name<BSpline2>;

std::vector<double> nodes(long first, long last) {
  std::vector<double> places;
  for (long i = first; i <= last; ++i) places.push_back(h * static_cast<double>(i));
  return places;
}

std::vector<Vector<1>> sorted_points() {
  auto x = test::random_points<1>(160, 3, 0.0, 4.0);
  reorder(order_along(x), x);
  return x;
}

std::vector<double> products(const MovingRows& rows, std::size_t count,
                             const std::vector<Vector<1>>& x) {
  std::vector<double> values;
  for (const Vector<1>& point : x) values.push_back(std::sin(5.0 * point[0]) + 2.0);
  std::vector<double> result(count);
  rows.multiply(values, result);
  return result;
}

/// The same to the last bit as rows that are made anew.
void check_against_fresh(const MovingRows& rows, long first, const std::vector<double>& places,
                         const std::vector<Vector<1>>& x) {
  MovingRows fresh(kernel, 1.5 * h, 1);
  fresh.renew(first, places, x, MovedPoints(std::vector<bool>(x.size(), true)));
  BOOST_TEST(fresh.renewed() == places.size());
  BOOST_TEST(products(rows, places.size(), x) == products(fresh, places.size(), x),
             boost::test_tools::per_element());
}

}  // namespace

BOOST_AUTO_TEST_CASE(rows_are_those_of_moving_least_squares) {
  const auto x = sorted_points();
  const auto places = nodes(0, 40);
  MovingRows rows(kernel, 1.5 * h, 1);
  rows.renew(0, places, x, MovedPoints(std::vector<bool>(x.size(), true)));
  std::vector<Vector<1>> at;
  for (const double place : places) at.emplace_back(place);
  MlsReport report;
  const SparseRows expected = mls_rows<1>(at, x, kernel, 1.5 * h, 1, report);
  std::vector<double> values;
  for (const Vector<1>& point : x) values.push_back(std::sin(5.0 * point[0]) + 2.0);
  std::vector<double> result(places.size());
  multiply(expected, values, result);
  BOOST_TEST(products(rows, places.size(), x) == result, boost::test_tools::per_element());
  BOOST_TEST(rows.reduced() == report.rows_of_reduced_order);
  BOOST_TEST(rows.empty() == report.rows_without_point);
}

BOOST_AUTO_TEST_CASE(only_rows_in_reach_of_moved_points_are_renewed) {
  auto x = sorted_points();
  const auto places = nodes(0, 40);
  MovingRows rows(kernel, 1.5 * h, 1);
  rows.renew(0, places, x, MovedPoints(std::vector<bool>(x.size(), true)));
  std::vector<bool> moved(x.size(), false);
  rows.renew(0, places, x, MovedPoints(moved));
  BOOST_TEST(rows.renewed() == 0u);
  // One point moves by a tenth of h: the nodes that it left, still sees and now reaches.
  const std::size_t p = 77;
  const double before = x[p][0];
  x[p][0] = std::min(before + 0.1 * h, 0.5 * (before + x[p + 1][0]));
  moved[p] = true;
  std::size_t expected = 0;
  for (const double place : places) {
    expected += before >= place - 1.5 * h && x[p][0] <= place + 1.5 * h ? 1u : 0u;
  }
  rows.renew(0, places, x, MovedPoints(moved));
  BOOST_TEST(rows.renewed() >= 3u);
  BOOST_TEST(rows.renewed() <= expected + 1);
  check_against_fresh(rows, 0, places, x);
}

BOOST_AUTO_TEST_CASE(rows_follow_points_and_places_that_come_and_go) {
  auto x = sorted_points();
  MovingRows rows(kernel, 1.5 * h, 1);
  rows.renew(0, nodes(0, 40), x, MovedPoints(std::vector<bool>(x.size(), true)));
  long first = 0;
  for (int step = 0; step < 30; ++step) {
    // The right half runs away; the nodes follow on both sides.
    std::vector<bool> moved(x.size(), false);
    for (std::size_t p = x.size() / 2; p < x.size(); ++p) {
      x[p][0] += 0.3 * h * static_cast<double>(p - x.size() / 2) / 80.0;
      moved[p] = p > x.size() / 2;
    }
    if (step % 3 == 0) ++first;
    if (step == 20) first -= 4;
    const auto places = nodes(first, 41 + step / 2);
    rows.renew(first, places, x, MovedPoints(moved));
    check_against_fresh(rows, first, places, x);
    BOOST_TEST(rows.renewed() < places.size());
  }
}

BOOST_AUTO_TEST_CASE(a_place_that_moves_gets_a_new_row) {
  const auto x = sorted_points();
  auto places = nodes(0, 40);
  MovingRows rows(kernel, 1.5 * h, 1);
  rows.renew(0, places, x, MovedPoints(std::vector<bool>(x.size(), true)));
  places.back() -= 1e-9;
  rows.renew(0, places, x, MovedPoints(std::vector<bool>(x.size(), false)));
  BOOST_TEST(rows.renewed() == 1u);
  check_against_fresh(rows, 0, places, x);
}

BOOST_AUTO_TEST_SUITE_END()
