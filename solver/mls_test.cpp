#include "solver/mls.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "solver/test_points.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(mls)

namespace {

template <int Dim>
struct Shape {
  MlsResult result;
  std::vector<double> phi;
  std::vector<Vector<Dim>> gradients;
};

template <class Kernel, int Dim, int Order>
Shape<Dim> shape_at(const Vector<Dim>& x, const std::vector<Vector<Dim>>& points, double radius) {
  Shape<Dim> s{{}, std::vector<double>(points.size()), std::vector<Vector<Dim>>(points.size())};
  const MovingLeastSquares<Kernel, Dim, Order> mls(radius);
  s.result = mls.evaluate(x, points, s.phi, s.gradients);
  return s;
}

// The overload without gradients.
template <class Kernel, int Dim, int Order>
MlsResult values_at(const Vector<Dim>& x, const std::vector<Vector<Dim>>& points, double radius,
                    std::vector<double>& phi) {
  return MovingLeastSquares<Kernel, Dim, Order>(radius).evaluate(x, points, phi);
}

constexpr double radius = 0.45;

// Monomial j of x about `centre`, in units of the radius.
template <int Dim, int Order>
double monomial(int j, const Vector<Dim>& x, const Vector<Dim>& centre) {
  return PolynomialBasis<Dim, Order>::at((x - centre) / radius)[j];
}

// A kernel and an order, chosen while running: assertions are compiled once a dimension.
template <int Dim>
struct Method {
  int order = 0;
  int size = 0;  // of the basis
  Shape<Dim> (*shape_at)(const Vector<Dim>&, const std::vector<Vector<Dim>>&, double) = nullptr;
  MlsResult (*values_at)(const Vector<Dim>&, const std::vector<Vector<Dim>>&, double,
                         std::vector<double>&) = nullptr;
  double (*monomial)(int, const Vector<Dim>&, const Vector<Dim>&) = nullptr;
};

template <class Kernel, int Dim, int Order>
Method<Dim> method_of() {
  return {Order, PolynomialBasis<Dim, Order>::size, &shape_at<Kernel, Dim, Order>,
          &values_at<Kernel, Dim, Order>, &monomial<Dim, Order>};
}

// Kernels of both kinds and every order.
template <int Dim>
std::vector<Method<Dim>> methods() {
  return {method_of<BSpline2, Dim, 0>(),   method_of<BSpline1, Dim, 1>(),
          method_of<WendlandC2, Dim, 1>(), method_of<BSpline3, Dim, 2>(),
          method_of<WendlandC4, Dim, 2>(), method_of<WendlandC2, Dim, 3>()};
}

// Enough points for the cubic basis inside a support of radius 0.45: 30, 300, 1000.
template <int Dim>
std::vector<Vector<Dim>> cloud() {
  return test::random_points<Dim>(Dim == 1 ? 30 : Dim == 2 ? 300 : 1000, 21);
}

// Evaluation points inside, and one on the corner of the cloud.
template <int Dim>
std::vector<Vector<Dim>> places() {
  auto x = test::random_points<Dim>(6, 22);
  x.push_back(Vector<Dim>::Constant(0.02));
  return x;
}

BOOST_AUTO_TEST_CASE_TEMPLATE(basis_is_complete_and_graded, D, test::Dimensions) {
  constexpr int Dim = D::value;
  using Basis = PolynomialBasis<Dim, 3>;
  static_assert(Basis::size == (Dim == 1 ? 4 : Dim == 2 ? 10 : 20));
  // distinct primes as coordinates: distinct monomials have distinct values
  const Vector<3> primes(2.0, 3.0, 5.0);
  typename Basis::Values p = Basis::at(primes.head<Dim>());
  for (int j = 0; j < Basis::size; ++j) {
    BOOST_TEST((j < Basis::size_up_to(Basis::monomials[static_cast<std::size_t>(j)].degree)));
  }
  std::sort(p.begin(), p.end());
  BOOST_TEST((std::adjacent_find(p.begin(), p.end()) == p.end()));
  BOOST_TEST(p[Basis::size - 1] == std::pow(primes[Dim - 1], 3));
}

// The defining property: Σ Φ_p q(x_p) = q(x) for every monomial q of degree <= order. The monomials
// are centred away from x, so that this is not one moment alone. Order 0: partition of unity.
BOOST_AUTO_TEST_CASE_TEMPLATE(reproduces_every_polynomial_of_its_degree, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto points = cloud<Dim>();
  const Vector<Dim> centre = Vector<Dim>::Constant(0.4);
  for (const Method<Dim>& method : methods<Dim>()) {
    for (const Vector<Dim>& x : places<Dim>()) {
      const auto s = method.shape_at(x, points, radius);
      BOOST_TEST(s.result.order_used == method.order);
      for (int j = 0; j < method.size; ++j) {
        double value = 0.0;
        double size = 1.0;  // of the sum's terms, for the rounding
        Vector<Dim> slope = Vector<Dim>::Zero();
        for (std::size_t p = 0; p < points.size(); ++p) {
          value += s.phi[p] * method.monomial(j, points[p], centre);
          size += std::abs(s.phi[p] * method.monomial(j, points[p], centre));
          slope += s.gradients[p] * method.monomial(j, points[p], centre);
        }
        BOOST_TEST(std::abs(value - method.monomial(j, x, centre)) < 1e-12 * size);
        for (int a = 0; a < Dim; ++a) {
          const Vector<Dim> e = 1e-5 * Vector<Dim>::Unit(a);
          const double exact =
              (method.monomial(j, x + e, centre) - method.monomial(j, x - e, centre)) / 2e-5;
          BOOST_TEST(std::abs(slope[a] - exact) < 2e-8);
        }
      }
    }
  }
}

// The moments about x itself: Σ Φ_p ξ_p^j is 1 for the constant and 0 for all others.
BOOST_AUTO_TEST_CASE_TEMPLATE(moments_about_the_evaluation_point_are_kronecker, D,
                              test::Dimensions) {
  constexpr int Dim = D::value;
  const auto points = cloud<Dim>();
  for (const Method<Dim>& method : methods<Dim>()) {
    for (const Vector<Dim>& x : places<Dim>()) {
      const auto s = method.shape_at(x, points, radius);
      for (int j = 0; j < method.size; ++j) {
        double moment = 0.0;
        for (std::size_t p = 0; p < points.size(); ++p) {
          moment += s.phi[p] * method.monomial(j, points[p], x);
        }
        BOOST_TEST(std::abs(moment - (j == 0 ? 1.0 : 0.0)) < 1e-12);
      }
    }
  }
}

// The other half of the definition: among all reproducing values, MLS has the least Σ Φ²/w.
// So it must not reproduce a polynomial of higher degree (on points without symmetry).
BOOST_AUTO_TEST_CASE_TEMPLATE(minimises_the_weighted_norm, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto points = cloud<Dim>();
  const Vector<Dim> x = Vector<Dim>::Constant(0.37);
  const auto low = shape_at<BSpline2, Dim, 1>(x, points, radius);
  const auto high = shape_at<BSpline2, Dim, 2>(x, points, radius);
  // high reproduces degree 1 as well, so high − low must be orthogonal to low: Σ low (high − low)/w
  double product = 0.0;
  double difference = 0.0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double w = weight_value<BSpline2, Dim>(points[p] - x, radius);
    if (!(w > 0.0)) continue;
    product += low.phi[p] * (high.phi[p] - low.phi[p]) / w;
    difference += std::abs(high.phi[p] - low.phi[p]);
  }
  BOOST_TEST(std::abs(product) < 1e-12);
  BOOST_TEST(difference > 1e-3);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(gradient_agrees_with_differences, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto points = cloud<Dim>();
  const double step = 1e-6;  // so short that no point crosses a kink of bspline1
  for (const Method<Dim>& method : methods<Dim>()) {
    for (const Vector<Dim>& x : places<Dim>()) {
      const auto s = method.shape_at(x, points, radius);
      for (int a = 0; a < Dim; ++a) {
        const Vector<Dim> e = step * Vector<Dim>::Unit(a);
        const auto up = method.shape_at(x + e, points, radius);
        const auto down = method.shape_at(x - e, points, radius);
        for (std::size_t p = 0; p < points.size(); ++p) {
          const double difference = (up.phi[p] - down.phi[p]) / (2.0 * step);
          BOOST_TEST(std::abs(s.gradients[p][a] - difference) < 1e-5);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(both_overloads_give_the_same_values, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto points = cloud<Dim>();
  for (const Method<Dim>& method : methods<Dim>()) {
    for (const Vector<Dim>& x : places<Dim>()) {
      const auto s = method.shape_at(x, points, radius);
      std::vector<double> phi(points.size(), -7.0);
      const MlsResult result = method.values_at(x, points, radius, phi);
      BOOST_TEST(result.order_used == s.result.order_used);
      for (std::size_t p = 0; p < points.size(); ++p)
        BOOST_TEST(std::abs(phi[p] - s.phi[p]) < 1e-13);
    }
  }
}

// Another origin and another unit of length change neither Φ nor the decision about the order.
BOOST_AUTO_TEST_CASE_TEMPLATE(is_invariant_under_translation_and_unit, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto points = cloud<Dim>();
  for (const double unit : {1e-6, 1e6}) {
    auto moved = points;
    const Vector<Dim> shift = Vector<Dim>::Constant(3.0);
    for (Vector<Dim>& x : moved) x = unit * (x + shift);
    for (const Method<Dim>& method : methods<Dim>()) {
      for (const Vector<Dim>& x : places<Dim>()) {
        const auto s = method.shape_at(x, points, radius);
        const auto t = method.shape_at(unit * (x + shift), moved, unit * radius);
        BOOST_TEST(s.result.order_used == t.result.order_used);
        BOOST_TEST(std::abs(s.result.condition / t.result.condition - 1.0) < 1e-9);
        for (std::size_t p = 0; p < points.size(); ++p) {
          BOOST_TEST(std::abs(s.phi[p] - t.phi[p]) < 1e-10);
          BOOST_TEST((s.gradients[p] - unit * t.gradients[p]).norm() < 1e-8);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(permuting_the_points_permutes_the_values, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto points = cloud<Dim>();
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), std::mt19937(4));
  std::vector<Vector<Dim>> shuffled;
  for (const std::size_t p : order) shuffled.push_back(points[p]);
  for (const Method<Dim>& method : methods<Dim>()) {
    const Vector<Dim> x = Vector<Dim>::Constant(0.3);
    const auto s = method.shape_at(x, points, radius);
    const auto t = method.shape_at(x, shuffled, radius);
    for (std::size_t k = 0; k < order.size(); ++k) {
      BOOST_TEST(std::abs(t.phi[k] - s.phi[order[k]]) < 1e-12);
    }
  }
}

// Points on a line in two dimensions carry no complete basis of degree >= 1, wherever x is.
BOOST_AUTO_TEST_CASE(falls_back_on_collinear_points) {
  std::vector<Vector<2>> points;
  for (int i = 0; i < 20; ++i) points.emplace_back(0.05 * i, 0.1 + 0.7 * 0.05 * i);
  for (const double off : {0.0, 0.05}) {
    const Vector<2> x(0.43, 0.1 + 0.7 * 0.43 + off);
    const auto s = shape_at<BSpline2, 2, 2>(x, points, 0.4);
    BOOST_TEST(s.result.order_used == 0);
    BOOST_TEST(s.result.condition == 1.0);
    BOOST_TEST(std::abs(std::accumulate(s.phi.begin(), s.phi.end(), 0.0) - 1.0) < 1e-14);
    for (const double phi : s.phi) BOOST_TEST(phi >= 0.0);
  }
}

// Two lines carry degree 1 but not degree 2, and then order 1 is what comes out.
BOOST_AUTO_TEST_CASE(falls_back_by_one_degree_only) {
  std::vector<Vector<2>> points;
  for (int i = 0; i < 20; ++i) {
    points.emplace_back(0.05 * i, 0.4);
    points.emplace_back(0.05 * i + 0.01, 0.6);
  }
  const Vector<2> x(0.43, 0.47);
  const auto s = shape_at<BSpline2, 2, 2>(x, points, 0.4);
  const auto linear = shape_at<BSpline2, 2, 1>(x, points, 0.4);
  BOOST_TEST(s.result.order_used == 1);
  BOOST_TEST(s.result.condition == linear.result.condition);
  for (std::size_t p = 0; p < points.size(); ++p) {
    BOOST_TEST(std::abs(s.phi[p] - linear.phi[p]) < 1e-14);
    BOOST_TEST((s.gradients[p] - linear.gradients[p]).norm() < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(few_points_carry_a_low_degree, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const Vector<Dim> x = Vector<Dim>::Constant(0.5);
  const std::vector<Vector<Dim>> single{Vector<Dim>::Constant(0.55)};
  const std::vector<Vector<Dim>> at_x{x};
  const std::vector<Vector<Dim>> coincident(5, Vector<Dim>::Constant(0.45));
  for (const Method<Dim>& method : methods<Dim>()) {
    for (const auto& points : {single, at_x, coincident}) {
      const auto s = method.shape_at(x, points, radius);
      BOOST_TEST(s.result.order_used == 0);
      for (std::size_t p = 0; p < points.size(); ++p) {
        BOOST_TEST(std::abs(s.phi[p] * static_cast<double>(points.size()) - 1.0) < 1e-14);
        BOOST_TEST(s.gradients[p].norm() < 1e-12);
      }
    }
  }
}

// n + 1 distinct points on a line carry degree n and no more; the values are Lagrange's.
BOOST_AUTO_TEST_CASE(as_many_points_as_coefficients_interpolate) {
  const std::vector<Vector<1>> points{Vector<1>(0.2), Vector<1>(0.5), Vector<1>(0.6)};
  const auto s = shape_at<WendlandC2, 1, 3>(Vector<1>(0.4), points, radius);
  BOOST_TEST(s.result.order_used == 2);
  BOOST_TEST(std::abs(s.phi[0] - 1.0 / 6.0) < 1e-12);
  BOOST_TEST(std::abs(s.phi[1] - 4.0 / 3.0) < 1e-12);
  BOOST_TEST(std::abs(s.phi[2] + 1.0 / 2.0) < 1e-12);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(without_weight_there_is_no_value, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const Vector<Dim> x = Vector<Dim>::Zero();
  const std::vector<Vector<Dim>> outside{Vector<Dim>::Constant(radius), Vector<Dim>::Constant(9.0)};
  for (const Method<Dim>& method : methods<Dim>()) {
    for (const auto& points : {std::vector<Vector<Dim>>{}, outside}) {
      const auto s = method.shape_at(x, points, radius);
      BOOST_TEST(s.result.order_used == -1);
      BOOST_TEST(s.result.condition == 0.0);
      for (const double phi : s.phi) BOOST_TEST(phi == 0.0);
      for (const auto& gradient : s.gradients) BOOST_TEST(gradient.norm() == 0.0);
    }
  }
}

// Two points at a distance d on one side of x, with the hat function's weights w_0 and w_1: the
// condition is (Σw) (Σ w ξ²) / (w_0 w_1 d²), and Φ continues the line through them.
BOOST_AUTO_TEST_CASE(condition_bounds_the_values_and_decides_the_order) {
  for (const double d : {0.3, 0.1, 0.02, 1.1e-2, 0.9e-2, 1e-3, 1e-6, 1e-9, 1e-14}) {
    const std::vector<Vector<1>> points{Vector<1>(0.5 - d), Vector<1>(0.5)};
    const auto s = shape_at<BSpline1, 1, 1>(Vector<1>(0.0), points, 1.0);
    const double w_0 = 0.5 + d;
    const double w_1 = 0.5;
    const double second_moment = w_0 * (0.5 - d) * (0.5 - d) + w_1 * 0.25;
    const double condition = (w_0 + w_1) * second_moment / (w_0 * w_1 * d * d);
    BOOST_TEST(s.result.order_used == (condition < default_max_condition ? 1 : 0));
    if (s.result.order_used == 0) continue;
    BOOST_TEST(s.result.condition == condition, boost::test_tools::tolerance(1e-8));
    const double sum = std::abs(s.phi[0]) + std::abs(s.phi[1]);
    BOOST_TEST(sum == (1.0 - d) / d, boost::test_tools::tolerance(1e-8));
    BOOST_TEST(sum <= std::sqrt(condition) * (1.0 + 1e-8));
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
