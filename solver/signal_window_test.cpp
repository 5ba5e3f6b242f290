#include "solver/signal_window.hpp"

#include <boost/test/unit_test.hpp>
#include <vector>

BOOST_AUTO_TEST_SUITE(signal_window)

using namespace porowave::solver;

namespace {

constexpr std::size_t guard = 3;
constexpr std::size_t growth = SignalWindow::growth;

// The window of a long column after a step that gave one node a velocity.
std::size_t after_velocity(std::size_t node, double solid, double fluid) {
  SignalWindow window = SignalWindow::at_rest(1000, guard, 1e-9);
  std::vector<double> vs(1000), vf(1000);
  vs[node] = solid;
  vf[node] = fluid;
  window.widen(vs, vf);
  return window.nodes;
}

}  // namespace

BOOST_AUTO_TEST_CASE(it_widens_before_a_signal_can_leave_it) {
  constexpr std::size_t narrow = growth + guard;
  constexpr std::size_t wide = narrow + growth + guard;
  for (std::size_t node = 0; node < narrow; ++node) {
    const std::size_t expected = node + guard >= narrow ? wide : narrow;
    BOOST_TEST(after_velocity(node, 1.1e-9, 0.0) == expected);
    BOOST_TEST(after_velocity(node, 0.0, -1.1e-9) == expected);
    BOOST_TEST(after_velocity(node, 0.9e-9, -0.9e-9) == narrow);
  }
  BOOST_TEST(after_velocity(narrow, 1.0, 1.0) == narrow);
}

BOOST_AUTO_TEST_CASE(a_velocity_that_is_no_number_widens_it) {
  BOOST_TEST(after_velocity(growth + guard - 1, std::nan(""), 0.0) > growth + guard);
}

BOOST_AUTO_TEST_CASE(it_ends_with_the_column) {
  BOOST_TEST(SignalWindow::at_rest(10, guard, 0.0).nodes == 10u);
  SignalWindow window = SignalWindow::at_rest(30, guard, 0.0);
  const std::vector<double> moving(30, 1.0);
  window.widen(moving, moving);
  BOOST_TEST(window.nodes == 30u);
  window = SignalWindow::whole_column(30);
  window.widen(moving, moving);
  BOOST_TEST(window.nodes == 30u);
}

BOOST_AUTO_TEST_SUITE_END()
