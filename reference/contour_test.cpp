#include "reference/contour.hpp"

#include <boost/test/unit_test.hpp>
#include <numbers>

#include "reference/random_problems.hpp"

using namespace porowave;
using namespace porowave::reference;

namespace {

bool encloses(const Ellipse& ellipse, Complex s) {
  const double x = (s.real() - ellipse.centre) / ellipse.real_axis;
  const double y = s.imag() == 0.0 ? 0.0 : s.imag() / ellipse.imaginary_axis;
  return x * x + y * y <= 1.0 + 1e-12;
}

/// Trapezoidal rule for (1/2 pi i) integral of e^(s t)/(s + 1) = e^(-t).
double error_with_nodes(const Ellipse& ellipse, int nodes, double t) {
  Complex sum = 0.0;
  for (int i = 0; i < nodes; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + 0.5) / nodes;
    const Complex s = ellipse.point(angle);
    sum += std::exp(s * t) / (s + 1.0) * ellipse.tangent(angle);
  }
  return std::abs(sum / Complex(0.0, nodes) - std::exp(-t));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(contour)

BOOST_AUTO_TEST_CASE(the_smallest_ellipse_encloses_cut_and_branch_points) {
  fixtures::RandomProblems random(1);
  for (int trial = 0; trial < 500; ++trial) {
    const WaveModes modes(
        random.next(1.0, Load(), NearEnd::drained_traction, FarEnd::half_space).material);
    const Ellipse smallest = enclosing_singularities(modes);
    BOOST_TEST(encloses(smallest, 0.0));
    BOOST_TEST(encloses(smallest, -modes.relaxation_rate()));
    BOOST_TEST(encloses(smallest, modes.branch_point()));
    const double distance = random.log_uniform(1e-6, 1e3) * smallest.real_axis;
    const double growth = growth_for_distance(smallest, distance);
    const Ellipse larger = grown(smallest, growth);
    BOOST_TEST(growth > 1.0);
    BOOST_TEST(encloses(larger, modes.branch_point()));
    BOOST_TEST(std::abs(larger.rightmost() - smallest.rightmost() - distance) <
               1e-12 * larger.rightmost() + 1e-12 * smallest.real_axis);
  }
}

BOOST_AUTO_TEST_CASE(the_trapezoidal_rule_converges_with_the_growth) {
  // The pole at -1 lies on the smallest ellipse: the error falls like growth^-nodes.
  const Ellipse smallest{-0.5, 0.5, 0.3};
  for (const double growth : {1.3, 1.6, 2.0}) {
    const Ellipse ellipse = grown(smallest, growth);
    const double coarse = error_with_nodes(ellipse, 16, 0.7);
    const double fine = error_with_nodes(ellipse, 32, 0.7);
    BOOST_TEST(fine < coarse);
    BOOST_TEST(std::abs(std::log(coarse / fine) / 16.0 / std::log(growth) - 1.0) < 0.05);
  }
  BOOST_TEST(error_with_nodes(grown(smallest, 2.0), 64, 0.7) < 1e-15);
}

BOOST_AUTO_TEST_SUITE_END()
