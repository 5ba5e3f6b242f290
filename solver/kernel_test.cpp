#include "solver/kernel.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string_view>
#include <tuple>
#include <vector>

#include "solver/kernels/kernel_skeleton.hpp"
#include "solver/test_points.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(kernel)

namespace {

using BSplines = std::tuple<BSpline1, BSpline2, BSpline3>;
using Wendlands = std::tuple<WendlandC2, WendlandC4, WendlandC6>;

// Power at which a kernel vanishes at the edge of its support; it is C^(power − 1) there.
template <class Kernel>
constexpr int edge_power();
template <>
constexpr int edge_power<KernelSkeleton>() {
  return 1;
}
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

// What is asserted of a kernel, as values: assertions are compiled once and not for every type.
struct Profile {
  std::string_view name;
  double (*value)(double) = nullptr;
  double (*derivative)(double) = nullptr;
  double natural_radius = 0.0;
  int edge_power = 0;
};

template <class... Kernel>
std::vector<Profile> profiles_of(std::tuple<Kernel...>) {
  return {{Kernel::name, &Kernel::value, &Kernel::derivative, Kernel::natural_radius,
           edge_power<Kernel>()}...};
}

// The file to copy is a kernel: what runs over the table runs with it.
std::vector<Profile> all_profiles() {
  return profiles_of(std::tuple_cat(std::tuple<KernelSkeleton>{}, Kernels{}));
}

// The same of a kernel's weight in Dim dimensions.
template <int Dim>
struct WeightFunctions {
  std::string_view name;
  Weight<Dim> (*weight)(const Vector<Dim>&, double) = nullptr;
  double (*value)(const Vector<Dim>&, double) = nullptr;
};

template <int Dim, class... Kernel>
std::vector<WeightFunctions<Dim>> weights_of(std::tuple<Kernel...>) {
  return {{Kernel::name, &weight<Kernel, Dim>, &weight_value<Kernel, Dim>}...};
}

// Central difference with an error of order step⁴.
template <class F>
double central_difference(F&& f, double x, double step) {
  return (8.0 * (f(x + step) - f(x - step)) - (f(x + 2 * step) - f(x - 2 * step))) / (12.0 * step);
}

BOOST_AUTO_TEST_CASE(is_non_negative_falls_and_ends_at_the_support) {
  for (const Profile& kernel : all_profiles()) {
    BOOST_TEST_CONTEXT(kernel.name) {
      for (int i = 0; i < 1000; ++i) {
        const double q = i / 1000.0;
        BOOST_TEST(kernel.value(q) > 0.0);
        BOOST_TEST(kernel.value(q + 1e-3) < kernel.value(q));
        BOOST_TEST(kernel.derivative(q) <= 0.0);
      }
      BOOST_TEST(kernel.value(1.0) == 0.0);
      BOOST_TEST(kernel.value(1.5) == 0.0);
      BOOST_TEST(kernel.derivative(1.0) == 0.0);
      BOOST_TEST(kernel.derivative(1.5) == 0.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(derivative_agrees_with_differences) {
  for (const Profile& kernel : all_profiles()) {
    for (int i = 1; i < 198; ++i) {
      const double q = (i + 0.37) / 200.0;  // the steps do not straddle a knot of a spline
      const double difference = central_difference(kernel.value, q, 1e-4);
      BOOST_TEST(std::abs(kernel.derivative(q) - difference) < 1e-9, kernel.name << " at " << q);
    }
  }
}

BOOST_AUTO_TEST_CASE(vanishes_at_the_edge_with_its_power) {
  for (const Profile& kernel : all_profiles()) {
    // value(1 − e) ~ C e^power, so halving e divides it by 2^power
    const double e = 1.0 / 512.0;
    const double power = std::log2(kernel.value(1.0 - e) / kernel.value(1.0 - 0.5 * e));
    BOOST_TEST(std::abs(power - kernel.edge_power) < 0.03, kernel.name);
  }
}

BOOST_AUTO_TEST_CASE(splines_are_a_partition_of_unity) {
  const std::vector<WeightFunctions<1>> splines = weights_of<1>(BSplines{});
  for (std::size_t k = 0; k < splines.size(); ++k) {
    const double radius = profiles_of(BSplines{})[k].natural_radius;
    for (int i = 0; i <= 100; ++i) {
      const double x = i / 100.0;
      double sum = 0.0;
      double slope = 0.0;
      for (int node = -3; node <= 4; ++node) {
        const auto w = splines[k].weight(Vector<1>(x - node), radius);
        sum += w.value;
        slope += w.gradient[0];
      }
      BOOST_TEST(std::abs(sum - 1.0) < 1e-15, splines[k].name << " at " << x);
      BOOST_TEST(std::abs(slope) < 1e-14, splines[k].name << " at " << x);
    }
  }
}

BOOST_AUTO_TEST_CASE(splines_join_smoothly_at_their_knots) {
  for (const Profile& kernel : profiles_of(BSplines{})) {
    for (double t = kernel.natural_radius - 1.0; t > 0.0; t -= 1.0) {
      const double q = t / kernel.natural_radius;
      const double e = 1e-12;
      BOOST_TEST(std::abs(kernel.value(q + e) - kernel.value(q - e)) < 1e-11, kernel.name);
      if (kernel.edge_power == 1) continue;
      BOOST_TEST(std::abs(kernel.derivative(q + e) - kernel.derivative(q - e)) < 1e-11,
                 kernel.name);
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
BOOST_AUTO_TEST_CASE(wendland_is_smooth_at_the_centre) {
  for (const Profile& kernel : profiles_of(Wendlands{})) {
    const int k = kernel.edge_power / 2 - 1;
    const int count = 3 * k + 3;
    Eigen::MatrixXd powers(count, count);
    Eigen::VectorXd values(count);
    for (int i = 0; i < count; ++i) {
      const double q = 0.5 - 0.5 * std::cos((i + 0.5) * std::acos(-1.0) / count);
      for (int j = 0; j < count; ++j) powers(i, j) = std::pow(q, j);
      values[i] = kernel.value(q);
    }
    const Eigen::VectorXd c = powers.colPivHouseholderQr().solve(values);
    BOOST_TEST(std::abs(c[0] - 1.0) < 1e-8, kernel.name);
    for (int j = 1; j <= 2 * k - 1; j += 2) {
      BOOST_TEST(std::abs(c[j]) < 1e-6 * c.cwiseAbs().sum(), kernel.name);
    }
    BOOST_TEST(std::abs(c[2]) > 1.0, kernel.name);  // the even ones do not vanish
  }
}

BOOST_AUTO_TEST_CASE(wendland_is_positive_definite_in_space) {
  const auto points = test::random_points<3>(60, 7);
  for (const WeightFunctions<3>& kernel : weights_of<3>(Wendlands{})) {
    Eigen::MatrixXd gram(60, 60);
    for (int i = 0; i < 60; ++i) {
      for (int j = 0; j < 60; ++j) {
        const auto a = static_cast<std::size_t>(i);
        const auto b = static_cast<std::size_t>(j);
        gram(i, j) = kernel.value(points[a] - points[b], 0.7);
      }
    }
    const Eigen::LLT<Eigen::MatrixXd> cholesky(gram);
    BOOST_TEST((cholesky.info() == Eigen::Success), kernel.name);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(weight_gradient_agrees_with_differences, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const double radius = 0.8;
  for (const WeightFunctions<Dim>& kernel : weights_of<Dim>(Kernels{})) {
    BOOST_TEST_CONTEXT(kernel.name) {
      for (const Vector<Dim>& r : test::random_points<Dim>(50, 3, -0.75, 0.75)) {
        const auto w = kernel.weight(r, radius);
        BOOST_TEST(w.value == kernel.value(r, radius));
        BOOST_TEST(w.value == kernel.value(-r, radius), boost::test_tools::tolerance(1e-15));
        for (int a = 0; a < Dim; ++a) {
          const auto along = [&](double s) {
            return kernel.value(r + s * Vector<Dim>::Unit(a), radius);
          };
          BOOST_TEST(std::abs(w.gradient[a] - central_difference(along, 0.0, 1e-5)) < 1e-8);
        }
      }
      const auto centre = kernel.weight(Vector<Dim>::Zero(), radius);
      BOOST_TEST(centre.gradient.norm() == 0.0);
      BOOST_TEST(std::isfinite(centre.value));
      const auto edge = kernel.weight(radius * Vector<Dim>::Unit(Dim - 1), radius);
      BOOST_TEST(edge.value == 0.0);
    }
  }
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

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
