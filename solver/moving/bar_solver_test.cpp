#include "solver/moving/bar_solver.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/problem/errors.hpp"

BOOST_AUTO_TEST_SUITE(bar_solver)

using namespace porowave;
using namespace porowave::solver;

namespace {

const NeoHookean rubber{3e5, 4e5};
constexpr double density = 1000.0;

Discretization choice(int elements, Strain strain = Strain::recovered) {
  Discretization d;
  d.elements = elements;
  d.strain = strain;
  return d;
}

/// Stretched by 1.1, held by the stress that belongs to it, moving at half the wave speed.
Bar flying_bar(int cells) {
  Bar bar;
  bar.near = 0.37;
  bar.far = bar.near + cells;
  bar.density = density;
  bar.law = rubber;
  const double sigma = rubber.stress(1.1);
  bar.near_end.stress = bar.far_end.stress = [sigma](double) { return sigma; };
  bar.initial_stretch = [](double) { return 1.1; };
  const double v = 0.5 * wave_speed(rubber, 1.1, density);
  bar.initial_velocity = [v](double, double) { return v; };
  return bar;
}

/// A bar of 60 cells of which the left end is pulled.
Bar pulled_bar() {
  Bar bar;
  bar.far = 60.0;
  bar.density = density;
  bar.law = rubber;
  bar.near_end.stress = [](double) { return 1e4; };
  return bar;
}

double step_of(double courant, double stretch = 1.1) {
  return courant / wave_speed(rubber, stretch, density);  // h = 1
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_flying_bar_keeps_its_velocity_and_stress) {
  for (const Strain strain : {Strain::cell, Strain::recovered}) {
    BarSolver solver(flying_bar(12), choice(12, strain), step_of(0.5));
    for (int i = 0; i < 120; ++i) solver.step();  // 30 cells
    const BarSnapshot now = solver.snapshot();
    BOOST_TEST(now.near == 0.37 + 30.0, boost::test_tools::tolerance(1e-12));
    const double v = 0.5 * wave_speed(rubber, 1.1, density);
    const double sigma = rubber.stress(1.1);
    for (std::size_t p = 0; p < now.x.size(); ++p) {
      BOOST_TEST(std::abs(now.velocity[p] - v) < 1e-12 * v);
      BOOST_TEST(std::abs(now.stress[p] - sigma) < 1e-12 * sigma);
      BOOST_TEST(now.volume[p] == 0.25, boost::test_tools::tolerance(1e-12));
    }
    for (const double s : now.cell_stress) BOOST_TEST(std::abs(s - sigma) < 1e-12 * sigma);
    for (const double w : now.node_velocity) BOOST_TEST(std::abs(w - v) < 1e-12 * v);
  }
}

BOOST_AUTO_TEST_CASE(only_what_moves_is_renewed) {
  // The wave of the pulled end passes one support a step at most; beyond, nothing moves.
  BarSolver solver(pulled_bar(), choice(60), step_of(0.5, 1.0));
  solver.step();
  BOOST_TEST(solver.last_renewal().rows_renewed == solver.last_renewal().rows);
  solver.step();
  const RenewalCount second = solver.last_renewal();
  BOOST_TEST(second.points_moved > 0u);
  BOOST_TEST(second.points_moved < 30u);
  BOOST_TEST(second.rows_renewed < 20u);
  for (int i = 0; i < 8; ++i) solver.step();
  BOOST_TEST(solver.last_renewal().rows_renewed > second.rows_renewed);
  BOOST_TEST(solver.last_renewal().rows_renewed < solver.last_renewal().rows);
}

BOOST_AUTO_TEST_CASE(a_bar_at_rest_stays_where_it_is) {
  Bar bar = pulled_bar();
  bar.near_end = {};
  BarSolver solver(bar, choice(60), step_of(0.5, 1.0));
  const BarSnapshot before = solver.snapshot();
  for (int i = 0; i < 20; ++i) solver.step();
  BOOST_TEST(solver.last_renewal().points_moved == 0u);
  BOOST_TEST(solver.last_renewal().rows_renewed == 0u);
  BOOST_TEST(solver.snapshot().x == before.x, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(small_pulls_give_the_elastic_wave) {
  // v = −σ/(ρ c) behind a front that takes 40 cells to rise, for both laws; it has come 80 cells.
  const double pull = 1.0;
  const double c = std::sqrt(1e6 / density);
  const auto rise = [&](double t) {
    const double z = std::clamp(t * c / 40.0, 0.0, 1.0);
    return pull * z * z * z * (10.0 - 15.0 * z + 6.0 * z * z);
  };
  for (const ConstitutiveLaw& law :
       {ConstitutiveLaw(rubber), ConstitutiveLaw(LinearElastic{1e6})}) {
    Bar bar = pulled_bar();
    bar.law = law;
    bar.far = 120.0;
    bar.near_end.stress = rise;
    BarSolver solver(bar, choice(120), step_of(0.5, 1.0));
    for (int i = 0; i < 160; ++i) solver.step();
    const BarSnapshot now = solver.snapshot();
    for (std::size_t p = 0; p < now.x.size(); ++p) {
      const double expected = rise(now.time - now.x[p] / c);
      BOOST_TEST(std::abs(now.stress[p] - expected) < 0.01 * pull);
      BOOST_TEST(std::abs(now.velocity[p] + expected / (density * c)) <
                 0.01 * pull / (density * c));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_held_end_does_not_move) {
  Bar bar = pulled_bar();
  bar.near_end.stress = [](double) { return 1e5; };
  bar.far = 12.0;
  bar.far_end.held = true;
  BarSolver solver(bar, choice(12), step_of(0.25, 1.0));
  for (int i = 0; i < 100; ++i) solver.step();
  const BarSnapshot now = solver.snapshot();
  BOOST_TEST(now.far == 12.0);
  BOOST_TEST(now.node_velocity.back() == 0.0);
  BOOST_TEST(now.near < -0.5);
  // At the wall the stress has doubled.
  BOOST_TEST(now.cell_stress.back() > 1.4e5);
}

BOOST_AUTO_TEST_CASE(random_points_start_in_order_and_xpic_keeps_a_flight) {
  Discretization d = choice(12);
  d.placement = Placement::stratified;
  BarSolver solver(flying_bar(12), d, step_of(0.5), 2);
  for (int i = 0; i < 60; ++i) solver.step();
  const BarSnapshot now = solver.snapshot();
  const double v = 0.5 * wave_speed(rubber, 1.1, density);
  for (std::size_t p = 0; p < now.x.size(); ++p) {
    BOOST_TEST(std::abs(now.velocity[p] - v) < 1e-11 * v);
    if (p > 0) BOOST_TEST(now.x[p - 1] <= now.x[p]);
  }
}

BOOST_AUTO_TEST_CASE(xpic_removes_the_noise_of_points) {
  // Velocities of alternating sign, which nodes hardly see.
  Bar bar = pulled_bar();
  bar.near_end = {};
  bar.initial_velocity = [](double x, double) {
    return std::lround(std::floor(4.0 * x)) % 2 == 0 ? 1.0 : -1.0;
  };
  const auto noise = [&](int xpic_order) {
    BarSolver solver(bar, choice(60), step_of(0.5, 1.0), xpic_order);
    solver.step();
    double sum = 0.0;
    for (const double v : solver.snapshot().velocity) sum += v * v;
    return sum;
  };
  BOOST_TEST(noise(2) < 0.05 * noise(0));
}

BOOST_AUTO_TEST_CASE(a_bar_that_turns_inside_out_is_a_breakdown) {
  Bar bar = pulled_bar();
  bar.law = LinearElastic{1e6};
  bar.initial_velocity = [](double x, double) { return -3000.0 * (x - 30.0); };
  BarSolver solver(bar, choice(60), step_of(0.5, 1.0));
  BOOST_CHECK_EXCEPTION(for (int i = 0; i < 3; ++i) solver.step(), BreakdownError,
                        [](const BreakdownError& error) {
                          return std::string(error.what()).find("stretch = -") != std::string::npos;
                        });
}

BOOST_AUTO_TEST_CASE(what_is_not_offered_is_refused) {
  const auto refused = [](const char* reason, auto&& change) {
    Bar bar = flying_bar(12);
    Discretization d = choice(12);
    double dt = step_of(0.5);
    int xpic = 0;
    change(bar, d, dt, xpic);
    BOOST_CHECK_EXCEPTION(BarSolver(bar, d, dt, xpic), std::invalid_argument,
                          [&](const std::invalid_argument& error) {
                            return std::string(error.what()).find(reason) != std::string::npos;
                          });
  };
  refused("mls", [](auto&, auto& d, auto&, auto&) { d.transfer = TransferName::shape; });
  refused("galerkin", [](auto&, auto& d, auto&, auto&) { d.scheme = Scheme::staggered4; });
  refused("adaptive", [](auto&, auto& d, auto&, auto&) { d.adaptive_support = true; });
  refused("empty elements", [](auto&, auto& d, auto&, auto&) { d.empty_elements = {3.0}; });
  refused("density", [](auto& bar, auto&, auto&, auto&) { bar.density = 0.0; });
  refused("held end", [](auto& bar, auto&, auto&, auto&) { bar.near_end.held = true; });
  refused("Courant", [](auto&, auto&, auto& dt, auto&) { dt *= 2.1; });
  refused("step", [](auto&, auto&, auto& dt, auto&) { dt = 0.0; });
  refused("XPIC", [](auto&, auto&, auto&, auto& xpic) { xpic = 11; });
  refused("stretch", [](auto& bar, auto&, auto&, auto&) {
    bar.initial_stretch = [](double) { return -0.5; };
  });
  refused("spacing", [](auto& bar, auto&, auto&, auto&) { bar.far = bar.near; });
}

BOOST_AUTO_TEST_SUITE_END()
