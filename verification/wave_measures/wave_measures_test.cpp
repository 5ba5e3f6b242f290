#include "verification/wave_measures/wave_measures.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <set>

#include "verification/gate/gate.hpp"
#include "verification/process/scratch_directory.hpp"
#include "verification/run.hpp"
#include "verification/sweep/sweep.hpp"
#include "verification/wave_measures/wave_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(wave_measures)

using namespace porowave;
using namespace porowave::verification;

BOOST_AUTO_TEST_CASE(every_number_stands_under_its_name) {
  WaveMeasures m;
  m.arrival_delay = {-1.0, 2.0};
  for (std::size_t f = 0; f < 4; ++f) {
    const double d = 10.0 * static_cast<double>(f + 1);
    m.overshoot[f] = {d + 1.0, d + 2.0};
    m.ringing[f] = {d + 3.0, d + 4.0};
  }
  m.gap = {-5.0, 6.0};
  m.energy = {-7.0, 8.0};
  const auto values = wave_measure_values(m);
  const auto& names = wave_measure_names();
  BOOST_REQUIRE(values.size() == names.size());
  const auto value = [&](const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    BOOST_REQUIRE_MESSAGE(found != names.end(), name);
    return values[static_cast<std::size_t>(found - names.begin())];
  };
  BOOST_TEST(value("fast_arrival_delay") == -1.0);
  BOOST_TEST(value("slow_arrival_delay") == 2.0);
  BOOST_TEST(value("fast_arrival_error") == 1.0);
  BOOST_TEST(value("slow_arrival_error") == 2.0);
  BOOST_TEST(value("effective_stress_overshoot") == 11.0);
  BOOST_TEST(value("pore_pressure_total_variation") == 22.0);
  BOOST_TEST(value("solid_velocity_ringing") == 33.0);
  BOOST_TEST(value("fluid_velocity_ringing_share") == 44.0);
  BOOST_TEST(value("gap_reflected") == -5.0);
  BOOST_TEST(value("gap_transmitted") == 6.0);
  BOOST_TEST(value("energy_drift_points") == -7.0);
  BOOST_TEST(value("energy_drift_field") == 8.0);
  BOOST_TEST(value("energy_error_points") == 7.0);
  BOOST_TEST(value("energy_error_field") == 8.0);
}

BOOST_AUTO_TEST_CASE(names_are_unique_and_follow_those_that_were_there) {
  const auto& all = measure_names();
  BOOST_TEST(std::set<std::string>(all.begin(), all.end()).size() == all.size());
  BOOST_TEST(all[24] == "reference_error");
  BOOST_TEST(all[25] == "largest_strain");
  BOOST_TEST(std::vector<std::string>(all.begin() + 26, all.end()) == wave_measure_names(),
             boost::test_tools::per_element());
  // A gate without a list of measures takes all L2 errors; these are none.
  for (const std::string& name : wave_measure_names()) BOOST_TEST(!name.ends_with("_l2"), name);
}

BOOST_AUTO_TEST_CASE(a_perfect_run_has_perfect_measures) {
  solver::Case scene;
  scene.problem = wave_fixtures::column(Load(LoadShape::smooth_ramp, 1.0, 1e-5));
  scene.discretization.elements = 100;
  scene.time.end = 4e-5;
  const auto profile = reference_profile(scene);
  const auto perfect =
      wave_fixtures::snapshot_of([&](double x) { return profile->at(x); }, scene.time.end, 100);
  const auto m =
      verification::wave_measures(scene, *profile, perfect, reference_values(perfect, *profile));
  for (std::size_t f = 0; f < 4; ++f) {
    BOOST_TEST(m.overshoot[f].excess == 0.0);
    BOOST_TEST(m.overshoot[f].total_variation == 1.0);
    BOOST_TEST(m.ringing[f].amplitude == 0.0);
  }
  for (const double delay : m.arrival_delay) BOOST_TEST(std::abs(delay) < 1e-15);
  BOOST_TEST(m.energy.points == 0.0);
  BOOST_TEST(m.energy.field == 0.0);
  BOOST_TEST(std::isnan(m.gap.reflected));
}

BOOST_AUTO_TEST_CASE(a_gate_finds_order_two_in_arrival_and_energy) {
  const std::string text =
      "[material]\nporosity = 0.4\ngrain_density = 2650.0\nfluid_density = 1000.0\n"
      "constrained_modulus = 5.0e9\nfluid_bulk_modulus = 2.2e9\nintrinsic_permeability = 1.0e-11\n"
      "fluid_viscosity = 1.0e-3\n"
      "[column]\nlength = 0.1\nnear = \"drained_traction\"\nfar = \"rigid_sealed\"\n"
      "[load]\nshape = \"sin4_pulse\"\nmagnitude = 1.0\nduration = 2e-5\n"
      "[discretization]\nkernel = \"bspline2\"\nplacement = \"uniform\"\n"
      "[time]\nend = 3.0e-5\n[study]\nname = \"waves\"\n"
      "[axes]\n\"discretization.elements\" = [200, 400, 800]\n"
      "[refine]\nby = \"discretization.elements\"\n"
      "[gate]\norder = 2.0\norder_tolerance = 0.2\nmeasures = [\"fast_arrival_error\", "
      "\"slow_arrival_error\", \"energy_error_field\"]\n";
  const auto document = TomlDocument::parse(text, "study.toml");
  const Study study = read_study(document);
  const ScratchDirectory directory;
  Store store = Store::create_or_open(directory.file("results"));
  porowave::verification::sweep(study, store, {.jobs = 1});
  const auto verdicts = judge(groups_of(study, store), read_gate_rules(document, study), {});
  BOOST_TEST(verdicts.size() == 3U);
  for (const Verdict& verdict : verdicts) {
    BOOST_TEST_MESSAGE(verdict.measure << ": " << verdict.reason);
    BOOST_TEST((verdict.kind == VerdictKind::pass), verdict.measure);
  }
}

BOOST_AUTO_TEST_SUITE_END()
