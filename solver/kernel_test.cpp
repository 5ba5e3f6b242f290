#include "solver/kernel.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "solver/kernels/kernel_skeleton.hpp"
#include "solver/test_points.hpp"

namespace porowave::solver {
namespace {

using BSplines = std::tuple<BSpline1, BSpline2, BSpline3>;
using Wendlands = std::tuple<WendlandC2, WendlandC4, WendlandC6>;

// Power at which a kernel vanishes at the edge of its support; it is C^(power − 1) there.
template <class Kernel>
constexpr int edge_power();
template <>
constexpr int edge_power<BSpline1>() {
  return 1;
}
template <>
constexpr int edge_power<BSpline2>() {
  return 2;
}
template <>
constexpr int edge_power<BSpline3>() {
  return 3;
}
template <>
constexpr int edge_power<WendlandC2>() {
  return 4;
}
template <>
constexpr int edge_power<WendlandC4>() {
  return 6;
}
template <>
constexpr int edge_power<WendlandC6>() {
  return 8;
}

// The file to copy is a kernel: what runs over the table runs with it.
using KernelsAndSkeleton =
    std::tuple<KernelSkeleton, BSpline1, BSpline2, BSpline3, WendlandC2, WendlandC4, WendlandC6>;

// Central difference with an error of order step⁴.
template <class F>
double central_difference(F&& f, double x, double step) {
  return (8.0 * (f(x + step) - f(x - step)) - (f(x + 2 * step) - f(x - 2 * step))) / (12.0 * step);
}

BOOST_AUTO_TEST_SUITE(kernel)

BOOST_AUTO_TEST_CASE_TEMPLATE(is_non_negative_falls_and_ends_at_the_support, Kernel,
                              KernelsAndSkeleton) {
  for (int i = 0; i < 1000; ++i) {
    const double q = i / 1000.0;
    BOOST_TEST(Kernel::value(q) > 0.0);
    BOOST_TEST(Kernel::value(q + 1e-3) < Kernel::value(q));
    BOOST_TEST(Kernel::derivative(q) <= 0.0);
  }
  BOOST_TEST(Kernel::value(1.0) == 0.0);
  BOOST_TEST(Kernel::value(1.5) == 0.0);
  BOOST_TEST(Kernel::derivative(1.0) == 0.0);
  BOOST_TEST(Kernel::derivative(1.5) == 0.0);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(derivative_agrees_with_differences, Kernel, KernelsAndSkeleton) {
  for (int i = 1; i < 200; ++i) {
    const double q = (i + 0.37) / 200.0;  // the steps do not straddle a knot of a spline
    if (q > 0.99) break;
    const double difference = central_difference(Kernel::value, q, 1e-4);
    BOOST_TEST(std::abs(Kernel::derivative(q) - difference) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(vanishes_at_the_edge_with_its_power, Kernel, Kernels) {
  // value(1 − e) ~ C e^power, so halving e divides it by 2^power
  const double e = 1.0 / 512.0;
  const double power = std::log2(Kernel::value(1.0 - e) / Kernel::value(1.0 - 0.5 * e));
  BOOST_TEST(std::abs(power - edge_power<Kernel>()) < 0.03);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(splines_are_a_partition_of_unity, Kernel, BSplines) {
  const double radius = Kernel::natural_radius;
  for (int i = 0; i <= 100; ++i) {
    const double x = i / 100.0;
    double sum = 0.0;
    double slope = 0.0;
    for (int node = -3; node <= 4; ++node) {
      const auto w = weight<Kernel, 1>(Vector<1>(x - node), radius);
      sum += w.value;
      slope += w.gradient[0];
    }
    BOOST_TEST(std::abs(sum - 1.0) < 1e-15);
    BOOST_TEST(std::abs(slope) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(splines_join_smoothly_at_their_knots, Kernel, BSplines) {
  const double order = edge_power<Kernel>();
  for (double t = Kernel::natural_radius - 1.0; t > 0.0; t -= 1.0) {
    const double q = t / Kernel::natural_radius;
    const double e = 1e-12;
    BOOST_TEST(std::abs(Kernel::value(q + e) - Kernel::value(q - e)) < 1e-11);
    if (order > 1) {
      BOOST_TEST(std::abs(Kernel::derivative(q + e) - Kernel::derivative(q - e)) < 1e-11);
    }
  }
}

BOOST_AUTO_TEST_CASE(splines_have_the_known_values_at_nodes) {
  static_assert(BSpline1::value(0.0) == 1.0);
  static_assert(BSpline2::value(0.0) == 0.75);
  BOOST_TEST(std::abs(BSpline2::value(1.0 / 1.5) - 1.0 / 8.0) < 1e-15);
  BOOST_TEST(std::abs(BSpline3::value(0.0) - 2.0 / 3.0) < 1e-15);
  BOOST_TEST(std::abs(BSpline3::value(0.5) - 1.0 / 6.0) < 1e-15);
}

// Wendland's construction: with smoothness C^2k, φ is a polynomial of degree 3k + 2 whose odd
// coefficients up to 2k − 1 vanish, which makes φ(|r|) smooth at the centre.
BOOST_AUTO_TEST_CASE_TEMPLATE(wendland_is_smooth_at_the_centre, Kernel, Wendlands) {
  constexpr int k = edge_power<Kernel>() / 2 - 1;
  constexpr int count = 3 * k + 3;
  Eigen::Matrix<double, count, count> powers;
  Eigen::Matrix<double, count, 1> values;
  for (int i = 0; i < count; ++i) {
    const double q = 0.5 - 0.5 * std::cos((i + 0.5) * std::acos(-1.0) / count);
    for (int j = 0; j < count; ++j) powers(i, j) = std::pow(q, j);
    values[i] = Kernel::value(q);
  }
  const Eigen::Matrix<double, count, 1> c = powers.colPivHouseholderQr().solve(values);
  BOOST_TEST(std::abs(c[0] - 1.0) < 1e-8);
  for (int j = 1; j <= 2 * k - 1; j += 2) BOOST_TEST(std::abs(c[j]) < 1e-6 * c.cwiseAbs().sum());
  BOOST_TEST(std::abs(c[2]) > 1.0);  // the even ones do not vanish
}

BOOST_AUTO_TEST_CASE_TEMPLATE(wendland_is_positive_definite_in_space, Kernel, Wendlands) {
  const auto points = test::random_points<3>(60, 7);
  Eigen::MatrixXd gram(60, 60);
  for (int i = 0; i < 60; ++i) {
    for (int j = 0; j < 60; ++j) {
      const auto a = static_cast<std::size_t>(i);
      const auto b = static_cast<std::size_t>(j);
      gram(i, j) = weight_value<Kernel, 3>(points[a] - points[b], 0.7);
    }
  }
  const Eigen::LLT<Eigen::MatrixXd> cholesky(gram);
  BOOST_TEST((cholesky.info() == Eigen::Success));
}

template <class Kernel, int Dim>
void check_weight() {
  const double radius = 0.8;
  for (const Vector<Dim>& r : test::random_points<Dim>(50, 3, -0.75, 0.75)) {
    const auto w = weight<Kernel, Dim>(r, radius);
    BOOST_TEST(w.value == (weight_value<Kernel, Dim>(r, radius)));
    BOOST_TEST(w.value == (weight_value<Kernel, Dim>(-r, radius)),
               boost::test_tools::tolerance(1e-15));
    for (int a = 0; a < Dim; ++a) {
      const auto along = [&](double s) {
        return weight_value<Kernel, Dim>(r + s * Vector<Dim>::Unit(a), radius);
      };
      BOOST_TEST(std::abs(w.gradient[a] - central_difference(along, 0.0, 1e-5)) < 1e-8);
    }
  }
  const auto centre = weight<Kernel, Dim>(Vector<Dim>::Zero(), radius);
  BOOST_TEST(centre.gradient.norm() == 0.0);
  BOOST_TEST(std::isfinite(centre.value));
  const auto edge = weight<Kernel, Dim>(radius * Vector<Dim>::Unit(Dim - 1), radius);
  BOOST_TEST(edge.value == 0.0);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(weight_gradient_agrees_with_differences, Kernel, Kernels) {
  check_weight<Kernel, 1>();
  check_weight<Kernel, 2>();
  check_weight<Kernel, 3>();
}

BOOST_AUTO_TEST_CASE(radial_kernels_see_the_distance_and_splines_the_axes) {
  const Vector<2> diagonal(0.8, 0.8);
  BOOST_TEST((weight_value<WendlandC2, 2>(diagonal, 1.0)) == 0.0);
  BOOST_TEST((weight_value<BSpline1, 2>(diagonal, 1.0)) == 0.04,
             boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(names_lead_to_the_kernel_and_back) {
  BOOST_TEST(kernel_names().size() == kernel_count);
  for (const std::string_view name : kernel_names()) {
    const auto found = kernel_from_name(name);
    BOOST_REQUIRE(found.has_value());
    BOOST_TEST(to_string(*found) == name);
  }
  BOOST_TEST(!kernel_from_name("bspline").has_value());
  BOOST_TEST(!kernel_from_name("").has_value());
  static_assert(kernel_from_name("wendland_c4") == kernel_name<WendlandC4>);
  static_assert(natural_radius(kernel_name<BSpline2>) == 1.5);
  static_assert(to_string(kernel_name<BSpline1>) == "bspline1");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace porowave::solver
