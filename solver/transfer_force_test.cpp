#include "solver/transfer.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "solver/test_points.hpp"
#include "solver/transfer_fixtures.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(transfer_force)

namespace {

using namespace test;

template <int Dim>
bool inside(const Grid<Dim>& grid, int node) {
  const CellIndex<Dim> i = grid.node_index(node);
  return (i.array() > 0).all() && (i.array() < grid.cells.array()).all();
}

// A constant stress: nothing inside, on the ends the traction times the node's share of the face.
// −∫ ∂N_i s = −s ∮ N_i n; N_i over a face is the node's volume over h/2.
template <int Dim>
void check_constant_stress(const Transfer<Dim>& transfer, std::size_t points,
                           const Grid<Dim>& grid) {
  const double stress = 3.0;
  for (int axis = 0; axis < Dim; ++axis) {
    const auto f = force(transfer, std::vector<double>(points, stress), axis);
    for (int i = 0; i < grid.node_count(); ++i) {
      const int place = grid.node_index(i)[axis];
      const double normal = (place == grid.cells[axis] ? 1.0 : 0.0) - (place == 0 ? 1.0 : 0.0);
      const double expected = -stress * normal * grid.nodal_volume(i) / (0.5 * grid.spacing);
      BOOST_TEST(std::abs(f[static_cast<std::size_t>(i)] - expected) < 1e-12);
    }
  }
}

// The slope along an axis that the shape functions give to nodal values.
template <int Dim>
double gradient_at(const Vector<Dim>& x, const Grid<Dim>& grid, const std::vector<double>& u,
                   int axis) {
  const auto linear = grid.linear_shape(x);
  double gradient = 0.0;
  for (std::size_t c = 0; c < linear.nodes.size(); ++c) {
    gradient += linear.gradients[c][axis] * u[static_cast<std::size_t>(linear.nodes[c])];
  }
  return gradient;
}

BOOST_AUTO_TEST_CASE_TEMPLATE(internal_forces_of_any_stress_balance, D, test::Dimensions) {
  constexpr int Dim = D::value;
  for_all<Dim>(all_choices(),
               [](const auto& transfer, const auto& points, const auto&, const auto&) {
                 for (int axis = 0; axis < Dim; ++axis) {
                   const auto f = force(transfer, noise(points.x.size(), 8), axis);
                   BOOST_TEST(std::abs(sum(f)) < 1e-12);
                   double largest = 0.0;
                   for (const double value : f) largest = std::max(largest, std::abs(value));
                   BOOST_TEST(largest > 1e-4);  // there are forces
                 }
               });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_constant_stress_is_felt_at_the_ends_only, D, test::Dimensions) {
  constexpr int Dim = D::value;
  const auto grid = test_grid<Dim>();
  for_all<Dim>(mls_choices,
               [](const auto& transfer, const auto& points, const auto& g, const auto&) {
                 check_constant_stress(transfer, points.x.size(), g);
               });
  check_constant_stress(Transfer<Dim>(regular<Dim>(), grid, shape()), regular<Dim>().x.size(),
                        grid);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_linear_stress_gives_its_gradient_at_inner_nodes, D,
                              test::Dimensions) {
  constexpr int Dim = D::value;
  const auto check = [](const auto& transfer, const auto& points, const auto& grid,
                        const auto& choice) {
    if (choice.basis_order == 0) return;
    const auto stress = sample<Dim>(points.x, Linear<Dim>::at);
    for (int axis = 0; axis < Dim; ++axis) {
      const auto f = force(transfer, stress, axis);
      for (int i = 0; i < grid.node_count(); ++i) {
        if (!inside(grid, i)) continue;
        const double expected = Linear<Dim>::slope(axis) * grid.nodal_volume(i);
        BOOST_TEST(std::abs(f[static_cast<std::size_t>(i)] - expected) < 1e-12);
      }
    }
  };
  for_all<Dim>(mls_choices, check);
  // In one dimension regular points see the mean of each cell, which is all that counts.
  if constexpr (Dim == 1) {
    const auto grid = test_grid<1>();
    check(Transfer<1>(regular<1>(), grid, shape()), regular<1>(), grid, mls<BSpline1>(1.0, 1));
  }
}

// The power of the internal forces is that of the stress at the quadrature points: with shape
// these are the points (V_p s_p), with mls the cell middles (h^Dim s).
BOOST_AUTO_TEST_CASE_TEMPLATE(forces_and_gradients_are_adjoint, D, test::Dimensions) {
  constexpr int Dim = D::value;
  for_all<Dim>(all_choices(), [](const auto& transfer, const auto& points, const auto& grid,
                                 const auto& choice) {
    const bool at_points = choice.transfer == TransferName::shape;
    const auto u = noise(static_cast<std::size_t>(grid.node_count()), 9);
    const auto stress = noise(points.x.size(), 10);
    const auto places = at_points ? points.x : centres(grid);
    const auto s = at_points ? stress : transfer.at_cell_centres(stress);
    for (int axis = 0; axis < Dim; ++axis) {
      double power = 0.0;
      for (std::size_t q = 0; q < places.size(); ++q) {
        const double weight = at_points ? points.volume[q] : std::pow(grid.spacing, Dim);
        power -= weight * s[q] * gradient_at<Dim>(places[q], grid, u, axis);
      }
      BOOST_TEST(std::abs(dot(force(transfer, stress, axis), u) - power) < 1e-12);
      if (!at_points) continue;
      std::vector<double> gradients(points.x.size());
      transfer.gradient_at_points(u, axis, gradients);
      double at_the_points = 0.0;
      for (std::size_t p = 0; p < gradients.size(); ++p) {
        at_the_points -= points.volume[p] * stress[p] * gradients[p];
      }
      BOOST_TEST(std::abs(at_the_points - power) < 1e-12);
    }
  });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(divergences_are_added_with_their_factor, D, test::Dimensions) {
  constexpr int Dim = D::value;
  for_all<Dim>({shape(), mls<BSpline2>(1.5, 1)},
               [](const auto& transfer, const auto& points, const auto& grid, const auto&) {
                 const auto stress = noise(points.x.size(), 8);
                 std::vector<double> quadrature;
                 transfer.to_quadrature(stress, quadrature);
                 for (int axis = 0; axis < Dim; ++axis) {
                   const auto before = noise(static_cast<std::size_t>(grid.node_count()), 12);
                   auto nodal = before;
                   transfer.add_divergence(quadrature, 0.4, axis, nodal);
                   const auto f = force(transfer, stress, axis);
                   for (std::size_t i = 0; i < nodal.size(); ++i) {
                     BOOST_TEST(std::abs(nodal[i] - (before[i] - 0.4 * f[i])) < 1e-13);
                   }
                 }
               });
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
