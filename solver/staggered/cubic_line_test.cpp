#include "solver/staggered/cubic_line.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(cubic_line)

namespace {

constexpr double h = 0.25;
constexpr std::size_t cells = 10;
constexpr double length = h * cells;

using Function = std::function<double(double)>;

std::vector<double> on_nodes(const Function& f) {
  std::vector<double> values;
  for (std::size_t i = 0; i <= cells; ++i) values.push_back(f(h * static_cast<double>(i)));
  return values;
}

std::vector<double> on_middles(const Function& f) {
  std::vector<double> values{f(0.0)};
  for (std::size_t c = 0; c < cells; ++c) values.push_back(f(h * (static_cast<double>(c) + 0.5)));
  values.push_back(f(length));
  return values;
}

double sum(const CubicRow& row, const std::vector<double>& values) {
  double result = 0.0;
  for (std::size_t j = 0; j < 4; ++j) result += row.weight[j] * values[row.index[j]];
  return result;
}

// f and its slope at many places, ends included.
void check(const CubicLine& line, const std::vector<double>& values, const Function& f,
           const Function& slope, double tolerance) {
  for (int k = 0; k <= 200; ++k) {
    const double x = length * k / 200.0;
    BOOST_TEST(std::abs(sum(line.value(x), values) - f(x)) < tolerance);
    BOOST_TEST(std::abs(sum(line.slope(x), values) - slope(x)) < tolerance);
  }
}

double cubic(double x) {
  return 1.0 + x * (0.5 - x * (2.0 - 0.75 * x));
}
double cubic_slope(double x) {
  return 0.5 - 4.0 * x + 2.25 * x * x;
}

BOOST_AUTO_TEST_CASE(cubics_are_reproduced_up_to_open_and_held_ends) {
  check(CubicLine::nodes(cells, h, EndRule::open, EndRule::open), on_nodes(cubic), cubic,
        cubic_slope, 1e-12);
  for (const EndRule near : {EndRule::open, EndRule::held}) {
    for (const EndRule far : {EndRule::open, EndRule::held}) {
      check(CubicLine::middles(cells, h, near, far), on_middles(cubic), cubic, cubic_slope, 1e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(half_way_between_places_it_is_the_staggered_difference) {
  const CubicRow row = CubicLine::nodes(cells, h, EndRule::open, EndRule::open).slope(4.5 * h);
  const std::array<double, 4> expected = {1.0 / 24.0, -9.0 / 8.0, 9.0 / 8.0, -1.0 / 24.0};
  for (std::size_t j = 0; j < 4; ++j) {
    BOOST_TEST(row.index[j] == 3 + j);
    BOOST_TEST(row.weight[j] == expected[j] / h, boost::test_tools::tolerance(1e-13));
  }
}

// Cubic pieces of mirrored functions: odd and even cubics about one end, nothing known at the
// other.
BOOST_AUTO_TEST_CASE(mirrored_ends_reproduce_odd_and_even_cubics) {
  const auto odd = [](double x) { return x * (1.0 - 0.25 * x * x); };
  const auto odd_slope = [](double x) { return 1.0 - 0.75 * x * x; };
  const auto even = [](double x) { return 2.0 - 0.5 * x * x; };
  const auto even_slope = [](double x) { return -x; };
  const auto from_far = [](const Function& f) { return [f](double x) { return f(length - x); }; };
  const auto turned = [&](const Function& f) { return [f](double x) { return -f(length - x); }; };
  check(CubicLine::nodes(cells, h, EndRule::odd, EndRule::open), on_nodes(odd), odd, odd_slope,
        1e-12);
  check(CubicLine::nodes(cells, h, EndRule::open, EndRule::odd), on_nodes(from_far(odd)),
        from_far(odd), turned(odd_slope), 1e-12);
  check(CubicLine::middles(cells, h, EndRule::even, EndRule::open), on_middles(even), even,
        even_slope, 1e-12);
  check(CubicLine::middles(cells, h, EndRule::open, EndRule::even), on_middles(from_far(even)),
        from_far(even), turned(even_slope), 1e-12);
}

BOOST_AUTO_TEST_CASE(at_a_mirror_an_even_line_has_no_slope) {
  std::vector<double> any;
  for (std::size_t k = 0; k < cells + 2; ++k) any.push_back(std::sin(7.0 * static_cast<double>(k)));
  const auto line = CubicLine::middles(cells, h, EndRule::even, EndRule::even);
  BOOST_TEST(std::abs(sum(line.slope(0.0), any)) < 1e-13);
  BOOST_TEST(std::abs(sum(line.slope(length), any)) < 1e-13);
}

BOOST_AUTO_TEST_CASE(values_at_ends_count_only_where_they_are_held) {
  std::vector<double> ends(cells + 2, 0.0);
  ends.front() = ends.back() = 1.0;
  const auto open = CubicLine::middles(cells, h, EndRule::open, EndRule::open);
  const auto held = CubicLine::middles(cells, h, EndRule::held, EndRule::held);
  for (const double x : {0.0, 0.1 * h, length - 0.1 * h, length}) {
    BOOST_TEST(sum(open.value(x), ends) == 0.0);
    BOOST_TEST(std::abs(sum(held.value(x), ends)) > 0.7);
  }
}

BOOST_AUTO_TEST_CASE(too_few_cells_are_refused) {
  BOOST_CHECK_THROW(CubicLine::nodes(3, h, EndRule::open, EndRule::open), std::invalid_argument);
  BOOST_CHECK_THROW(CubicLine::middles(4, 0.0, EndRule::open, EndRule::open),
                    std::invalid_argument);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
