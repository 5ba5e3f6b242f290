#include "verification/wave_measures/mode_amplitudes.hpp"

#include <boost/test/unit_test.hpp>
#include <random>

#include "verification/wave_measures/energy_drift.hpp"
#include "verification/wave_measures/wave_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(mode_amplitudes)

using namespace porowave;
using namespace porowave::verification;

namespace {

const std::array<Material, 3> materials = {{{0.4, 2650.0, 1000.0, 5.0e9, 2.2e9, 1e-11, 1e-3},
                                            {0.1, 2700.0, 800.0, 2.0e7, 2.2e9, 1e-13, 1e-3},
                                            {0.7, 1200.0, 1000.0, 9.0e9, 1.0e8, 1e-9, 1e-3}}};

/// A wave of one frozen mode with unit y, up or down: from v = r_k f(x -+ c t) by the equations of
/// stress and pressure alone.
Fields pure_wave(const Material& m, std::size_t mode, double direction) {
  const reference::WaveModes modes(m);
  const double rs = modes.velocity_of_mode()[0][mode];
  const double rf = modes.velocity_of_mode()[1][mode];
  const double slowness = direction / modes.speed(static_cast<int>(mode));
  const double squeezed = m.solid_fraction() * rs + m.porosity * rf;
  return {-m.constrained_modulus * rs * slowness, m.storage_modulus() * squeezed * slowness, rs,
          rf};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_wave_of_one_mode_and_direction_is_in_its_own_amplitude_alone) {
  for (const Material& m : materials) {
    const ModeAmplitudes amplitudes(m);
    for (std::size_t mode : {0u, 1u}) {
      const double unit = 1.0 / amplitudes.speed(static_cast<int>(mode));
      for (const double direction : {1.0, -1.0}) {
        for (const int other : {0, 1}) {
          const auto found = amplitudes.at(other, pure_wave(m, mode, direction));
          const bool same = other == static_cast<int>(mode);
          BOOST_TEST(std::abs(found.up / unit - (same && direction > 0)) < 1e-11);
          BOOST_TEST(std::abs(found.down / unit - (same && direction < 0)) < 1e-11);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(their_squares_add_up_to_the_density_of_energy) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const Material& m : materials) {
    const ModeAmplitudes amplitudes(m);
    const double impedance = m.mixture_density() * m.undrained_speed();
    for (int trial = 0; trial < 10; ++trial) {
      const Fields f{uniform(random), uniform(random), uniform(random) / impedance,
                     uniform(random) / impedance};
      double sum = 0.0;
      for (const int mode : {0, 1}) {
        const auto [up, down] = amplitudes.at(mode, f);
        sum += up * up + down * down;
      }
      // One cell of unit length with the same velocities at its two nodes.
      const std::array s = {f.effective_stress};
      const std::array p = {f.pore_pressure};
      const std::array vs = {f.solid_velocity, f.solid_velocity};
      const std::array vf = {f.fluid_velocity, f.fluid_velocity};
      BOOST_TEST(sum == grid_energy(m, {s, p, vs, vf}, 1.0), boost::test_tools::tolerance(1e-12));
    }
  }
}

BOOST_AUTO_TEST_CASE(profiles_take_the_mean_of_the_velocities_at_the_two_nodes) {
  const ModeAmplitudes amplitudes(materials[0]);
  const auto linear = [](double x) { return Fields{1.0 + x, 2.0 - x, 3e-7 * x, 1e-7 - x * 1e-7}; };
  const solver::Snapshot s = wave_fixtures::snapshot_of(linear, 0.0, 5, 1.0);
  for (const int mode : {0, 1}) {
    const auto profiles = amplitudes.of(mode, grid_fields(s));
    BOOST_REQUIRE(profiles.up.size() == 5u);
    for (std::size_t c = 0; c < 5; ++c) {
      const auto [up, down] = amplitudes.at(mode, linear(s.cell_x[c]));
      BOOST_TEST(profiles.up[c] == up, boost::test_tools::tolerance(1e-12));
      BOOST_TEST(profiles.down[c] == down, boost::test_tools::tolerance(1e-12));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
