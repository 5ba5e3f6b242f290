// The manufactured bar without any solver: momentum balance and kinematics by difference quotients
// of the motion itself.

#include "verification/manufactured/bar_motion.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>

BOOST_AUTO_TEST_SUITE(bar_motion)

using namespace porowave;
using namespace porowave::verification;

namespace {

BarMotion motion() {
  return {2.0, 0.05, 1200.0, solver::NeoHookean{3e5, 4e5}, 0.2, 0.05, -0.1, 0.07};
}

/// Central difference quotient of fourth order.
template <class F>
double slope(F&& f, double at, double step) {
  return (8.0 * (f(at + step) - f(at - step)) - (f(at + 2 * step) - f(at - 2 * step))) /
         (12.0 * step);
}

const std::array<double, 4> places{0.1, 0.63, 1.2, 1.9};
const std::array<double, 3> times{0.004, 0.021, 0.043};

}  // namespace

BOOST_AUTO_TEST_CASE(it_starts_undeformed_and_at_rest) {
  const BarMotion m = motion();
  for (const double X : places) {
    BOOST_TEST(m.place(X, 0.0) == X);
    BOOST_TEST(m.deformation(X, 0.0) == 1.0);
    BOOST_TEST(m.velocity(X, 0.0) == 0.0);
    BOOST_TEST(m.stress(X, 0.0) == 0.0);
  }
}

BOOST_AUTO_TEST_CASE(kinematics_are_derivatives_of_the_place) {
  const BarMotion m = motion();
  for (const double X : places) {
    for (const double t : times) {
      const auto in_time = [&](auto&& f) { return slope(f, t, 1e-5); };
      const auto in_place = [&](auto&& f) { return slope(f, X, 1e-4); };
      const double F = in_place([&](double Y) { return m.place(Y, t); });
      const double v = in_time([&](double s) { return m.place(X, s); });
      BOOST_TEST(std::abs(m.deformation(X, t) - F) < 1e-9);
      BOOST_TEST(std::abs(m.velocity(X, t) - v) < 1e-8 * m.length / m.duration);
    }
  }
}

BOOST_AUTO_TEST_CASE(momentum_is_balanced) {
  // ρ (∂v/∂t + v ∂v/∂x) = ∂σ/∂x + b in the fixed frame, from v(x, t) and σ(F(x, t)) alone, with
  // F = 1/(∂X/∂x) and X from the inverse of the motion.
  const BarMotion m = motion();
  const solver::NeoHookean law{3e5, 4e5};
  const auto velocity = [&](double x, double t) { return m.velocity(m.undeformed_place(x, t), t); };
  const auto stretch = [&](double x, double t) {
    return 1.0 / slope([&](double y) { return m.undeformed_place(y, t); }, x, 1e-3);
  };
  const double scale = 1e6 / m.length;
  for (const double X : places) {
    for (const double t : times) {
      const double x = m.place(X, t);
      const double v = velocity(x, t);
      const double rate = slope([&](double s) { return velocity(x, s); }, t, 1e-5);
      const double gradient = slope([&](double y) { return velocity(y, t); }, x, 1e-3);
      const double push = slope([&](double y) { return law.stress(stretch(y, t)); }, x, 4e-3);
      const double b = m.density / stretch(x, t) * (rate + v * gradient) - push;
      BOOST_TEST(std::abs(m.body_force(X, t) - b) < 1e-6 * scale);
      BOOST_TEST(std::abs(m.bar(false).body_force(x, t) - b) < 1e-6 * scale);
    }
  }
}

BOOST_AUTO_TEST_CASE(places_are_found_back) {
  const BarMotion m = motion();
  for (const double X : {-0.02, 0.0, 0.1, 0.63, 1.2, 1.9, 2.0, 2.02}) {
    for (const double t : {-1e-4, 0.0, 0.02, 0.05}) {
      BOOST_TEST(std::abs(m.undeformed_place(m.place(X, t), t) - X) < 1e-14 * m.length);
    }
  }
}

BOOST_AUTO_TEST_CASE(ends_are_held_or_carry_the_stress_of_the_solution) {
  const BarMotion m = motion();
  const solver::Bar loaded = m.bar(false);
  BOOST_TEST(!loaded.near_end.held);
  BOOST_TEST(loaded.near_end.stress(0.02) == m.stress(0.0, 0.02));
  BOOST_TEST(loaded.far_end.stress(0.02) == m.stress(m.length, 0.02));
  BOOST_TEST(m.stress(0.0, 0.02) != m.stress(m.length, 0.02));
  BarMotion between = m;
  between.shift = between.stretch = between.wave = 0.0;
  BOOST_TEST(between.bar(true).far_end.held);
  BOOST_TEST(std::abs(between.place(m.length, 0.02) - m.length) < 1e-15);
  BOOST_CHECK_THROW(m.bar(true), std::invalid_argument);  // its ends move
}

BOOST_AUTO_TEST_CASE(the_fastest_wave_bounds_all) {
  const BarMotion m = motion();
  const double fastest = m.fastest_wave();
  for (const double X : places) {
    for (const double t : times) {
      BOOST_TEST(solver::wave_speed(m.law, m.deformation(X, t), m.density) <= fastest * 1.001);
    }
  }
  BOOST_TEST(fastest < 2.0 * solver::wave_speed(m.law, 1.0, m.density));
}

BOOST_AUTO_TEST_SUITE_END()
