#include "solver/apic.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/problem/problem_fixtures.hpp"
#include "solver/column_solver.hpp"
#include "solver/test_points.hpp"
#include "solver/transfer_fixtures.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(apic)

namespace {

using namespace test;

template <class Shape>
Discretization affine() {
  Discretization d;
  d.transfer = TransferName::apic;
  d.shape = shape_name<Shape>;
  d.basis_order = 0;
  return d;
}

const std::vector<Discretization> choices{affine<LinearSpline>(), affine<SplineShape<BSpline2>>(),
                                          affine<SplineShape<BSpline3>>()};

// v_i of points with velocities and velocity gradients.
template <int Dim>
std::vector<double> affine_at_nodes(const Transfer<Dim>& transfer, const std::vector<double>& v,
                                    const std::array<std::vector<double>, Dim>& slopes) {
  auto nodal = at_nodes(transfer, v);
  for (int axis = 0; axis < Dim; ++axis) {
    transfer.add_affine(slopes[static_cast<std::size_t>(axis)], axis, nodal);
  }
  return nodal;
}

double momentum(const PhasePoints& points, double density) {
  double sum = 0.0;
  for (std::size_t p = 0; p < points.x.size(); ++p) {
    sum += density * points.volume[p] * points.velocity[p];
  }
  return sum;
}

// D = h²/4 and h²/3 where no end is near.
BOOST_AUTO_TEST_CASE(the_moment_is_that_of_the_spline) {
  const Grid<1> grid(Vector<1>(0.0), 0.5, CellIndex<1>(12));
  const auto points = random_points<1>(100, 3, 1.0, 5.0);
  const auto check = [&](ShapeName shape, double share) {
    auto rows = shape_rows<1>(points, {}, grid, shape);
    const auto moments = make_affine<1>(points, grid, rows);
    for (const double moment : moments[0]) {
      BOOST_TEST(std::abs(moment / (0.25 * share) - 1.0) < 1e-12);
    }
  };
  check(shape_name<SplineShape<BSpline2>>, 1.0 / 4.0);
  check(shape_name<SplineShape<BSpline3>>, 1.0 / 3.0);
}

// Linear functions: the affine gradient is that of the cell, at the end of the grid as well.
BOOST_AUTO_TEST_CASE(with_linear_functions_it_is_the_gradient) {
  const Grid<1> grid(Vector<1>(0.0), 0.5, CellIndex<1>(6));
  auto points = random_points<1>(50, 3, 0.0, 3.0);
  points.emplace_back(0.0);
  points.emplace_back(1e-13);
  const auto gradient = shape_rows<1>(points, {}, grid, shape_name<LinearSpline>).gradients[0];
  auto rows = shape_rows<1>(points, {}, grid, shape_name<LinearSpline>);
  make_affine<1>(points, grid, rows);
  BOOST_TEST(largest_difference(rows.gradients[0].values, gradient.values) < 1e-6);
}

// A linear velocity field goes to the nodes and back without loss, up to the ends.
BOOST_AUTO_TEST_CASE_TEMPLATE(linear_fields_survive_both_transfers, D, test::Dimensions) {
  constexpr int Dim = D::value;
  for_all<Dim>(
      choices, [](const auto& transfer, const auto& points, const auto& grid, const auto&) {
        std::array<std::vector<double>, Dim> slopes;
        for (int axis = 0; axis < Dim; ++axis) {
          slopes[static_cast<std::size_t>(axis)].assign(points.x.size(), Linear<Dim>::slope(axis));
        }
        const auto v = sample<Dim>(points.x, Linear<Dim>::at);
        const auto nodal = affine_at_nodes<Dim>(transfer, v, slopes);
        BOOST_TEST(largest_difference(nodal, sample<Dim>(nodes(grid), Linear<Dim>::at)) < 1e-12);
        std::vector<double> back(v.size());
        transfer.to_points(nodal, back);
        BOOST_TEST(largest_difference(back, v) < 1e-12);
        for (int axis = 0; axis < Dim; ++axis) {
          transfer.gradient_at_points(nodal, axis, back);
          BOOST_TEST(largest_difference(back, slopes[static_cast<std::size_t>(axis)]) < 1e-10);
        }
      });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(both_transfers_and_the_forces_conserve_momentum, D,
                              test::Dimensions) {
  constexpr int Dim = D::value;
  for (const auto& choice : choices) {
    auto points = scattered<Dim>();
    points.mass = noise(points.x.size(), 3, 0.1, 2.0);
    const Transfer<Dim> transfer(points, test_grid<Dim>(), choice);
    const auto v = noise(points.x.size(), 6);
    std::array<std::vector<double>, Dim> slopes;
    for (auto& slope : slopes) slope = noise(points.x.size(), 7, -50.0, 50.0);
    const auto nodal = affine_at_nodes<Dim>(transfer, v, slopes);
    const double at_nodes_sum = dot(transfer.nodal_mass(), nodal);
    BOOST_TEST(std::abs(at_nodes_sum - dot(points.mass, v)) < 1e-11 * sum(points.mass));
    std::vector<double> back(v.size());
    transfer.to_points(nodal, back);
    BOOST_TEST(std::abs(dot(points.mass, back) - at_nodes_sum) < 1e-11 * sum(points.mass));
    for (int axis = 0; axis < Dim; ++axis) {
      BOOST_TEST(std::abs(sum(force(transfer, noise(points.x.size(), 8), axis))) < 1e-11);
    }
  }
}

// A whole run between free ends: the momentum is the impulse of the load.
BOOST_AUTO_TEST_CASE(a_run_conserves_momentum) {
  for (const auto& choice : choices) {
    Case scene;
    scene.problem = fixtures::paper_problem(Load(LoadShape::sin4_pulse, 1.0, 1e-5));
    scene.problem.column.far = FarEnd::free_drained;
    scene.discretization = choice;
    scene.discretization.elements = 60;
    scene.discretization.placement = Placement::stratified;
    scene.time.end = 8e-5;
    scene.time.flip = 0.0;
    ColumnSolver solver(scene);
    BOOST_TEST(!solver.run());
    const Snapshot s = solver.snapshot();
    const Material& m = scene.problem.material;
    const double total =
        momentum(s.solid, m.solid_partial_density()) + momentum(s.fluid, m.fluid_partial_density());
    BOOST_TEST(std::abs(total / (1e-5 * 3.0 / 8.0) - 1.0) < 1e-9);  // ∫ sin⁴ = 3T/8
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
