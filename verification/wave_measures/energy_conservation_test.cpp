// What FLIP does to the energy of a standing wave over many steps, without drag and between rigid
// ends.
//
//   verification_studies_tests --run_test=energy_conservation --log_level=message -- 1000000
//
// takes that many steps instead of the few of the test suite.
//
// Nodes carry velocities q and cells stresses d, but a step starts from what the points see of q,
// W q (solver/frozen_column.hpp). In a column of regular points with linear shape functions a sine
// stays a sine, W multiplies it by w, and a step of its amplitudes is
//
//   q' = q + α d     d' = d + β (w q + α d)     −α β = k = (2 c Δt/h sin(ξh/2))²
//   w = 1 − 2 a (1 − cos ξh), a = mean t (1 − t), t the places of the points in their cell
//
// q stands half a step before d, so the sum of squares oscillates with the phase of the wave. What
// does not: for any step A in the plane, the area of the parallelogram x, A x is multiplied by det
// A (that of A x, A A x). Here it is β H with
//
//   H = w q² + α q d − (α/β) d²     H' = (1 − k (1 − w)) H,
//
// twice the energy of what the points see, exactly. So FLIP keeps energy only as far as the points
// see the velocities of the nodes: a wave loses k (1 − w) of it in a step, courant² a (ξh)⁴ if it
// is long.

#include <fmt/format.h>

#include <Eigen/Dense>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "reference/modes.hpp"
#include "reference/problem/problem_fixtures.hpp"
#include "solver/column_solver.hpp"
#include "solver/stability/step_operator.hpp"
#include "solver/staggered/staggered_solver.hpp"

BOOST_AUTO_TEST_SUITE(energy_conservation)

using namespace porowave;
using solver::Case;
using solver::ColumnSolver;
using solver::Snapshot;

namespace {

constexpr double length = 0.1;

long steps_wanted() {
  const auto& suite = boost::unit_test::framework::master_test_suite();
  return suite.argc > 1 ? std::stol(suite.argv[1]) : 4000;
}

Case column(int elements, double courant, long steps) {
  Case scene;
  scene.problem = fixtures::paper_problem(Load(LoadShape::step, 0.0));
  scene.problem.material.intrinsic_permeability = 1e12;  // drag acts within 1e8 s
  scene.problem.column = {length, NearEnd::velocity, FarEnd::rigid_sealed};
  scene.discretization.elements = elements;
  scene.discretization.transfer = solver::TransferName::shape;
  scene.discretization.shape = solver::shape_name<solver::LinearSpline>;
  scene.time.courant = courant;
  const double crossing = length / elements / wave_speeds(scene.problem.material).p1;
  scene.time.end = static_cast<double>(steps) * courant * crossing;
  return scene;
}

struct Wave {
  int half_waves;
  double number() const { return half_waves * std::numbers::pi / length; }
};

// All motion, no stress, at the time of the velocities. So slow that nothing moves.
void start(ColumnSolver& run, const Case& scene, Wave wave) {
  const reference::WaveModes modes(scene.problem.material);
  const auto& shape = modes.velocity_of_mode();
  run.start_from([&](double x, double) {
    const double sine = 1e-12 * std::sin(wave.number() * x);
    return Fields{0.0, 0.0, shape[0][0] * sine, shape[1][0] * sine};
  });
}

// The step of the amplitudes of solid velocity and effective stress.
struct SineStep {
  double k, w, alpha, beta;

  SineStep(const Case& scene, double dt, Wave wave) {
    const Material& m = scene.problem.material;
    const int points = scene.discretization.points_per_element;
    const double h = length / scene.discretization.elements;
    const double difference = 2.0 * std::sin(0.5 * wave.number() * h) / h;
    double a = 0.0;
    for (int p = 0; p < points; ++p) {
      const double t = (p + 0.5) / points;
      a += t * (1.0 - t) / points;
    }
    w = 1.0 - 2.0 * a * (1.0 - std::cos(wave.number() * h));
    k = std::pow(wave_speeds(m).p1 * dt * difference, 2);
    beta = dt * m.constrained_modulus * difference;
    alpha = -k / beta;
  }
  double loss() const { return k * (1.0 - w); }

  // H. The velocities of a snapshot are half a step later, at the nodes: w q + α d/2.
  double energy(const Snapshot& s, Wave wave) const {
    double v = 0.0, d = 0.0;
    for (std::size_t i = 0; i < s.node_x.size(); ++i) {
      v += s.solid_velocity[i] * std::sin(wave.number() * s.node_x[i]);
    }
    for (std::size_t c = 0; c < s.cell_x.size(); ++c) {
      d += s.effective_stress[c] * std::cos(wave.number() * s.cell_x[c]);
    }
    const double q = (v - 0.5 * alpha * d) / w;
    return w * q * q + alpha * q * d - alpha / beta * d * d;
  }
};

// Eigenvalues of one step.
Eigen::VectorXcd eigenvalues(const solver::LinearMap& map) {
  const auto n = static_cast<Eigen::Index>(map.size);
  Eigen::MatrixXd matrix(n, n);
  std::vector<double> unit(map.size, 0.0);
  for (Eigen::Index k = 0; k < n; ++k) {
    unit[static_cast<std::size_t>(k)] = 1.0;
    map.apply(unit, {matrix.col(k).data(), map.size});
    unit[static_cast<std::size_t>(k)] = 0.0;
  }
  return Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues();
}

// Kinetic and elastic energy of the points, in the mean over whole periods, whose ends count
// little.
double mean_energy(ColumnSolver& run, const Case& scene, long steps) {
  const Material& m = scene.problem.material;
  const auto squares = [](const std::vector<double>& weight, const std::vector<double>& value) {
    double sum = 0.0;
    for (std::size_t p = 0; p < value.size(); ++p) sum += weight[p] * value[p] * value[p];
    return sum;
  };
  double energy = 0.0;
  for (long n = 0; n < steps; ++n) {
    const double turn =
        2.0 * std::numbers::pi * static_cast<double>(n) / static_cast<double>(steps);
    const Snapshot s = run.snapshot();
    energy += (1.0 - std::cos(turn)) *
              (m.solid_partial_density() * squares(s.solid.volume, s.solid.velocity) +
               m.fluid_partial_density() * squares(s.fluid.volume, s.fluid.velocity) +
               squares(s.solid.volume, s.solid.stress) / m.constrained_modulus +
               squares(s.fluid.volume, s.fluid.stress) / m.storage_modulus());
    run.step();
  }
  return energy / static_cast<double>(steps);
}

}  // namespace

BOOST_AUTO_TEST_CASE(flip_loses_the_energy_that_points_do_not_see_and_no_other) {
  const long steps = steps_wanted();
  struct Scene {
    int elements;
    double courant;
    int points;
    Wave wave;
  };
  for (const auto& [elements, courant, points, wave] :
       {Scene{50, 0.5, 4, {1}}, Scene{50, 0.7, 2, {3}}, Scene{25, 0.5, 1, {2}},
        Scene{400, 0.03, 4, {1}}}) {
    Case scene = column(elements, courant, steps);
    scene.discretization.points_per_element = points;
    ColumnSolver run(scene);
    start(run, scene, wave);
    const SineStep step(scene, run.time_step(), wave);
    run.step();
    const double before = step.energy(run.snapshot(), wave);
    double apart = 0.0, ratio = 1.0;
    for (int part = 1; part <= 10; ++part) {
      while (run.steps_done() < 1 + part * (steps - 1) / 10) run.step();
      ratio = step.energy(run.snapshot(), wave) / before;
      const double expected =
          std::exp(static_cast<double>(run.steps_done() - 1) * std::log1p(-step.loss()));
      // A wave that is gone has nothing left but rounding, 1e-16 of its amplitude.
      apart = std::max(apart, std::abs(ratio - expected) / std::max(expected, 1e-12));
    }
    BOOST_TEST_MESSAGE(fmt::format(
        "{} cells, courant {}, {} points a cell, {} half waves: {} steps, drift {:.4e}, loss a "
        "step {:.4e}, from the formula by {:.1e}",
        elements, courant, points, wave.half_waves, run.steps_done(), ratio - 1.0, step.loss(),
        apart));
    BOOST_TEST(apart < 1e-14 * static_cast<double>(1000 + steps));
  }
}

// No closed form here: the waves are those of the step operator, whose eigenvalue next to that of
// the exact wave says what a step loses. The run knows nothing of it. A sine is not quite one of
// these waves, the rest of it goes sooner.
BOOST_AUTO_TEST_CASE(irregular_points_lose_what_the_step_operator_says) {
  const long steps = std::max(steps_wanted(), 2000L);
  Case scene = column(40, 0.5, steps + 2000);
  scene.discretization.transfer = solver::TransferName::mls;
  scene.discretization.strain = solver::Strain::recovered;
  scene.discretization.placement = solver::Placement::stratified;
  const Wave wave{1};
  ColumnSolver run(scene);
  start(run, scene, wave);
  const auto values = eigenvalues(solver::step_operator(scene)->at(run.time_step()));
  const double angle = wave_speeds(scene.problem.material).p1 * wave.number() * run.time_step();
  const auto exact = std::polar(1.0, angle);
  Eigen::Index nearest = 0;
  (values.array() - exact).abs().minCoeff(&nearest);
  const double growth = std::abs(values[nearest]);
  const double largest = values.cwiseAbs().maxCoeff();
  BOOST_TEST(largest < 1.0 + 1e-6);

  const long window = std::lround(4.0 * 2.0 * std::numbers::pi / angle);
  const double before = mean_energy(run, scene, window);
  const long between = steps - window;
  while (run.steps_done() < steps) run.step();
  const double ratio = mean_energy(run, scene, window) / before;
  const double expected = std::pow(growth, 2.0 * static_cast<double>(between + window));
  BOOST_TEST_MESSAGE(fmt::format(
      "stratified, mls, recovered: {} steps, drift {:.4e}, by the operator {:.4e}; loss a step "
      "{:.4e}, largest eigenvalue 1 + {:.1e}",
      between + window, ratio - 1.0, expected - 1.0, 1.0 - growth * growth, largest - 1.0));
  BOOST_TEST(std::abs(std::log(ratio / expected)) < 1e-3);
}

// Cubics see nearly all of a long wave. Amplitudes s of three steps that follow each other, of a
// wave s = A r^n cos (n φ + const), have s_n² − s_(n−1) s_(n+1) = A² r^(2n) sin² φ at every phase.
BOOST_AUTO_TEST_CASE(staggered_differences_keep_the_energy_of_a_long_wave) {
  const long steps = steps_wanted();
  Case scene = column(200, 0.5, steps + 4);
  scene.discretization.scheme = solver::Scheme::staggered4;
  scene.discretization.transfer = solver::TransferName::mls;
  scene.discretization.kernel = solver::kernel_name<solver::WendlandC2>;
  scene.discretization.basis_order = 3;
  scene.discretization.support_radius = 2.5;
  const Wave wave{1};
  const reference::WaveModes modes(scene.problem.material);
  solver::StaggeredSolver run(scene);
  std::vector<double> state(run.state_size(), 0.0);
  const auto sine = [&](std::size_t i) {
    return std::sin(wave.number() * length * static_cast<double>(i) / 200.0);
  };
  for (std::size_t i = 0; i <= 200; ++i) {
    state[i] = 1e-12 * modes.velocity_of_mode()[0][0] * sine(i);
    state[201 + i] = 1e-12 * modes.velocity_of_mode()[1][0] * sine(i);
  }
  run.set_state(state);
  const auto amplitude = [&] {
    const auto now = run.state();
    double sum = 0.0;
    for (std::size_t i = 0; i <= 200; ++i) sum += now[i] * sine(i);
    return sum;
  };
  const auto energy = [&] {
    std::array<double, 3> s;
    for (double& value : s) {
      value = amplitude();
      run.step();
    }
    return s[1] * s[1] - s[0] * s[2];
  };
  const double before = energy();
  while (run.steps_done() < steps) run.step();
  const double drift = energy() / before - 1.0;
  BOOST_TEST_MESSAGE(fmt::format("staggered4, 200 cells: {} steps, drift {:.4e}", steps, drift));
  BOOST_TEST(std::abs(drift) < 1e-6);
}

BOOST_AUTO_TEST_SUITE_END()
