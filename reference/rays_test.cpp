#include "reference/rays.hpp"

#include <Eigen/Dense>
#include <boost/test/unit_test.hpp>

#include "reference/random_problems.hpp"

BOOST_AUTO_TEST_SUITE(rays)

using namespace porowave;
using namespace porowave::reference;

namespace {

/// The transformed fields at x from one 4x4 system for all four amplitudes, without rays.
FieldVector by_boundary_system(const Problem& problem, const WaveModes& modes, double s, double x) {
  const ModeState state = modes.at(s);
  const EndResponse ends = end_response(problem, modes, state);
  const ModeFields fields = mode_fields(problem.material, modes, state);
  const double length = *problem.column.length;
  // Unknown: up (leaving x = 0) and down (leaving x = length) amplitudes.
  Eigen::Matrix4cd matrix = Eigen::Matrix4cd::Identity();
  Eigen::Vector4cd right = Eigen::Vector4cd::Zero();
  for (int k = 0; k < 2; ++k) {
    const auto mode = static_cast<std::size_t>(k);
    const Complex decay = std::exp(-s * state.slowness[mode] * length);
    for (int row = 0; row < 2; ++row) {
      const auto r = static_cast<std::size_t>(row);
      matrix(row, 2 + k) -= ends.at_near[r][mode] * decay;
      matrix(2 + row, k) -= ends.at_far[r][mode] * decay;
    }
    right(k) = ends.source[mode];
  }
  const Eigen::Vector4cd amplitude = matrix.partialPivLu().solve(right);
  FieldVector result{};
  for (std::size_t mode = 0; mode < 2; ++mode) {
    const Complex lambda = s * state.slowness[mode];
    for (std::size_t f = 0; f < 4; ++f) {
      const auto k = static_cast<Eigen::Index>(mode);
      result[f] += fields.up[mode][f] * amplitude(k) * std::exp(-lambda * x) +
                   fields.down[mode][f] * amplitude(2 + k) * std::exp(-lambda * (length - x));
    }
  }
  return result;
}

}  // namespace

BOOST_AUTO_TEST_CASE(their_sum_is_the_solution_of_the_boundary_system) {
  fixtures::RandomProblems random(1);
  for (int trial = 0; trial < 120; ++trial) {
    const auto near = static_cast<NearEnd>(trial % 4);
    const auto far = static_cast<FarEnd>(trial / 4 % 3);
    const Problem problem = random.next(random.log_uniform(0.01, 100), Load(), near, far);
    const WaveModes modes(problem.material);
    const double length = *problem.column.length;
    const double x = random.uniform(0.0, length);
    const double s = 3.0 * modes.speed(0) / length;
    const auto rays = rays_until(problem, modes, x, 14.0 * length / modes.speed(0));
    FieldVector sum{};
    RaySum(problem, rays)
        .at(wave_state(problem, modes, modes.at(s)),
            [&](std::size_t r, const FieldVector& field, Complex exponent) {
              const Complex factor = std::exp(exponent - s * rays[r].arrival);
              for (std::size_t f = 0; f < 4; ++f) sum[f] += field[f] * factor;
            });
    const FieldVector expected = by_boundary_system(problem, modes, s, x);
    // What is missing has been on its way for 14 crossings: e^(-42).
    for (std::size_t f = 0; f < 4; ++f) {
      const double size = std::abs(expected[f & 2u]) + std::abs(expected[f | 1u]);
      BOOST_TEST_CONTEXT(name(near) << " " << name(far) << " field " << f) {
        BOOST_TEST(std::abs(sum[f] - expected[f]) < 1e-11 * size);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(every_path_is_counted_once) {
  fixtures::RandomProblems random(2);
  const Problem fixed = random.next(1.0, Load(), NearEnd::drained_traction, FarEnd::rigid_sealed);
  const Problem converting =
      random.next(1.0, Load(), NearEnd::sealed_traction, FarEnd::rigid_drained);
  for (const Problem& problem : {fixed, converting}) {
    const WaveModes modes(problem.material);
    const double length = *problem.column.length;
    const double until = 7.5 * length / modes.speed(1);
    const auto rays = rays_until(problem, modes, 0.0, until);
    const bool conversion = converts(problem.column.near);
    std::size_t expected = 0;
    for (int crossings = 0; crossings < 1000; ++crossings) {
      const double last = crossings % 2 == 0 ? 0.0 : length;
      for (int slow = 0; slow <= crossings; ++slow) {
        for (int mode = 0; mode < 2; ++mode) {
          if (!conversion && slow != (mode == 0 ? 0 : crossings)) continue;
          const double arrival = (crossings - slow) * length / modes.speed(0) +
                                 slow * length / modes.speed(1) + last / modes.speed(mode);
          expected += arrival <= until ? 1 : 0;
        }
      }
    }
    BOOST_TEST(rays.size() == expected);
    for (const Ray& ray : rays) BOOST_TEST(ray.arrival <= until);
  }
}

BOOST_AUTO_TEST_SUITE_END()
