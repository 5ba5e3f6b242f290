#include "reference/boundary.hpp"

#include <boost/test/unit_test.hpp>
#include <numbers>

#include "reference/random_problems.hpp"

BOOST_AUTO_TEST_SUITE(boundary)

using namespace porowave;
using namespace porowave::reference;

namespace {

/// Fields at an end from arriving and leaving amplitudes; `up` names those that travel up.
FieldVector fields_at_end(const ModeFields& modes, const Amplitudes& up, const Amplitudes& down) {
  FieldVector fields{};
  for (std::size_t f = 0; f < 4; ++f) {
    for (std::size_t k = 0; k < 2; ++k) {
      fields[f] += modes.up[k][f] * up[k] + modes.down[k][f] * down[k];
    }
  }
  return fields;
}

/// The two prescribed combinations at the near end, each divided by the size of its terms.
std::array<Complex, 2> near_residual(NearEnd end, const FieldVector& f, double load, double c) {
  switch (end) {
    case NearEnd::drained_traction:
      return {f[0] + load, f[1]};
    case NearEnd::fluid_pressure:
      return {f[0], f[1] - load};
    case NearEnd::velocity:
      return {c * (f[2] - load), c * (f[3] - load)};
    case NearEnd::sealed_traction:
      return {f[0] - f[1] + load, c * (f[2] - f[3])};
  }
  return {};
}

std::array<Complex, 2> far_residual(FarEnd end, const FieldVector& f, double c) {
  switch (end) {
    case FarEnd::rigid_sealed:
      return {c * f[2], c * f[3]};
    case FarEnd::rigid_drained:
      return {c * f[2], f[1]};
    case FarEnd::free_drained:
      return {f[0], f[1]};
    case FarEnd::half_space:
      return {};
  }
  return {};
}

/// Integrals of all reflection coefficients round a circle about 0, over its radius.
std::array<Complex, 8> integrals_round(const Problem& problem, const WaveModes& modes,
                                       double radius, int nodes) {
  std::array<Complex, 8> integrals{};
  for (int i = 0; i < nodes; ++i) {
    const Complex s = std::polar(radius, 2.0 * std::numbers::pi * (i + 0.5) / nodes);
    const EndResponse ends = end_response(problem, modes, modes.at(s));
    for (std::size_t j = 0; j < 4; ++j) {
      integrals[j] += s * ends.at_near[j / 2][j % 2] / static_cast<double>(nodes);
      integrals[4 + j] += s * ends.at_far[j / 2][j % 2] / static_cast<double>(nodes);
    }
  }
  return integrals;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_end_gets_what_is_prescribed_there) {
  fixtures::RandomProblems random(1);
  for (int trial = 0; trial < 400; ++trial) {
    const auto near = static_cast<NearEnd>(trial % 4);
    const auto far = static_cast<FarEnd>(random.index(3));
    const Problem problem = random.next(random.log_uniform(0.01, 1e3), Load(), near, far);
    const WaveModes modes(problem.material);
    const double impedance = problem.material.mixture_density() * modes.speed(0);
    const Complex s = modes.relaxation_rate() *
                      std::polar(random.log_uniform(1e-2, 1e2), random.uniform(-2.5, 2.5));
    const ModeState state = modes.at(s);
    const EndResponse ends = end_response(problem, modes, state);
    const ModeFields fields = mode_fields(problem.material, modes, state);
    const double unit = near == NearEnd::velocity ? impedance : 1.0;

    const FieldVector loaded = fields_at_end(fields, ends.source, {});
    for (const Complex r : near_residual(near, loaded, 1.0, impedance)) {
      BOOST_TEST(std::abs(r) < 1e-12 * unit);
    }
    for (std::size_t mode = 0; mode < 2; ++mode) {
      Amplitudes arriving{};
      arriving[mode] = 1.0;
      const Amplitudes from_near = {ends.at_near[0][mode], ends.at_near[1][mode]};
      const FieldVector at_near = fields_at_end(fields, from_near, arriving);
      const double size = impedance * (std::abs(at_near[2]) + std::abs(at_near[3])) +
                          std::abs(at_near[0]) + std::abs(at_near[1]) +
                          std::abs(fields.up[mode][0]) + impedance * std::abs(fields.up[mode][2]);
      for (const Complex r : near_residual(near, at_near, 0.0, impedance)) {
        BOOST_TEST(std::abs(r) < 1e-12 * size);
      }
      const Amplitudes from_far = {ends.at_far[0][mode], ends.at_far[1][mode]};
      for (const Complex r :
           far_residual(far, fields_at_end(fields, arriving, from_far), impedance)) {
        BOOST_TEST(std::abs(r) < 1e-12 * size);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(only_ends_that_mix_stress_and_velocity_convert) {
  fixtures::RandomProblems random(2);
  for (int near = 0; near < 4; ++near) {
    for (int far = 0; far < 3; ++far) {
      const Problem problem =
          random.next(1.0, Load(), static_cast<NearEnd>(near), static_cast<FarEnd>(far));
      const WaveModes modes(problem.material);
      const EndResponse ends =
          end_response(problem, modes, modes.at({modes.relaxation_rate(), 1.0}));
      BOOST_TEST((std::abs(ends.at_near[0][1]) > 1e-9) == converts(problem.column.near));
      BOOST_TEST((std::abs(ends.at_far[0][1]) > 1e-9) == converts(problem.column.far));
    }
  }
}

BOOST_AUTO_TEST_CASE(conversion_has_no_poles_outside_of_the_singularities_of_the_modes) {
  // A contour may only be closed round the singularities of the modes if the ends add none: the
  // integral of their reflections round a closed curve is then the same near them and far away.
  fixtures::RandomProblems random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const Problem problem =
        random.next(1.0, Load(), NearEnd::sealed_traction, FarEnd::rigid_drained);
    const WaveModes modes(problem.material);
    const double size = std::max(modes.relaxation_rate(), std::abs(modes.branch_point()));
    const auto near_integral = integrals_round(problem, modes, 1.02 * size, 8192);
    const auto far_integral = integrals_round(problem, modes, 4.0 * size, 1024);
    for (std::size_t i = 0; i < near_integral.size(); ++i) {
      BOOST_TEST(std::abs(near_integral[i] - far_integral[i]) <
                 1e-9 * (size + std::abs(far_integral[i])));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
