#include "solver/stability/growth.hpp"

#include <Eigen/Dense>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "reference/problem/problem_fixtures.hpp"
#include "solver/case.hpp"

BOOST_AUTO_TEST_SUITE(growth)

using namespace porowave;
using namespace porowave::solver;
namespace tt = boost::test_tools;

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

LinearMap map_of(const MatrixXd& matrix) {
  return {static_cast<std::size_t>(matrix.rows()),
          [matrix](std::span<const double> in, std::span<double> out) {
            const auto n = static_cast<Eigen::Index>(in.size());
            Eigen::Map<VectorXd>(out.data(), n) = matrix * Eigen::Map<const VectorXd>(in.data(), n);
          }};
}

// A matrix of rotations, by 2 × 2 blocks of the given moduli, seen in skew coordinates.
MatrixXd skew_rotations(const std::vector<double>& moduli, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  const auto n = static_cast<Eigen::Index>(2 * moduli.size());
  MatrixXd blocks = MatrixXd::Zero(n, n);
  for (Eigen::Index k = 0; k < n; k += 2) {
    const double angle = 0.1 + 2.9 * static_cast<double>(k) / static_cast<double>(n);
    const double r = moduli[static_cast<std::size_t>(k / 2)];
    blocks.block(k, k, 2, 2) << r * std::cos(angle), r * std::sin(angle), -r * std::sin(angle),
        r * std::cos(angle);
  }
  MatrixXd skew(n, n);
  for (Eigen::Index i = 0; i < n * n; ++i) skew.data()[i] = normal(generator) / std::sqrt(n);
  skew += 1.5 * MatrixXd::Identity(n, n);
  return skew * blocks * skew.inverse();
}

// |A x − λ x| for a mode of unit norm.
double residual(const MatrixXd& matrix, const Growth& found) {
  const Eigen::Map<const Eigen::VectorXcd> mode(found.mode.data(), matrix.rows());
  return (matrix * mode - found.eigenvalue * mode).norm();
}

Case scene_of(std::uint64_t seed, KernelName kernel, int elements) {
  Case scene;
  scene.problem = fixtures::paper_problem();
  scene.discretization.elements = elements;
  scene.discretization.kernel = kernel;
  scene.discretization.support_radius = natural_radius(kernel);
  scene.discretization.placement = Placement::stratified;
  scene.discretization.seed = seed;
  return scene;
}

double time_step(const Case& scene, double courant) {
  return courant * *scene.problem.column.length / scene.discretization.elements /
         wave_speeds(scene.problem.material).p1;
}

}  // namespace

BOOST_AUTO_TEST_CASE(both_find_the_largest_of_known_eigenvalues) {
  for (const double largest : {1.3, 1.01, 1.002}) {
    std::vector<double> moduli(40, 1.0);
    moduli[7] = largest;
    moduli[20] = 0.5 * (1.0 + largest);
    const MatrixXd matrix = skew_rotations(moduli, 3);
    for (const bool dense : {true, false}) {
      GrowthSettings settings;
      settings.want_mode = true;
      const Growth found =
          dense ? dense_growth(map_of(matrix), true) : iterated_growth(map_of(matrix), settings);
      BOOST_TEST_CONTEXT((dense ? "dense, " : "iterated, ") << largest) {
        BOOST_TEST(found.settled);
        BOOST_TEST(found.per_step - 1.0 == largest - 1.0, tt::tolerance(dense ? 1e-9 : 0.03));
        BOOST_TEST(residual(matrix, found) < (dense ? 1e-10 : 1e-3));
        BOOST_TEST(std::abs(found.eigenvalue) == largest, tt::tolerance(dense ? 1e-10 : 1e-4));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(rotations_that_do_not_grow_are_not_called_growing) {
  const MatrixXd matrix = skew_rotations(std::vector<double>(40, 1.0), 5);
  const Growth dense = dense_growth(map_of(matrix), false);
  BOOST_TEST(std::abs(dense.per_step - 1.0) < 1e-10);
  const Growth iterated = iterated_growth(map_of(matrix), {});
  BOOST_TEST(!iterated.settled);
  BOOST_TEST(iterated.per_step < 1.0 + 2e-4);
  BOOST_TEST(iterated.per_step > 1.0 - 2e-4);
}

// Rigid motion: the state grows, but only by a constant a step.
BOOST_AUTO_TEST_CASE(what_grows_like_a_power_of_the_steps_is_not_growth) {
  MatrixXd matrix = MatrixXd::Identity(40, 40);
  for (Eigen::Index k = 0; k + 1 < 40; k += 2) matrix(k, k + 1) = 100.0;
  BOOST_TEST(std::abs(dense_growth(map_of(matrix), false).per_step - 1.0) < 1e-6);
  const Growth iterated = iterated_growth(map_of(matrix), {});
  BOOST_TEST(iterated.per_step < 1.0 + 2e-4);
}

BOOST_AUTO_TEST_CASE(a_decaying_map_has_a_growth_below_one) {
  const MatrixXd matrix = 0.5 * MatrixXd::Identity(30, 30);
  BOOST_TEST(dense_growth(map_of(matrix), false).per_step == 0.5, tt::tolerance(1e-12));
  BOOST_TEST(iterated_growth(map_of(matrix), {}).per_step == 0.5, tt::tolerance(1e-12));
  BOOST_TEST(iterated_growth(map_of(0.0 * matrix), {}).per_step == 0.0);
}

// Columns of which some are weakly unstable: the iteration must tell them apart as the dense
// matrix does, and give the same growth.
BOOST_AUTO_TEST_CASE(iterated_is_dense_for_columns) {
  int growing = 0, steady = 0;
  const GrowthSettings settings;
  for (const KernelName kernel : {kernel_name<BSpline1>, kernel_name<WendlandC4>}) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const Case scene = scene_of(seed, kernel, 24);
      const auto step = step_operator(scene);
      for (const double courant : {0.1, 0.5, 0.85, 1.0}) {
        const LinearMap map = step->at(time_step(scene, courant));
        const double expected = dense_growth(map, false).per_step;
        const Growth found = iterated_growth(map, settings);
        const std::string what = std::string(to_string(kernel)) + ", seed " + std::to_string(seed) +
                                 ", courant " + std::to_string(courant) + ": " +
                                 std::to_string(expected);
        BOOST_TEST_MESSAGE(what << ", " << found.per_step << (found.settled ? "" : " unsettled"));
        if (expected > 1.0 + 1.2 * settings.limit) {
          ++growing;
          BOOST_TEST(found.per_step > 1.0 + settings.limit, what);
        } else if (expected < 1.0 + 0.8 * settings.limit) {
          ++steady;
          BOOST_TEST(found.per_step <= 1.0 + settings.limit, what);
        }
        if (found.settled) {
          BOOST_TEST(found.per_step - 1.0 == expected - 1.0, tt::tolerance(0.03));
        }
      }
    }
  }
  BOOST_TEST(growing > 5);
  BOOST_TEST(steady > 5);
}

// Linear shape functions, n uniform points a cell, no drag, an endless column: of the shortest wave
// the points see the share w = mean (1 − 2t)², t their places in the cell, and with k = (2
// courant)² its eigenvalues are those of (z − 1)² + k (z − 1 + w) = 0. So the limit is 1/√(2 − w).
BOOST_AUTO_TEST_CASE(linear_shape_functions_grow_as_they_must) {
  for (const int points : {1, 2, 3, 4, 6}) {
    Case scene = scene_of(1, kernel_name<BSpline1>, 60);
    scene.discretization.transfer = TransferName::shape;
    scene.discretization.shape = shape_name<LinearSpline>;
    scene.discretization.placement = Placement::uniform;
    scene.discretization.points_per_element = points;
    scene.problem.material.intrinsic_permeability = 1.0;
    const auto step = step_operator(scene);
    const auto growth_at = [&](double courant) {
      return dense_growth(step->at(time_step(scene, courant)), false).per_step;
    };
    double w = 0.0;
    for (int p = 0; p < points; ++p) w += std::pow(1.0 - (2.0 * p + 1.0) / points, 2) / points;
    const double limit = 1.0 / std::sqrt(2.0 - w);
    BOOST_TEST(growth_at(0.999 * limit) < 1.0 + 1e-5);
    BOOST_TEST(growth_at(1.01 * limit) > 1.01);
    for (const double courant : {0.85, 1.0}) {
      const double k = 4.0 * courant * courant;
      const double z = 1.0 - 0.5 * k - std::sqrt(0.25 * k * k - k * w);
      BOOST_TEST(growth_at(courant) == -z, tt::tolerance(2e-3));
    }
  }
}

// What staggered_solver.hpp says of uniform points: the differences are stable below 6/7, with
// time_order = 4 up to 1.
BOOST_AUTO_TEST_CASE(staggered_differences_have_their_known_limits) {
  Case scene = scene_of(1, kernel_name<WendlandC2>, 40);
  scene.discretization.scheme = Scheme::staggered4;
  scene.discretization.basis_order = 2;
  scene.discretization.support_radius = 2.0;
  scene.discretization.placement = Placement::uniform;
  scene.problem.material.intrinsic_permeability = 1.0;
  const auto growth_at = [&](double courant) {
    return dense_growth(step_operator(scene)->at(time_step(scene, courant)), false).per_step;
  };
  BOOST_TEST(growth_at(6.0 / 7.0) < 1.0 + 1e-5);
  BOOST_TEST(growth_at(1.0) > 1.5);
  scene.time.order = 4;
  BOOST_TEST(growth_at(1.0) < 1.0 + 1e-5);
}

BOOST_AUTO_TEST_CASE(small_maps_are_dense_and_large_ones_are_not) {
  const MatrixXd matrix = skew_rotations(std::vector<double>(20, 1.1), 1);
  GrowthSettings settings;
  settings.largest_dense = 40;
  BOOST_TEST(solver::growth(map_of(matrix), settings).steps == 40);
  settings.largest_dense = 39;
  BOOST_TEST(solver::growth(map_of(matrix), settings).steps > 256);
}

BOOST_AUTO_TEST_CASE(a_guess_of_the_mode_is_used) {
  std::vector<double> moduli(60, 1.0);
  moduli[9] = 1.004;
  const LinearMap map = map_of(skew_rotations(moduli, 8));
  GrowthSettings settings;
  settings.want_mode = true;
  const Growth first = iterated_growth(map, settings);
  settings.guess = first.mode;
  const Growth again = iterated_growth(map, settings);
  BOOST_TEST(again.per_step == first.per_step, tt::tolerance(1e-4));
  BOOST_TEST(again.steps < first.steps);
}

BOOST_AUTO_TEST_SUITE_END()
