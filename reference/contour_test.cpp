#include "reference/contour.hpp"

#include <boost/test/unit_test.hpp>
#include <numbers>

#include "reference/random_problems.hpp"

using namespace porowave;
using namespace porowave::reference;

namespace {

/// On the ellipse counts as inside.
bool encloses(const Ellipse& ellipse, Complex s) {
  return grown(ellipse, 1e-12 * ellipse.real_axis).ellipse.encloses(s);
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
    const double distance = random.log_uniform(1e-9, 1e3) * smallest.real_axis;
    const auto [larger, log_growth] = grown(smallest, distance);
    BOOST_TEST(log_growth > 0.0);
    BOOST_TEST(larger.encloses(modes.branch_point()));
    BOOST_TEST(larger.rightmost == smallest.rightmost + distance);
    // Confocal: the difference of the squares of the axes stays.
    const double foci =
        smallest.real_axis * smallest.real_axis - smallest.imaginary_axis * smallest.imaginary_axis;
    BOOST_TEST(std::abs(larger.real_axis * larger.real_axis -
                        larger.imaginary_axis * larger.imaginary_axis - foci) <
               1e-12 * larger.real_axis * larger.real_axis);
  }
}

BOOST_AUTO_TEST_CASE(nodes_near_the_right_end_are_not_rounded_to_the_size_of_the_ellipse) {
  const Ellipse ellipse{1e-9, 1.0, 0.5};
  for (const double angle : {0.0, 1e-6, 1e-5}) {
    const double exact = 1e-9 - 0.5 * angle * angle * (1.0 - angle * angle / 12.0);
    BOOST_TEST(std::abs(ellipse.point(angle).real() - exact) < 1e-24);
  }
}

BOOST_AUTO_TEST_CASE(the_trapezoidal_rule_converges_with_the_growth) {
  // The pole at -1 lies on the smallest ellipse: the error falls like growth^-nodes.
  const Ellipse smallest{0.0, 0.5, 0.3};
  for (const double distance : {0.15, 0.3, 0.5}) {
    const auto [ellipse, log_growth] = grown(smallest, distance);
    const double coarse = error_with_nodes(ellipse, 16, 0.7);
    const double fine = error_with_nodes(ellipse, 32, 0.7);
    BOOST_TEST(fine < coarse);
    BOOST_TEST(std::abs(std::log(coarse / fine) / 16.0 / log_growth - 1.0) < 0.05);
  }
  BOOST_TEST(error_with_nodes(grown(smallest, 0.5).ellipse, 64, 0.7) < 1e-15);
}

BOOST_AUTO_TEST_SUITE_END()
