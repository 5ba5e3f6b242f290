#include "reference/modes.hpp"

#include <boost/test/unit_test.hpp>
#include <numbers>

#include "reference/random_problems.hpp"

BOOST_AUTO_TEST_SUITE(modes)

using namespace porowave;
using namespace porowave::reference;

namespace {

Material random_material(fixtures::RandomProblems& random) {
  return random
      .next(random.log_uniform(1e-2, 1e3), Load(), NearEnd::drained_traction, FarEnd::half_space)
      .material;
}

/// Largest entry of A lambda^2 r - s (s D + d J) r relative to its terms.
double residual(const Material& m, Complex s, Complex lambda, Complex rs, Complex rf) {
  const double ns = m.solid_fraction();
  const double nf = m.porosity;
  const double K = m.storage_modulus();
  const double d = m.drag();
  const Complex l2 = lambda * lambda;
  const Complex solid = ((m.constrained_modulus + K * ns * ns) * rs + K * ns * nf * rf) * l2 -
                        s * (s * m.solid_partial_density() * rs + d * (rs - rf));
  const Complex fluid = (K * ns * nf * rs + K * nf * nf * rf) * l2 -
                        s * (s * m.fluid_partial_density() * rf - d * (rs - rf));
  const double size = (std::abs((m.constrained_modulus + K) * l2) +
                       std::abs(s) * (std::abs(s) * m.mixture_density() + d)) *
                      (std::abs(rs) + std::abs(rf));
  return std::max(std::abs(solid), std::abs(fluid)) / size;
}

}  // namespace

BOOST_AUTO_TEST_CASE(both_modes_solve_the_transformed_equations) {
  fixtures::RandomProblems random(1);
  for (int trial = 0; trial < 500; ++trial) {
    const Material m = random_material(random);
    const WaveModes modes(m);
    const Complex s = modes.relaxation_rate() *
                      std::polar(random.log_uniform(1e-4, 1e4), random.uniform(-3.1, 3.1));
    const ModeState state = modes.at(s);
    const Matrix2& R = modes.velocity_of_mode();
    const std::array<std::array<Complex, 2>, 2> e = {{{1.0, -state.mixing}, {state.mixing, 1.0}}};
    for (std::size_t k = 0; k < 2; ++k) {
      const Complex rs = R[0][0] * e[k][0] + R[0][1] * e[k][1];
      const Complex rf = R[1][0] * e[k][0] + R[1][1] * e[k][1];
      BOOST_TEST(residual(m, s, s * state.slowness[k], rs, rf) < 1e-14);
      const Complex excess = s * state.slowness[k] - s / modes.speed(static_cast<int>(k));
      BOOST_TEST(std::abs(excess - state.excess[k]) < 1e-14 * std::abs(s * state.slowness[k]));
    }
  }
}

BOOST_AUTO_TEST_CASE(frozen_modes_are_orthonormal) {
  fixtures::RandomProblems random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const WaveModes modes(random_material(random));
    const Matrix2& R = modes.velocity_of_mode();
    const Matrix2& AR = modes.traction_of_mode();
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 2; ++j) {
        const double product = R[0][i] * AR[0][j] + R[1][i] * AR[1][j];
        BOOST_TEST(std::abs(product - (i == j ? 1.0 : 0.0)) < 1e-14);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(at_large_s_the_modes_are_frozen) {
  fixtures::RandomProblems random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const WaveModes modes(random_material(random));
    const double far = 1e7 * (modes.relaxation_rate() + std::abs(modes.branch_point()));
    const ModeState state = modes.at({0.6 * far, 0.8 * far});
    const ModeState frozen = modes.frozen();
    BOOST_TEST(std::abs(state.mixing) < 1e-6);
    for (std::size_t k = 0; k < 2; ++k) {
      BOOST_TEST(std::abs(state.slowness[k] / frozen.slowness[k] - 1.0) < 1e-6);
      BOOST_TEST(std::abs(state.excess[k] - frozen.excess[k]) < 1e-5 * std::abs(frozen.excess[1]));
    }
  }
}

/// The modes never jump along s(angle), 0 <= angle <= 2 pi.
template <class Contour>
void require_continuous(const WaveModes& modes, WaveModes::Cut cut, Contour&& s) {
  constexpr int nodes = 20000;
  ModeState before = modes.at(s(0.0), cut);
  for (int i = 1; i <= nodes; ++i) {
    const ModeState state = modes.at(s(2.0 * std::numbers::pi * i / nodes), cut);
    for (std::size_t k = 0; k < 2; ++k) {
      BOOST_REQUIRE(std::abs(state.excess[k] - before.excess[k]) <
                    0.05 * (std::abs(state.excess[k]) + std::abs(before.excess[k])));
    }
    BOOST_REQUIRE(std::abs(state.mixing - before.mixing) < 0.05 * (1 + std::abs(state.mixing)));
    before = state;
  }
}

BOOST_AUTO_TEST_CASE(the_modes_are_analytic_round_all_singularities) {
  fixtures::RandomProblems random(4);
  for (int trial = 0; trial < 50; ++trial) {
    const WaveModes modes(random_material(random));
    const double radius = 1.05 * std::max(modes.relaxation_rate(), std::abs(modes.branch_point()));
    require_continuous(modes, WaveModes::Cut::between,
                       [&](double angle) { return std::polar(radius, angle); });
    const Complex s = std::polar(radius, 1.0);
    BOOST_TEST(std::abs(modes.at(std::conj(s)).mixing - std::conj(modes.at(s).mixing)) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(cut_outwards_the_modes_are_those_of_large_s_on_all_of_the_real_axis) {
  // Light grains in much water: the modes meet right of 0.
  const WaveModes modes({0.97, 2000.0, 1000.0, 2.5e8, 2.0e9, 1e-10, 1e-3});
  const Complex branch = modes.branch_point();
  BOOST_REQUIRE(branch.real() > 0.0);
  require_continuous(modes, WaveModes::Cut::outwards, [&](double angle) {
    return branch.real() * std::exp(4.0 * (angle - std::numbers::pi));
  });
  const Complex far = 10.0 * branch.real();
  BOOST_TEST(std::abs(modes.at(far, WaveModes::Cut::outwards).excess[0] - modes.at(far).excess[0]) <
             1e-12 * std::abs(modes.at(far).excess[0]));
  // Cut between them, the two modes have changed places near 0.
  const Complex near = 0.01 * branch.real();
  BOOST_TEST(std::abs(modes.at(near, WaveModes::Cut::outwards).slowness[0] -
                      modes.at(near).slowness[1]) < 1e-10 * std::abs(modes.at(near).slowness[1]));
}

BOOST_AUTO_TEST_CASE(the_modes_meet_at_the_branch_point) {
  fixtures::RandomProblems random(5);
  for (int trial = 0; trial < 50; ++trial) {
    const WaveModes modes(random_material(random));
    const Complex branch = modes.branch_point();
    if (branch.imag() < 1e-6 * std::abs(branch)) continue;
    const ModeState state = modes.at(branch * (1.0 + 1e-12));
    BOOST_TEST(std::abs(state.slowness[0] - state.slowness[1]) <
               1e-4 * std::abs(state.slowness[0]));
    BOOST_TEST(std::abs(state.mixing * state.mixing + 1.0) < 1e-3);
  }
}

BOOST_AUTO_TEST_SUITE_END()
