#pragma once

// Points, grids, fields and choices of transfer for the tests of Transfer.

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "solver/transfer.hpp"

namespace porowave::solver::test {

inline constexpr double density = 1590.0;
inline constexpr int per_axis = 3;  // points per cell and axis

inline Discretization shape() {
  Discretization d;
  d.transfer = TransferName::shape;
  d.kernel = kernel_name<BSpline1>;
  return d;
}

template <class Kernel>
Discretization mls(double support_radius, int basis_order) {
  Discretization d;
  d.transfer = TransferName::mls;
  d.kernel = kernel_name<Kernel>;
  d.support_radius = support_radius;
  d.basis_order = basis_order;
  return d;
}

// Wide enough to carry their order with the points below, up to the corners of the grid.
inline const std::vector<Discretization> mls_choices{
    mls<BSpline1>(1.0, 0),   mls<BSpline1>(1.5, 1),   mls<BSpline2>(1.5, 1),
    mls<BSpline3>(2.0, 1),   mls<WendlandC2>(2.0, 0), mls<WendlandC2>(2.0, 1),
    mls<WendlandC4>(3.0, 2), mls<WendlandC6>(3.0, 1), mls<BSpline2>(2.5, 2)};

inline std::vector<Discretization> all_choices() {
  std::vector<Discretization> choices{shape()};
  choices.insert(choices.end(), mls_choices.begin(), mls_choices.end());
  return choices;
}

inline std::string title(const Discretization& d) {
  if (d.transfer == TransferName::shape) return "shape";
  return "mls " + std::string(to_string(d.kernel)) + ", radius " +
         std::to_string(d.support_radius) + ", order " + std::to_string(d.basis_order);
}

// Not at the origin, and of a different number of cells along every axis.
template <int Dim>
Grid<Dim> test_grid() {
  CellIndex<Dim> cells;
  for (int a = 0; a < Dim; ++a) cells[a] = Dim == 3 ? 4 - (a > 1 ? 1 : 0) : 7 - 2 * a;
  return {Vector<Dim>::Constant(-0.3), 0.2, cells};
}

// Each point moved from its regular place by up to `scatter`/2 spacings along every axis.
template <int Dim>
PointSet<Dim> points_in(const Grid<Dim>& grid, double scatter) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> chance(-0.5 * scatter, 0.5 * scatter);
  PointSet<Dim> points;
  const int in_cell = static_cast<int>(std::lround(std::pow(per_axis, Dim)));
  for (int cell = 0; cell < grid.cell_count(); ++cell) {
    for (int k = 0; k < in_cell; ++k) {
      Vector<Dim> x = grid.cell_centre(cell);
      for (int a = 0, rest = k; a < Dim; ++a, rest /= per_axis) {
        const double place = (rest % per_axis + 0.5 + chance(generator)) / per_axis - 0.5;
        x[a] += grid.spacing * place;
      }
      points.x.push_back(x);
      points.volume.push_back(std::pow(grid.spacing, Dim) / in_cell);
      points.mass.push_back(density * points.volume.back());
    }
  }
  return points;
}

template <int Dim>
PointSet<Dim> regular() {
  return points_in(test_grid<Dim>(), 0.0);
}

template <int Dim>
PointSet<Dim> scattered() {
  return points_in(test_grid<Dim>(), 0.8);
}

inline std::vector<double> noise(std::size_t count, unsigned seed, double low = -1.0,
                                 double high = 1.0) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> chance(low, high);
  std::vector<double> values(count);
  for (double& value : values) value = chance(generator);
  return values;
}

inline double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

inline double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  BOOST_TEST_REQUIRE(a.size() == b.size());
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double difference = std::abs(a[k] - b[k]);
    if (!(difference <= largest)) largest = difference;  // keeps a NaN
  }
  return largest;
}

template <int Dim>
std::vector<Vector<Dim>> nodes(const Grid<Dim>& grid) {
  std::vector<Vector<Dim>> x;
  for (int i = 0; i < grid.node_count(); ++i) x.push_back(grid.node_position(i));
  return x;
}

template <int Dim>
std::vector<Vector<Dim>> centres(const Grid<Dim>& grid) {
  std::vector<Vector<Dim>> x;
  for (int c = 0; c < grid.cell_count(); ++c) x.push_back(grid.cell_centre(c));
  return x;
}

// A field and its slopes: u = u_0 + g·x with a different slope along every axis.
template <int Dim>
struct Linear {
  static double slope(int axis) { return 1.5 - 2.0 * axis; }
  static double at(const Vector<Dim>& x) {
    double u = 0.7;
    for (int a = 0; a < Dim; ++a) u += slope(a) * x[a];
    return u;
  }
  static double squared(const Vector<Dim>& x) { return at(x) * at(x); }
};

template <int Dim, class F>
std::vector<double> sample(const std::vector<Vector<Dim>>& x, F&& u) {
  std::vector<double> values;
  for (const Vector<Dim>& y : x) values.push_back(u(y));
  return values;
}

template <int Dim>
std::vector<double> at_nodes(const Transfer<Dim>& transfer, const std::vector<double>& values) {
  std::vector<double> result(transfer.nodal_mass().size(), -99.0);
  transfer.to_nodes(values, result);
  return result;
}

// −∫ ∂N_i/∂x_axis s dx, as a step makes it.
template <int Dim>
std::vector<double> force(const Transfer<Dim>& transfer, const std::vector<double>& stress,
                          int axis) {
  std::vector<double> quadrature;
  transfer.to_quadrature(stress, quadrature);
  std::vector<double> nodal(transfer.nodal_mass().size(), 0.0);
  transfer.add_divergence(quadrature, -1.0, axis, nodal);
  return nodal;
}

// Calls check(transfer, points, grid, choice) for all choices, points regular and scattered.
template <int Dim, class F>
void for_all(const std::vector<Discretization>& choices, F&& check) {
  const auto grid = test_grid<Dim>();
  for (const auto& points : {regular<Dim>(), scattered<Dim>()}) {
    for (const auto& choice : choices) {
      BOOST_TEST_CONTEXT(title(choice)) {
        check(Transfer<Dim>(points, grid, choice), points, grid, choice);
      }
    }
  }
}

}  // namespace porowave::solver::test
