#include "reference/modal.hpp"

#include <Eigen/Eigenvalues>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/MatrixFunctions>

#include "reference/column_solution.hpp"
#include "reference/field_fixtures.hpp"
#include "reference/modal_modes.hpp"
#include "reference/problem/errors.hpp"
#include "reference/problem/problem_fixtures.hpp"
#include "reference/random_problems.hpp"

BOOST_AUTO_TEST_SUITE(modal)

using namespace porowave;
using namespace porowave::reference;
namespace tt = boost::test_tools;
using fixtures::as_array;
using fixtures::distance;
using fixtures::Four;
using fixtures::largest_share;

namespace {

/// The matrix of one mode: z' = -kappa w, w' = kappa z - g (g . w).
Eigen::Matrix4d mode_matrix(const quarter_wave::Frame& frame, double k) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  for (int i = 0; i < 2; ++i) {
    const auto I = static_cast<std::size_t>(i);
    matrix(i, 2 + i) = -frame.speed()[I] * k;
    matrix(2 + i, i) = frame.speed()[I] * k;
    for (int j = 0; j < 2; ++j) {
      matrix(2 + i, 2 + j) = -frame.drag()[I] * frame.drag()[static_cast<std::size_t>(j)];
    }
  }
  return matrix;
}

/// The mode's amplitudes at t < duration of a smooth ramp, by one matrix exponential of the mode
/// and the polynomial q' together.
quarter_wave::Amplitudes by_exponential(const quarter_wave::Frame& frame, const Load& load,
                                        double t, double k, double share) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(9, 9);
  matrix.topLeftCorner(4, 4) = mode_matrix(frame, k);
  // q' T = 60 (z^2/2) - 360 (z^3/6) + 720 (z^4/24), z = t/T; each z^n/n! is driven by the one
  // before.
  const double T = load.duration();
  const std::array<double, 5> factor = {0.0, 0.0, 60.0, -360.0, 720.0};
  for (int n = 0; n < 5; ++n) {
    for (int i = 0; i < 2; ++i) {
      matrix(i, 4 + n) = -frame.boundary()[static_cast<std::size_t>(i)] * share * load.magnitude() *
                         factor[static_cast<std::size_t>(n)] / T;
    }
    if (n > 0) matrix(4 + n, 3 + n) = 1.0 / T;
  }
  const Eigen::MatrixXd scaled = matrix * t;
  const Eigen::MatrixXd propagator = scaled.exp();
  return {propagator(0, 4), propagator(1, 4), propagator(2, 4), propagator(3, 4)};
}

int real_roots(const quarter_wave::Frame& frame, double k) {
  const Eigen::EigenSolver<Eigen::Matrix4d> solver(mode_matrix(frame, k), false);
  int count = 0;
  for (int i = 0; i < 4; ++i) count += solver.eigenvalues()(i).imag() == 0.0 ? 1 : 0;
  return count;
}

/// Any of the problems that this route can do.
Problem random_problem(fixtures::RandomProblems& random, double stiffness) {
  const NearEnd near = random.index(2) == 0 ? NearEnd::drained_traction : NearEnd::fluid_pressure;
  Problem problem = random.next(stiffness, Load(), near, FarEnd::rigid_sealed);
  const std::array<LoadShape, 3> shapes = {LoadShape::smooth_ramp, LoadShape::sin4_pulse,
                                           LoadShape::ricker};
  const double crossing = *problem.column.length / wave_speeds(problem.material).p1;
  problem.load = Load(shapes[static_cast<std::size_t>(random.index(3))], 2.5,
                      crossing * random.log_uniform(0.3, 3.0));
  return problem;
}

}  // namespace

BOOST_AUTO_TEST_CASE(without_drag_waves_are_reflected_unchanged) {
  Problem problem = fixtures::paper_problem();
  problem.material.intrinsic_permeability = 1e8;
  const double length = *problem.column.length;
  const quarter_wave::Frame frame(problem);
  for (const LoadShape shape : {LoadShape::smooth_ramp, LoadShape::sin4_pulse, LoadShape::ricker}) {
    problem.load = Load(shape, 3.0, 2e-5);
    const double t = 1.4e-4;
    const ModalSolution solution(problem, t);
    for (const double x : {0.0, 1e-3, 0.037, 0.05, 0.099, 0.1}) {
      // Stress waves change sign at the loaded end only, velocities also where they turn.
      quarter_wave::Amplitudes waves{};
      for (std::size_t k = 0; k < 2; ++k) {
        const double c = frame.speed()[k];
        for (int trip = 0; trip < 20; ++trip) {
          const double sign = trip % 2 == 0 ? frame.boundary()[k] : -frame.boundary()[k];
          const double up = problem.load.value(t - (2 * trip * length + x) / c);
          const double down = problem.load.value(t - (2 * (trip + 1) * length - x) / c);
          waves[k] += sign * (up + down);
          waves[2 + k] -= sign * (up - down);
        }
      }
      const Four f = frame.fields(waves);
      const BoundedFields sum = solution.at(x);
      BOOST_TEST(distance(problem, sum.value, {f[0], f[1], f[2], f[3]}) < 1e-11);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_mode_is_what_the_matrix_exponential_says) {
  const Problem problem = fixtures::paper_problem(Load(LoadShape::smooth_ramp, 1.0, 6e-5));
  const quarter_wave::Frame frame(problem);
  for (const double t : {1e-6, 2e-5, 5e-5}) {
    const quarter_wave::SmoothLoad load(problem.load, t);
    for (const double k : {15.0, 47.0, 400.0, 4e3, 2e4}) {
      const auto sum = quarter_wave::mode_amplitudes(frame, load, t, k, 1.0);
      const auto exact = by_exponential(frame, problem.load, t, k, 1.0);
      const double unit = problem.load.value(t) * std::abs(frame.boundary()[0]);
      for (std::size_t f = 0; f < 4; ++f) BOOST_TEST(std::abs(sum[f] - exact[f]) < 1e-12 * unit);
    }
  }
}

BOOST_AUTO_TEST_CASE(critical_damping_costs_no_accuracy) {
  // The permeability at which two real roots of the third mode merge and become complex.
  Problem problem = fixtures::paper_problem(Load(LoadShape::smooth_ramp, 1.0, 6e-5));
  const double k = 2.5 * std::numbers::pi / *problem.column.length;
  double stiff = 1e-14;
  double loose = 1e-9;
  const auto roots_at = [&](double permeability) {
    problem.material.intrinsic_permeability = permeability;
    return real_roots(quarter_wave::Frame(problem), k);
  };
  BOOST_REQUIRE(roots_at(stiff) == 2);
  BOOST_REQUIRE(roots_at(loose) == 0);
  while (stiff * (1.0 + 1e-15) < loose) {
    const double middle = std::sqrt(stiff * loose);
    if (middle <= stiff || middle >= loose) break;
    (roots_at(middle) == 2 ? stiff : loose) = middle;
  }
  for (const double offset : {0.0, 1e-12, 1e-9, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
    for (const double side : {1.0 - offset, 1.0 + offset}) {
      problem.material.intrinsic_permeability = stiff * side;
      const quarter_wave::Frame frame(problem);
      const double t = 5e-5;
      const auto sum = quarter_wave::mode_amplitudes(frame, {problem.load, t}, t, k, 1.0);
      const auto exact = by_exponential(frame, problem.load, t, k, 1.0);
      for (std::size_t f = 0; f < 4; ++f) {
        BOOST_TEST(std::abs(sum[f] - exact[f]) < 1e-11 * std::abs(frame.boundary()[0]));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_response_to_a_load_does_not_depend_on_the_rule) {
  // Where one formula takes over from another, a small change of s must not show.
  for (const LoadShape shape : {LoadShape::smooth_ramp, LoadShape::sin4_pulse, LoadShape::ricker}) {
    const Load load(shape, 1.0, 1.0);
    for (const double t : {0.6, 1.0, 1.7}) {
      const quarter_wave::SmoothLoad smooth(load, t);
      const double end = std::min(t, 1.0);
      for (const double size : {20.0, 60.0, 160.0, 320.0, 640.0}) {
        for (const double angle : {0.5, 0.6, 0.9, 1.0}) {
          const auto at = [&](double factor) {
            return smooth.response(std::polar(size * factor / end, angle * std::numbers::pi));
          };
          const std::complex<double> below = at(1.0 - 1e-13);
          const std::complex<double> above = at(1.0 + 1e-13);
          const double change = 2e-13 * size * (1.0 + t / end) * std::abs(below);
          BOOST_TEST(std::abs(below - above) < 1e-13 + 2.0 * change);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_ends_show_what_is_prescribed_and_all_is_at_rest_before_the_load) {
  fixtures::RandomProblems random(5);
  for (int trial = 0; trial < 20; ++trial) {
    const Problem problem = random_problem(random, random.log_uniform(0.1, 1e3));
    const double t = problem.load.duration() * random.uniform(0.1, 2.0);
    const ModalSolution solution(problem, t, 1e-10);
    const Fields start = solution.at(0.0).value;
    const Fields end = solution.at(*problem.column.length).value;
    const double q = problem.load.value(t);
    const bool traction = problem.column.near == NearEnd::drained_traction;
    const double scale = 1e-12 * problem.stress_scale();
    BOOST_TEST(std::abs(start.effective_stress + (traction ? q : 0.0)) < scale);
    BOOST_TEST(std::abs(start.pore_pressure - (traction ? 0.0 : q)) < scale);
    BOOST_TEST(std::abs(end.solid_velocity) < 1e-12 * problem.velocity_scale());
    BOOST_TEST(std::abs(end.fluid_velocity) < 1e-12 * problem.velocity_scale());
    const ModalSolution before(problem, -t);
    BOOST_TEST(largest_share(problem, before.at(0.5 * *problem.column.length).value) == 0.0);
    BOOST_TEST(largest_share(problem, before.on_grid(4).at(2).value) == 0.0);
  }
}

BOOST_AUTO_TEST_CASE(the_loaded_end_is_accurate_when_the_load_ends) {
  // There all modes are in phase: 131,072 of them, most below the rounding of their sum.
  const double T = 1e-5;
  const Problem problem = fixtures::paper_problem(Load(LoadShape::smooth_ramp, 1.0, T));
  for (const double t : {0.999 * T, T, 1.001 * T}) {
    const BoundedFields contour = ColumnSolution(problem).at(0.0, t);
    const BoundedFields sum = ModalSolution(problem, t).at(0.0);
    BOOST_TEST(distance(problem, sum.value, contour.value) <=
               largest_share(problem, sum.error) + largest_share(problem, contour.error));
  }
}

BOOST_AUTO_TEST_CASE(the_grid_is_the_direct_sum) {
  fixtures::RandomProblems random(6);
  for (const int intervals : {1, 2, 7, 64, 1000}) {
    const Problem problem = random_problem(random, random.log_uniform(0.1, 50.0));
    const ModalSolution solution(problem, 1.3 * problem.load.duration(), 1e-10);
    const auto grid = solution.on_grid(intervals);
    BOOST_REQUIRE(grid.size() == static_cast<std::size_t>(intervals) + 1);
    for (int j = 0; j <= intervals; j += 1 + intervals / 20) {
      const double x = *problem.column.length * j / intervals;
      const auto direct = solution.at(x);
      const auto& at_node = grid[static_cast<std::size_t>(j)];
      BOOST_TEST(distance(problem, at_node.value, direct.value) < 1e-13);
      BOOST_TEST(as_array(at_node.error) == as_array(direct.error), tt::per_element());
    }
  }
}

BOOST_AUTO_TEST_CASE(random_problems_agree_with_the_contour_to_1e_10) {
  fixtures::RandomProblems random(7);
  double worst = 0.0;
  int compared = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Problem problem = random_problem(random, random.log_uniform(0.1, 1e4));
    const double length = *problem.column.length;
    const double x =
        length * (random.index(4) == 0 ? random.log_uniform(1e-6, 1.0) : random.uniform(0.0, 1.0));
    const double t = length / wave_speeds(problem.material).p1 * random.uniform(0.1, 4.0);
    const BoundedFields contour = ColumnSolution(problem).at(x, t);
    if (!(largest_share(problem, contour.error) < 1e-11)) continue;
    ++compared;
    const BoundedFields sum = ModalSolution(problem, t, 1e-11).at(x);
    const double difference = distance(problem, sum.value, contour.value);
    BOOST_TEST_CONTEXT(name(problem.column.near) << " " << name(problem.load.shape())) {
      BOOST_TEST(difference < 1e-10);
      BOOST_TEST(difference <=
                 largest_share(problem, sum.error) + largest_share(problem, contour.error));
    }
    worst = std::max(worst, difference);
  }
  BOOST_TEST(compared >= 45);
  BOOST_TEST_MESSAGE("modal sum and contour: " << compared << " problems, worst difference "
                                               << worst << " of the load");
}

BOOST_AUTO_TEST_CASE(what_cannot_be_done_is_said) {
  const Load smooth(LoadShape::smooth_ramp, 1.0, 1e-5);
  const auto refused = [](const Problem& problem, const std::string& words) {
    BOOST_TEST(ModalSolution::obstacle(problem).find(words) != std::string::npos);
    BOOST_CHECK_THROW(ModalSolution(problem, 1e-5), InputError);
  };
  refused(fixtures::paper_problem(), "load shape = \"step\": expected smooth_ramp");
  for (const NearEnd near : {NearEnd::sealed_traction, NearEnd::velocity}) {
    Problem problem = fixtures::paper_problem(smooth);
    problem.column.near = near;
    refused(problem, "expected near = \"drained_traction\" or");
  }
  for (const FarEnd far : {FarEnd::rigid_drained, FarEnd::free_drained, FarEnd::half_space}) {
    Problem problem = fixtures::paper_problem(smooth);
    problem.column.far = far;
    if (far == FarEnd::half_space) problem.column.length.reset();
    refused(problem, "far = \"rigid_sealed\"");
  }
  const Problem problem = fixtures::paper_problem(smooth);
  BOOST_TEST(ModalSolution::obstacle(problem) == "");
  BOOST_CHECK_THROW(ModalSolution(problem, std::nan("")), InputError);
  BOOST_CHECK_THROW(ModalSolution(problem, 1e-5, 0.0), InputError);
  const ModalSolution solution(problem, 1e-5);
  BOOST_CHECK_THROW(solution.at(-1e-9), InputError);
  BOOST_CHECK_THROW(solution.at(0.11), InputError);
  BOOST_CHECK_THROW(solution.at(std::nan("")), InputError);
  BOOST_CHECK_THROW(solution.on_grid(0), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
