#include "reference/waves.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>
#include <numbers>

#include "reference/boundary.hpp"
#include "reference/problem/errors.hpp"
#include "reference/problem/problem_fixtures.hpp"
#include "reference/random_problems.hpp"

BOOST_AUTO_TEST_SUITE(waves)

using namespace porowave;
using namespace porowave::reference;
namespace tt = boost::test_tools;

namespace {

constexpr double pi = std::numbers::pi;

/// From soft clay to foamed metal: porosity 0.02 to 0.98, E/K_f 1e-5 to 1e5, any permeability.
Material random_material(fixtures::RandomProblems& random) {
  Material m{random.uniform(0.02, 0.98),    random.uniform(1500, 4000),
             random.uniform(600, 1400),     1.0,
             random.log_uniform(1e7, 1e10), random.log_uniform(1e-18, 1e-6),
             random.log_uniform(1e-4, 1e-1)};
  m.constrained_modulus = m.fluid_bulk_modulus * random.log_uniform(1e-5, 1e5);
  return m;
}

/// Stiff skeletons of high porosity, in some of which P1 is the wave that diffuses.
Material random_foam(fixtures::RandomProblems& random) {
  Material m = random_material(random);
  m.porosity = random.uniform(0.95, 0.99);
  m.constrained_modulus = m.fluid_bulk_modulus * random.log_uniform(0.1, 1.0);
  return m;
}

double characteristic(const Material& m) {
  return wave_scales(m).characteristic_frequency;
}

std::size_t undrained_index(const WaveModes& modes) {
  return static_cast<std::size_t>(undrained_mode(modes));
}

/// Observed order between two errors whose parameter differs by `factor`.
double order(double larger, double smaller, double factor) {
  return std::log(larger / smaller) / std::log(factor);
}

}  // namespace

BOOST_AUTO_TEST_CASE(scales_of_the_papers_column) {
  const WaveScales scales = wave_scales(fixtures::paper_material());
  BOOST_TEST(scales.p1 == 2297.73, tt::tolerance(5e-6));
  BOOST_TEST(scales.p2 == 1144.72, tt::tolerance(5e-6));
  BOOST_TEST(scales.undrained == 2297.04, tt::tolerance(5e-6));
  BOOST_TEST(scales.drained == std::sqrt(5e9 / (0.6 * 2650.0 + 0.4 * 1000.0)),
             tt::tolerance(1e-14));
  BOOST_TEST(scales.dry_skeleton == std::sqrt(5e9 / (0.6 * 2650.0)), tt::tolerance(1e-14));
  BOOST_TEST(scales.consolidation == 1e-8 * 5e9 * 5.5e9 / 10.5e9, tt::tolerance(1e-14));
  BOOST_TEST(scales.relaxation_rate == 1.6e7 * (1.0 / 1590.0 + 1.0 / 400.0), tt::tolerance(1e-14));
  BOOST_TEST(scales.characteristic_frequency == scales.relaxation_rate / (2 * pi),
             tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(dispersion_agrees_with_the_wave_numbers_where_these_keep_their_digits) {
  fixtures::RandomProblems random(1);
  for (int trial = 0; trial < 500; ++trial) {
    const Material m = trial % 4 > 0 ? random_material(random) : random_foam(random);
    const WaveModes modes(m);
    const double f = characteristic(m) * random.log_uniform(0.03, 30.0);
    const Complex s(0.0, 2 * pi * f);
    const ModeState state = modes.at(s);
    const auto waves = reference::dispersion(modes, f);
    for (std::size_t k = 0; k < 2; ++k) {
      const Complex lambda = s * state.slowness[k];
      BOOST_TEST(std::abs(waves[k].attenuation - lambda.real()) < 1e-12 * std::abs(lambda));
      BOOST_TEST(2 * pi * f / waves[k].phase_velocity == lambda.imag(), tt::tolerance(1e-12));
      const Complex modulus = 1.0 / (state.slowness[k] * state.slowness[k]);
      BOOST_TEST(std::abs(waves[k].inverse_q - modulus.imag() / modulus.real()) <
                 1e-12 * std::abs(modulus) / modulus.real());
    }
  }
}

BOOST_AUTO_TEST_CASE(no_wave_gains_energy_or_outruns_the_fast_front) {
  fixtures::RandomProblems random(2);
  for (int trial = 0; trial < 2000; ++trial) {
    const Material m = trial % 4 > 0 ? random_material(random) : random_foam(random);
    const WaveModes modes(m);
    for (const auto& wave :
         reference::dispersion(modes, characteristic(m) * random.log_uniform(1e-14, 1e14))) {
      BOOST_TEST(std::isfinite(wave.attenuation));
      BOOST_TEST(wave.attenuation >= 0.0);
      BOOST_TEST(wave.inverse_q >= 0.0);
      BOOST_TEST(wave.phase_velocity > 0.0);
      BOOST_TEST(wave.phase_velocity <= modes.speed(0) * (1 + 1e-14));
    }
  }
}

BOOST_AUTO_TEST_CASE(what_a_wave_loses_goes_into_drag) {
  // Mean power through a section, -Re(T . conj V)/2, falls by mean drag power d |v_s - v_f|^2/2.
  fixtures::RandomProblems random(3);
  for (int trial = 0; trial < 500; ++trial) {
    const Material m = trial % 4 > 0 ? random_material(random) : random_foam(random);
    const WaveModes modes(m);
    const double f = characteristic(m) * random.log_uniform(1e-3, 1e3);
    const auto waves = reference::dispersion(modes, f);
    const ModeFields fields = mode_fields(m, modes, modes.at({0.0, 2 * pi * f}));
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& [stress, pressure, solid, fluid] = fields.up[k];
      const Complex total = stress - m.solid_fraction() * pressure;
      const double flux =
          -0.5 * (total * std::conj(solid) - m.porosity * pressure * std::conj(fluid)).real();
      const double drag_power = 0.5 * m.drag() * std::norm(solid - fluid);
      // v_s - v_f is a difference: rounded by the drag power of either alone.
      const double rounding = 1e-14 * std::sqrt(m.drag() * drag_power) * std::abs(solid);
      BOOST_TEST(std::abs(2 * waves[k].attenuation * flux - drag_power) <
                 1e-10 * drag_power + 10.0 * rounding * std::sqrt(m.drag()));
    }
  }
}

BOOST_AUTO_TEST_CASE(velocity_and_attenuation_are_causal) {
  // Kramers-Kronig: 1/v(w) - 1/c = (2/pi) integral (alpha(w') - alpha(w))/(w'^2 - w^2) dw'. By the
  // trapezoidal rule in log w', half a step off the removable singularity.
  for (const double permeability : {1e-12, 1e-10}) {
    Material m = fixtures::paper_material();
    m.intrinsic_permeability = permeability;
    const WaveModes modes(m);
    for (const double ratio : {0.1, 1.0, 7.0}) {
      const double f = ratio * characteristic(m);
      const auto here = reference::dispersion(modes, f);
      constexpr double step = 0.05;
      std::array<double, 2> integral{};
      for (int i = -1000; i < 1000; ++i) {
        const double u = std::exp((i + 0.5) * step);
        const auto there = reference::dispersion(modes, f * u);
        for (std::size_t k = 0; k < 2; ++k) {
          integral[k] += step * u * (there[k].attenuation - here[k].attenuation) / (u * u - 1);
        }
      }
      for (std::size_t k = 0; k < 2; ++k) {
        const double expected = 2 / pi * integral[k] / (2 * pi * f);
        const double lag = 1 / here[k].phase_velocity - 1 / modes.speed(static_cast<int>(k));
        BOOST_TEST(lag == expected, tt::tolerance(1e-9));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(at_high_frequency_the_waves_are_frozen) {
  fixtures::RandomProblems random(4);
  for (int trial = 0; trial < 100; ++trial) {
    const Material m = trial % 4 > 0 ? random_material(random) : random_foam(random);
    const WaveModes modes(m);
    const ModeState frozen = modes.frozen();
    // What drag rate and branch points are small against.
    const double f = std::max(characteristic(m), std::abs(modes.branch_point()) / (2 * pi));
    const auto waves = reference::dispersion(modes, 1e6 * f);
    for (std::size_t k = 0; k < 2; ++k) {
      BOOST_TEST(waves[k].phase_velocity == modes.speed(static_cast<int>(k)), tt::tolerance(1e-9));
      BOOST_TEST(waves[k].attenuation == frozen.excess[k].real(), tt::tolerance(1e-6));
    }
  }
}

BOOST_AUTO_TEST_CASE(at_low_frequency_one_wave_is_undrained_with_an_error_of_second_order) {
  fixtures::RandomProblems random(5);
  double lowest = 2.0;
  double highest = 2.0;
  int exchanged = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Material m = trial % 4 > 0 ? random_material(random) : random_foam(random);
    const WaveModes modes(m);
    const WaveScales scales = wave_scales(m);
    const std::size_t k = undrained_index(modes);
    exchanged += static_cast<int>(k);
    const auto error = [&](double ratio) {
      const double f = ratio * scales.characteristic_frequency;
      return std::abs(reference::dispersion(modes, f)[k].phase_velocity / scales.undrained - 1.0);
    };
    if (error(1e-2) < 1e-9) continue;  // both phases move together at any frequency
    const double observed = order(error(1e-2), error(2e-3), 5.0);
    lowest = std::min(lowest, observed);
    highest = std::max(highest, observed);
    BOOST_TEST(error(1e-8) < 1e-13);
  }
  BOOST_TEST_MESSAGE("order of the undrained phase velocity: "
                     << lowest << " to " << highest << "; " << exchanged
                     << " of 200 materials have it as P2");
  BOOST_TEST(lowest > 1.95);
  BOOST_TEST(highest < 2.05);
  BOOST_TEST(exchanged > 0);
}

BOOST_AUTO_TEST_CASE(at_low_frequency_the_other_wave_diffuses_with_an_error_of_first_order) {
  fixtures::RandomProblems random(6);
  double lowest = 1.0;
  double highest = 1.0;
  for (int trial = 0; trial < 200; ++trial) {
    const Material m = trial % 4 > 0 ? random_material(random) : random_foam(random);
    const WaveModes modes(m);
    const WaveScales scales = wave_scales(m);
    const auto error = [&](double ratio) {
      const double f = ratio * scales.characteristic_frequency;
      const double diffusive = std::sqrt(pi * f / scales.consolidation);
      return std::abs(
          reference::dispersion(modes, f)[1 - undrained_index(modes)].attenuation / diffusive - 1);
    };
    const double observed = order(error(1e-4), error(1e-5), 10.0);
    lowest = std::min(lowest, observed);
    highest = std::max(highest, observed);
  }
  BOOST_TEST_MESSAGE("order of the diffusive attenuation: " << lowest << " to " << highest);
  BOOST_TEST(lowest > 0.98);
  BOOST_TEST(highest < 1.02);
}

BOOST_AUTO_TEST_CASE(attenuation_of_the_undrained_wave_keeps_its_digits) {
  // alpha ~ f^2 however far below the characteristic frequency, here down to 1e-14 of it, where
  // Re lambda would be rounding only.
  fixtures::RandomProblems random(7);
  for (int trial = 0; trial < 100; ++trial) {
    const Material m = trial % 4 > 0 ? random_material(random) : random_foam(random);
    const WaveModes modes(m);
    const std::size_t k = undrained_index(modes);
    const auto attenuation = [&](double ratio) {
      return reference::dispersion(modes, ratio * characteristic(m))[k].attenuation;
    };
    BOOST_TEST(attenuation(1e-14) / attenuation(1e-8) == 1e-12, tt::tolerance(1e-8));
  }
}

BOOST_AUTO_TEST_CASE(a_stiff_foam_exchanges_the_names_of_its_waves) {
  const Material foam{0.98, 2650.0, 1000.0, 4.6e8, 2.2e9, 1e-9, 1e-3};
  const WaveModes modes(foam);
  BOOST_TEST(undrained_mode(modes) == 1);
  const auto waves = reference::dispersion(modes, 1e-8 * characteristic(foam));
  BOOST_TEST(waves[1].phase_velocity == foam.undrained_speed(), tt::tolerance(1e-10));
  BOOST_TEST(waves[0].phase_velocity < 1.0);
  BOOST_TEST(undrained_mode(WaveModes(fixtures::paper_material())) == 0);
}

BOOST_AUTO_TEST_CASE(a_frequency_that_is_none_is_refused) {
  const WaveModes modes(fixtures::paper_material());
  for (const double f : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::quiet_NaN()}) {
    BOOST_CHECK_THROW(reference::dispersion(modes, f), InputError);
  }
}

BOOST_AUTO_TEST_SUITE_END()
