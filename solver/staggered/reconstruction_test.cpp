#include "solver/staggered/reconstruction.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(reconstruction)

namespace {

constexpr double h = 0.1;
constexpr std::size_t cells = 30;

std::vector<double> random_points(std::size_t count, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> x(0.0, h * cells);
  std::vector<double> points(count);
  for (double& p : points) p = x(generator);
  return points;
}

std::vector<double> nodes() {
  std::vector<double> x;
  for (std::size_t i = 0; i <= cells; ++i) x.push_back(h * static_cast<double>(i));
  return x;
}

double power_sum(const AdaptiveRows& phi, std::size_t r, const std::vector<double>& points,
                 double centre, int power) {
  double sum = 0.0;
  for (std::size_t k = phi.rows.row_offsets[r]; k < phi.rows.row_offsets[r + 1]; ++k) {
    const double x = points[static_cast<std::size_t>(phi.rows.columns[k])] - centre;
    sum += phi.rows.values[k] * std::pow(x, power);
  }
  return sum;
}

BOOST_AUTO_TEST_CASE(every_place_keeps_the_order_even_where_points_are_few) {
  // One point a cell at random leaves cells empty; a fixed support must lower its order there.
  const auto points = random_points(cells, 5);
  for (const int order : {2, 3}) {
    const AdaptiveRows phi =
        adaptive_rows(nodes(), points, {kernel_name<WendlandC2>, 2.0 * h, order});
    BOOST_TEST(phi.enlarged > 0u);
    BOOST_TEST(phi.reduced == 0u);
    BOOST_TEST(phi.empty == 0u);
    for (std::size_t r = 0; r <= cells; ++r) {
      for (int power = 0; power <= order; ++power) {
        const double moment = power_sum(phi, r, points, h * static_cast<double>(r), power);
        BOOST_TEST(std::abs(moment - (power == 0 ? 1.0 : 0.0)) < 1e-10);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(places_with_enough_points_are_left_alone) {
  std::vector<double> points;
  for (std::size_t p = 0; p < 4 * cells; ++p) {
    points.push_back(h * (static_cast<double>(p) + 0.5) / 4.0);
  }
  MlsReport report;
  std::vector<Vector<1>> x;
  std::vector<Vector<1>> at;
  for (const double place : nodes()) x.emplace_back(place);
  for (const double point : points) at.emplace_back(point);
  const SparseRows plain = mls_rows<1>(x, at, kernel_name<WendlandC2>, 2.0 * h, 2, report);
  const AdaptiveRows phi = adaptive_rows(nodes(), points, {kernel_name<WendlandC2>, 2.0 * h, 2});
  BOOST_TEST(phi.enlarged == 0u);
  BOOST_TEST(phi.rows.columns == plain.columns, boost::test_tools::per_element());
  BOOST_TEST(phi.rows.values == plain.values, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(what_even_the_largest_support_cannot_mend_is_counted) {
  // Both points are near x = 0; the largest support, 8 · 2 h, does not see them from beyond.
  const AdaptiveRows phi =
      adaptive_rows(nodes(), {0.4 * h, 0.6 * h}, {kernel_name<WendlandC2>, 2.0 * h, 2});
  BOOST_TEST(phi.enlarged == cells + 1);
  BOOST_TEST(phi.empty > 10u);
  BOOST_TEST(phi.reduced > 10u);
  BOOST_TEST(phi.empty + phi.reduced == cells + 1);
}

BOOST_AUTO_TEST_CASE(polynomials_of_the_basis_come_back_from_the_points_unchanged) {
  const auto points = random_points(4 * cells, 7);
  const auto line = CubicLine::nodes(cells, h, EndRule::open, EndRule::open);
  for (const int order : {2, 3}) {
    const AdaptiveRows phi =
        adaptive_rows(nodes(), points, {kernel_name<WendlandC2>, 2.0 * h, order});
    const BandMatrix matrix = through(phi.rows, points, line, {cells + 1, 0, 3});
    std::vector<double> values;
    for (const double x : nodes()) {
      values.push_back(1.0 + x * (2.0 - 3.0 * x + (order == 3 ? x * x : 0.0)));
    }
    std::vector<double> back(cells + 1);
    matrix.multiply(values, back, cells + 1);
    for (std::size_t i = 0; i <= cells; ++i) BOOST_TEST(std::abs(back[i] - values[i]) < 1e-10);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
