#include "solver/transfer.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <tuple>

#include "solver/test_points.hpp"
#include "solver/transfer_fixtures.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(transfer)

namespace {

using namespace test;

template <int Dim>
double size(const Grid<Dim>& grid) {
  return grid.cell_count() * std::pow(grid.spacing, Dim);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(the_points_of_these_tests_carry_every_order, D, test::Dimensions) {
  constexpr int Dim = D::value;
  for_all<Dim>(all_choices(), [](const auto& transfer, const auto&, const auto&, const auto&) {
    BOOST_TEST(transfer.reduced_rows() == 0U);
    BOOST_TEST(transfer.empty_rows() == 0U);
  });
}

// ---- mass, volume, velocity ---------------------------------------------------------------------

BOOST_AUTO_TEST_CASE_TEMPLATE(shape_conserves_mass_volume_and_momentum, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto grid = test_grid<Dim>();
  for (auto points : {regular<Dim>(), scattered<Dim>()}) {
    points.mass = noise(points.x.size(), 3, 0.1, 2.0);
    points.volume = noise(points.x.size(), 4, 0.1, 2.0);
    const Transfer<Dim> transfer(points, grid, shape());
    BOOST_TEST(std::abs(sum(transfer.nodal_mass()) / sum(points.mass) - 1.0) < 1e-13);
    BOOST_TEST(std::abs(sum(transfer.nodal_volume()) / sum(points.volume) - 1.0) < 1e-13);
    const auto v = noise(points.x.size(), 6);
    const auto nodal = at_nodes(transfer, v);
    BOOST_TEST(std::abs(dot(transfer.nodal_mass(), nodal) - dot(points.mass, v)) <
               1e-13 * sum(points.mass));
  }
}

// First moments as well: Σ m_i x_i = Σ m_p x_p, because Σ N_i(x) x_i = x.
BOOST_AUTO_TEST_CASE_TEMPLATE(shape_keeps_the_centre_of_mass, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto grid = test_grid<Dim>();
  auto points = scattered<Dim>();
  points.mass = noise(points.x.size(), 3, 0.1, 2.0);
  const Transfer<Dim> transfer(points, grid, shape());
  for (int axis = 0; axis < Dim; ++axis) {
    const auto coordinate = [&](const Vector<Dim>& x) { return x[axis]; };
    const double nodal = dot(transfer.nodal_mass(), sample<Dim>(nodes(grid), coordinate));
    BOOST_TEST(std::abs(nodal - dot(points.mass, sample<Dim>(points.x, coordinate))) <
               1e-13 * sum(points.mass));
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(nodal_mass_is_density_times_nodal_volume, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto check = [](const auto& transfer, const auto&, const auto& grid, const auto&) {
    double total = 0.0;
    for (int i = 0; i < grid.node_count(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double volume = grid.nodal_volume(i);
      BOOST_TEST(std::abs(transfer.nodal_volume()[k] / volume - 1.0) < 1e-12);
      BOOST_TEST(std::abs(transfer.nodal_mass()[k] / (density * volume) - 1.0) < 1e-12);
      total += transfer.nodal_mass()[k];
    }
    BOOST_TEST(std::abs(total / (density * size(grid)) - 1.0) < 1e-12);
  };
  for_all<Dim>(mls_choices, check);
  // With shape functions that is so for regular points.
  check(Transfer<Dim>(regular<Dim>(), test_grid<Dim>(), shape()), 0, test_grid<Dim>(), 0);
}

// Moving least squares sees the density m_p/V_p of the points, not how much each stands for.
BOOST_AUTO_TEST_CASE_TEMPLATE(mls_reproduces_a_linear_density, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto grid = test_grid<Dim>();
  auto points = scattered<Dim>();
  points.volume = noise(points.x.size(), 4, 0.1, 2.0);
  for (std::size_t p = 0; p < points.x.size(); ++p) {
    points.mass[p] = points.volume[p] * (20.0 + Linear<Dim>::at(points.x[p]));
  }
  for (const auto& choice : mls_choices) {
    if (choice.basis_order == 0) continue;
    const Transfer<Dim> transfer(points, grid, choice);
    for (int i = 0; i < grid.node_count(); ++i) {
      const double expected =
          (20.0 + Linear<Dim>::at(grid.node_position(i))) * grid.nodal_volume(i);
      BOOST_TEST(std::abs(transfer.nodal_mass()[static_cast<std::size_t>(i)] / expected - 1.0) <
                 1e-11);
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_constant_velocity_arrives_at_the_nodes, D, test::Dimensions) {
  constexpr int Dim = D::value;
  for_all<Dim>(
      all_choices(), [](const auto& transfer, const auto& points, const auto& grid, const auto&) {
        const auto nodal = at_nodes(transfer, std::vector<double>(points.x.size(), -2.5));
        const std::vector<double> expected(static_cast<std::size_t>(grid.node_count()), -2.5);
        BOOST_TEST(largest_difference(nodal, expected) < 1e-12);
      });
}

// Exactly what the basis holds: polynomials up to its order, and no higher ones.
BOOST_AUTO_TEST_CASE_TEMPLATE(mls_reproduces_polynomials_up_to_its_order, D, test::Dimensions) {
  constexpr int Dim = D::value;
  for_all<Dim>(mls_choices, [](const auto& transfer, const auto& points, const auto& grid,
                               const auto& choice) {
    const auto error = [&](auto&& u) {
      const auto values = sample<Dim>(points.x, u);
      const auto nodal = at_nodes(transfer, values);
      const double at_centres =
          largest_difference(transfer.at_cell_centres(values), sample<Dim>(centres(grid), u));
      return std::max(largest_difference(nodal, sample<Dim>(nodes(grid), u)), at_centres);
    };
    const double linear = error(Linear<Dim>::at);
    const double quadratic = error(Linear<Dim>::squared);
    if (choice.basis_order >= 1) {
      BOOST_TEST(linear < 1e-11);
    } else {
      BOOST_TEST(linear > 1e-3);
    }
    if (choice.basis_order >= 2) {
      BOOST_TEST(quadratic < 1e-10);
    } else {
      BOOST_TEST(quadratic > 1e-3);
    }
  });
}

// Of order 0 (Shepard) the weights are the kernel's own, over their sum.
BOOST_AUTO_TEST_CASE_TEMPLATE(order_0_is_the_mean_weighted_by_the_kernel, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto grid = test_grid<Dim>();
  const auto points = scattered<Dim>();
  const auto v = noise(points.x.size(), 6);
  std::apply(
      [&](auto... kernel) {
        const auto check = [&]<class Kernel>(Kernel) {
          const double radius = 1.3;  // in h
          const auto mean = [&](const Vector<Dim>& x) {
            double weights = 0.0;
            double values = 0.0;
            for (std::size_t p = 0; p < v.size(); ++p) {
              const double w = weight_value<Kernel, Dim>(points.x[p] - x, radius * grid.spacing);
              weights += w;
              values += w * v[p];
            }
            return values / weights;
          };
          const Transfer<Dim> transfer(points, grid, mls<Kernel>(radius, 0));
          // 1e-8: the support is smaller by a share of 1e-10
          BOOST_TEST(largest_difference(at_nodes(transfer, v), sample<Dim>(nodes(grid), mean)) <
                     1e-8);
          BOOST_TEST(largest_difference(transfer.at_cell_centres(v),
                                        sample<Dim>(centres(grid), mean)) < 1e-8);
        };
        (check(kernel), ...);
      },
      Kernels{});
}

// By hand: points at 0.25 and 0.75 of the first of two cells, masses 1 and 3.
BOOST_AUTO_TEST_CASE(shape_in_one_dimension_by_hand) {
  const Grid<1> grid(Vector<1>(0.0), 1.0, CellIndex<1>(2));
  const PointSet<1> points{{Vector<1>(0.25), Vector<1>(0.75)}, {0.5, 0.25}, {1.0, 3.0}};
  const Transfer<1> transfer(points, grid, shape());
  const auto per_element = boost::test_tools::per_element();
  BOOST_TEST(transfer.nodal_mass() == (std::vector<double>{1.5, 2.5, 0.0}), per_element);
  BOOST_TEST(transfer.nodal_volume() == (std::vector<double>{0.4375, 0.3125, 0.0}), per_element);
  // momentum 0.75·4 + 0.75·8 and 0.25·4 + 2.25·8
  BOOST_TEST(at_nodes(transfer, {4.0, 8.0}) == (std::vector<double>{6.0, 7.6, 0.0}), per_element);
  // −Σ V s ∂N = 0.5·2 + 0.25·8
  BOOST_TEST(force(transfer, {2.0, 8.0}, 0) == (std::vector<double>{3.0, -3.0, 0.0}), per_element);
  BOOST_TEST(
      transfer.at_cell_centres(std::vector<double>{2.0, 8.0}) == (std::vector<double>{4.0, 0.0}),
      per_element);
}

// ---- back to the points, and fields -------------------------------------------------------------

BOOST_AUTO_TEST_CASE_TEMPLATE(points_get_linear_fields_and_their_slopes, D, test::Dimensions) {
  constexpr int Dim = D::value;
  for_all<Dim>({shape(), mls<WendlandC4>(3.0, 2)}, [](const auto& transfer, const auto& points,
                                                      const auto& grid, const auto&) {
    const auto u = sample<Dim>(nodes(grid), Linear<Dim>::at);
    std::vector<double> values(points.x.size(), -99.0);
    transfer.to_points(u, values);
    BOOST_TEST(largest_difference(values, sample<Dim>(points.x, Linear<Dim>::at)) < 1e-13);
    for (int axis = 0; axis < Dim; ++axis) {
      transfer.gradient_at_points(u, axis, values);
      const std::vector<double> slope(points.x.size(), Linear<Dim>::slope(axis));
      BOOST_TEST(largest_difference(values, slope) < 1e-12);
    }
  });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(the_field_of_mls_is_what_the_forces_see, D, test::Dimensions) {
  constexpr int Dim = D::value;
  for_all<Dim>(mls_choices, [](const auto& transfer, const auto& points, const auto&, const auto&) {
    const auto stress = noise(points.x.size(), 8);
    std::vector<double> quadrature(3, -99.0);  // gets its length
    transfer.to_quadrature(stress, quadrature);
    BOOST_TEST(largest_difference(quadrature, transfer.at_cell_centres(stress)) == 0.0);
  });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(the_field_of_shape_is_the_mean_over_each_cell, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto grid = test_grid<Dim>();
  auto points = scattered<Dim>();
  points.volume = noise(points.x.size(), 4, 0.1, 2.0);
  const Transfer<Dim> transfer(points, grid, shape());
  const auto stress = noise(points.x.size(), 8);
  const std::size_t in_cell = points.x.size() / static_cast<std::size_t>(grid.cell_count());
  std::vector<double> expected;  // points are in the order of their cells
  for (std::size_t first = 0; first < points.x.size(); first += in_cell) {
    double volume = 0.0;
    double integral = 0.0;
    for (std::size_t p = first; p < first + in_cell; ++p) {
      volume += points.volume[p];
      integral += points.volume[p] * stress[p];
    }
    expected.push_back(integral / volume);
  }
  BOOST_TEST(largest_difference(transfer.at_cell_centres(stress), expected) < 1e-14);
  std::vector<double> quadrature;
  transfer.to_quadrature(stress, quadrature);
  BOOST_TEST(quadrature == stress, boost::test_tools::per_element());
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
