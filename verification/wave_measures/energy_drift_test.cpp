#include "verification/wave_measures/energy_drift.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "reference/energy.hpp"
#include "reference/modes.hpp"
#include "verification/run.hpp"
#include "verification/wave_measures/wave_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(energy_drift)

using namespace porowave;
using namespace porowave::verification;
using wave_fixtures::column;
using wave_fixtures::scaled;
using wave_fixtures::snapshot_of;
using wave_fixtures::values_of;

namespace {

constexpr double length = 0.1;
constexpr int cells = 50;

/// A standing wave of the fast mode between rigid ends, without drag: v = r sin(k x) cos(k c t).
Fields standing_wave(const Material& m, double x, double t) {
  const reference::WaveModes modes(m);
  const double rs = modes.velocity_of_mode()[0][0];
  const double rf = modes.velocity_of_mode()[1][0];
  const double k = 3.0 * std::numbers::pi / length;
  const double c = modes.speed(0);
  const double strain = std::cos(k * x) * std::sin(k * c * t) / c;  // per unit of r
  return {m.constrained_modulus * rs * strain,
          -m.storage_modulus() * (m.solid_fraction() * rs + m.porosity * rf) * strain,
          rs * std::sin(k * x) * std::cos(k * c * t), rf * std::sin(k * x) * std::cos(k * c * t)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_standing_wave_keeps_the_energy_that_theory_gives_it) {
  // All kinetic at t = 0: 1/2 (n_s rho_s r_s^2 + n_f rho_f r_f^2) L/2; sums of squares of whole
  // half waves over a regular grid have no error.
  const Material m = column({}, 1e-2).material;
  const reference::WaveModes modes(m);
  const double rs = modes.velocity_of_mode()[0][0];
  const double rf = modes.velocity_of_mode()[1][0];
  const double energy =
      0.25 * length * (m.solid_partial_density() * rs * rs + m.fluid_partial_density() * rf * rf);
  for (const double t : {0.0, 3e-6, 1.1e-5, 4e-5}) {
    const auto s = snapshot_of([&](double x) { return standing_wave(m, x, t); }, t, cells);
    BOOST_TEST(grid_energy(m, grid_fields(s), length / cells) == energy,
               boost::test_tools::tolerance(1e-12));
    const auto before = values_of([&](double x) { return standing_wave(m, x, 7e-6); }, cells);
    const EnergyDrift drift = verification::energy_drift(m, s, before);
    BOOST_TEST(std::abs(drift.points) < 1e-12);
    BOOST_TEST(std::abs(drift.field) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(fields_a_tenth_too_large_have_a_fifth_too_much_energy) {
  const Material m = column({}).material;
  const auto wave = [&](double x) { return standing_wave(m, x, 5e-6); };
  const auto exact = values_of(wave, cells);
  for (const double factor : {1.1, 0.9, 0.0, 1.0}) {
    const auto s = snapshot_of([&](double x) { return scaled(wave(x), factor); }, 5e-6, cells);
    const EnergyDrift drift = verification::energy_drift(m, s, exact);
    BOOST_TEST(std::abs(drift.points - (factor * factor - 1.0)) < 1e-12);
    BOOST_TEST(std::abs(drift.field - (factor * factor - 1.0)) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(points_and_field_are_measured_each_by_itself) {
  const Material m = column({}).material;
  const auto wave = [&](double x) { return standing_wave(m, x, 5e-6); };
  const auto exact = values_of(wave, cells);
  auto s = snapshot_of(wave, 5e-6, cells);
  for (double& v : s.fluid.velocity) v = 0.0;
  BOOST_TEST(verification::energy_drift(m, s, exact).points < -1e-3);
  BOOST_TEST(verification::energy_drift(m, s, exact).field == 0.0);
  s = snapshot_of(wave, 5e-6, cells);
  for (double& p : s.pore_pressure) p *= 2.0;
  BOOST_TEST(verification::energy_drift(m, s, exact).points == 0.0);
  BOOST_TEST(verification::energy_drift(m, s, exact).field > 1e-3);
}

BOOST_AUTO_TEST_CASE(points_count_by_the_volume_of_their_own_phase) {
  const Material m = column({}).material;
  const auto wave = [&](double x) { return standing_wave(m, x, 5e-6); };
  const auto exact = values_of(wave, cells);
  for (const auto phase : {&solver::Snapshot::solid, &solver::Snapshot::fluid}) {
    auto s = snapshot_of(wave, 5e-6, cells);
    for (double& v : (s.*phase).velocity) v *= 2.0;
    for (double& q : (s.*phase).stress) q *= 2.0;
    BOOST_TEST(verification::energy_drift(m, s, exact).points > 1e-3);
    (s.*phase).volume.assign(s.solid.x.size(), 0.0);
    BOOST_TEST(verification::energy_drift(m, s, exact).points == 0.0);
  }
}

BOOST_AUTO_TEST_CASE(without_energy_or_with_a_nan_there_is_no_drift) {
  const Material m = column({}).material;
  const auto rest = [](double) { return Fields{}; };
  const auto wave = [&](double x) { return standing_wave(m, x, 5e-6); };
  BOOST_TEST(std::isnan(
      verification::energy_drift(m, snapshot_of(wave, 1.0, cells), values_of(rest, cells)).points));
  auto s = snapshot_of(wave, 1.0, cells);
  s.solid.stress[3] = s.effective_stress[3] = std::nan("");
  BOOST_TEST(std::isnan(verification::energy_drift(m, s, values_of(wave, cells)).points));
  BOOST_TEST(std::isnan(verification::energy_drift(m, s, values_of(wave, cells)).field));
}

BOOST_AUTO_TEST_CASE(sums_over_the_grid_tend_to_the_energy_of_the_reference) {
  const Problem problem = column(Load(LoadShape::smooth_ramp, 1.0, 1e-5));
  const reference::ColumnSolution solution(problem);
  const reference::Profile profile(solution, 4e-5, length);
  const auto balance = reference::energy_balance(solution, 4e-5);
  const double energy = balance.kinetic.value + balance.elastic.value;
  const auto difference = [&](int count) {
    const auto s = snapshot_of([&](double x) { return profile.at(x); }, 4e-5, count);
    return std::abs(grid_energy(problem.material, grid_fields(s), length / count) / energy - 1.0);
  };
  BOOST_TEST(difference(100) < 2e-3);
  BOOST_TEST(difference(400) < difference(100) / 10.0);
}

BOOST_AUTO_TEST_CASE(pic_loses_energy_and_flip_keeps_it) {
  const auto of_run = [](double flip) {
    solver::Case scene;
    scene.problem = column(Load(LoadShape::smooth_ramp, 1.0, 1e-5));
    scene.discretization.elements = 200;
    scene.time.end = 4e-5;
    scene.time.flip = flip;
    return run_case(scene, *reference_profile(scene)).measures.energy;
  };
  const EnergyDrift flip = of_run(1.0);
  const EnergyDrift pic = of_run(0.0);
  BOOST_TEST_MESSAGE("FLIP " << flip.points << ", " << flip.field << "; PIC " << pic.points << ", "
                             << pic.field);
  for (const auto drift : {&EnergyDrift::points, &EnergyDrift::field}) {
    BOOST_TEST(std::abs(flip.*drift) < 2e-3);
    BOOST_TEST((pic.*drift) < -5e-3);
  }
}

BOOST_AUTO_TEST_SUITE_END()
