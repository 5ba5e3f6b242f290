#include "reference/adaptive_integral.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

BOOST_AUTO_TEST_SUITE(adaptive_integral)

using namespace porowave::reference;

namespace {

/// Integral of a function without errors of its own.
template <class Function>
Bounded integral(Function&& f, const std::vector<double>& ends) {
  return porowave::reference::adaptive_integral([&](double t) { return Bounded{f(t), 0.0}; }, ends);
}

void check(const Bounded& integral, double expected) {
  BOOST_TEST(std::abs(integral.value - expected) <= integral.error);
  BOOST_TEST(integral.error < 2e-13 * std::abs(expected));
}

}  // namespace

BOOST_AUTO_TEST_CASE(known_integrals_are_found_within_their_errors) {
  check(integral([](double t) { return std::exp(t); }, {0.0, 1.0}), std::numbers::e - 1.0);
  check(integral([](double t) { return 1.0 / std::sqrt(t - 2.0); }, {2.0, 6.0}), 4.0);
  check(integral([](double t) { return t < 0.3 ? 2.0 : std::sqrt(t - 0.3); }, {0.0, 0.3, 1.3}),
        0.6 + 2.0 / 3.0);
  // A layer a million times thinner than the piece, and a front in its middle.
  check(integral([](double t) { return std::exp(-1e6 * t); }, {0.0, 1.0}), 1e-6);
  check(integral([](double t) { return 1.0 + std::tanh(1e4 * (t - 0.37)); }, {0.0, 1.0}), 1.26);
}

BOOST_AUTO_TEST_CASE(errors_of_the_values_enter) {
  const std::vector<double> ends = {1.0, 3.0};
  const Bounded rough = porowave::reference::adaptive_integral(
      [](double t) {
        return Bounded{t, 1e-3};
      },
      ends);
  BOOST_TEST(std::abs(rough.value - 4.0) < 1e-12);
  BOOST_TEST(rough.error > 2e-3);
  BOOST_TEST(rough.error < 1e-2);
  const auto lost = integral([](double) { return std::numeric_limits<double>::quiet_NaN(); }, ends);
  BOOST_TEST(std::isinf(lost.error));
}

BOOST_AUTO_TEST_CASE(rounding_of_the_values_is_not_chased) {
  int calls = 0;
  const std::vector<double> ends = {0.0, 1.0};
  const auto noisy = [&](double t) {
    ++calls;
    return Bounded{t + 1e-7 * std::sin(1e9 * t), 1e-7};
  };
  const Bounded found = porowave::reference::adaptive_integral(noisy, ends);
  BOOST_TEST(std::abs(found.value - 0.5) <= found.error);
  BOOST_TEST(calls < 200);
}

BOOST_AUTO_TEST_CASE(nothing_is_integrated_without_an_interval) {
  const std::vector<double> ends = {1.0};
  const Bounded none = integral([](double t) { return t; }, ends);
  BOOST_TEST(none.value == 0.0);
  BOOST_TEST(none.error == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
