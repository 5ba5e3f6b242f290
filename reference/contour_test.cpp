#include "reference/contour.hpp"

#include <boost/test/unit_test.hpp>
#include <numbers>

#include "reference/random_problems.hpp"

BOOST_AUTO_TEST_SUITE(contour)

using namespace porowave;
using namespace porowave::reference;

namespace {

/// Trapezoidal rule with step h for (1/2 pi i) integral of e^(s t)/(s + 1) = e^(-t).
double error_with_step(const Hyperbola& contour, double h, double t) {
  Complex sum = 0.0;
  for (int j = -400; j <= 400; ++j) {
    const Complex s = contour.point(j * h);
    sum += std::exp(s * t) / (s + 1.0) * contour.tangent(j * h);
  }
  return std::abs(sum * h / Complex(0.0, 2.0 * std::numbers::pi) - std::exp(-t));
}

}  // namespace

BOOST_AUTO_TEST_CASE(its_right_end_and_its_angle_are_those_asked_for) {
  const Hyperbola contour = hyperbola_through(2.0, 5.0, 0.4);
  BOOST_TEST(contour.rightmost() == 5.0, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(std::abs(contour.point(0.0) - 5.0) < 1e-14);
  const Complex direction = contour.point(31.0) - contour.point(30.0);
  BOOST_TEST(std::arg(direction) == 0.5 * std::numbers::pi + 0.4,
             boost::test_tools::tolerance(1e-12));
  for (const double u : {-2.0, 0.0, 0.7, 3.0}) {
    const Complex quotient = (contour.point(u + 1e-5) - contour.point(u - 1e-5)) / 2e-5;
    BOOST_TEST(std::abs(quotient - contour.tangent(u)) < 1e-8 * std::abs(quotient));
  }
}

BOOST_AUTO_TEST_CASE(clearance_is_by_how_much_it_may_be_opened) {
  fixtures::RandomProblems random(1);
  for (int trial = 0; trial < 300; ++trial) {
    const Hyperbola contour{random.uniform(-1, 1), random.log_uniform(1e-3, 1e3),
                            random.uniform(0.05, 1.2)};
    const Complex s(random.uniform(-3, 3), random.uniform(0.01, 3));
    const double clearance = contour.clearance(s);
    const Hyperbola opened{contour.shift, contour.scale, contour.angle + clearance};
    // The opened hyperbola runs through s: at the u where its imaginary part is that of s.
    const double u = std::asinh(s.imag() / (opened.scale * std::cos(opened.angle)));
    BOOST_TEST(std::abs(opened.point(u) - s) < 1e-9 * (1.0 + std::abs(s) + opened.scale));
    // Inside is to the left.
    const double level = std::asinh(s.imag() / (contour.scale * std::cos(contour.angle)));
    BOOST_TEST((clearance > 0.0) == (s.real() < contour.point(level).real()));
  }
}

BOOST_AUTO_TEST_CASE(the_trapezoidal_rule_converges_at_the_rate_of_the_clearance) {
  // 1/(s + 1): the pole limits the strip to its clearance, pi/2 - angle; error ~ e^(-2 pi d/h).
  const Hyperbola contour{0.0, 0.4, 1.1};
  const double strip = contour.clearance(-1.0);
  BOOST_TEST(strip == 0.5 * std::numbers::pi - 1.1, boost::test_tools::tolerance(1e-12));
  const double h = 0.4;
  const double coarse = error_with_step(contour, h, 0.2);
  const double fine = error_with_step(contour, 0.5 * h, 0.2);
  const double rate = std::log(coarse / fine) / (2.0 * std::numbers::pi * strip / h);
  BOOST_TEST(rate == 1.0, boost::test_tools::tolerance(0.1));
  BOOST_TEST(error_with_step(contour, 0.05, 0.2) < 1e-14);
}

BOOST_AUTO_TEST_SUITE_END()
