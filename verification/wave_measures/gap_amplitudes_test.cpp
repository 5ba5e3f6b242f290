#include "verification/wave_measures/gap_amplitudes.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "verification/run.hpp"
#include "verification/wave_measures/wave_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(gap_amplitudes)

using namespace porowave;
using namespace porowave::verification;
using wave_fixtures::column;
using wave_fixtures::scaled;
using wave_fixtures::snapshot_of;
using wave_fixtures::sum;
using wave_fixtures::values_of;

namespace {

constexpr double length = 0.1;
constexpr int cells = 101;

solver::Case papers_case(const Load& load, double permeability) {
  solver::Case scene;
  scene.problem = column(load, permeability);
  scene.discretization.elements = cells;
  scene.discretization.empty_elements = {0.05};
  scene.time.end = 4e-5;
  return scene;
}

/// The fast wave running downwards with an amplitude of ModeAmplitudes.
Fields downwards(const Material& m, double amplitude) {
  const reference::WaveModes modes(m);
  const double rs = modes.velocity_of_mode()[0][0];
  const double rf = modes.velocity_of_mode()[1][0];
  return {m.constrained_modulus * rs * amplitude,
          -m.storage_modulus() * (m.solid_fraction() * rs + m.porosity * rf) * amplitude,
          modes.speed(0) * rs * amplitude, modes.speed(0) * rf * amplitude};
}

/// The reference with the fast wave reflected at the load side of the gap and let through behind.
GapAmplitudes superposed(const solver::Case& scene, double reflected, double transmitted) {
  const reference::Profile profile(reference::ColumnSolution(scene.problem), scene.time.end,
                                   length);
  const ModeAmplitudes amplitudes(scene.problem.material);
  const double side = length / cells * 50;
  const auto found = [&](double x) {
    if (x > side + 0.25 * length / cells) return scaled(profile.at(x), transmitted);
    const double arrived = amplitudes.at(0, profile.at(2.0 * side - x)).up;
    return sum(profile.at(x), downwards(scene.problem.material, reflected * arrived));
  };
  return verification::gap_amplitudes(scene, snapshot_of(found, scene.time.end, cells),
                                      values_of([&](double x) { return profile.at(x); }, cells));
}

GapAmplitudes of_run(const solver::Case& scene) {
  return run_case(scene, *reference_profile(scene)).measures.gap;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_superposed_reflection_is_found_with_its_sign) {
  for (const LoadShape shape : {LoadShape::smooth_ramp, LoadShape::sin4_pulse, LoadShape::step}) {
    for (const double permeability : {1e-2, 1e-11}) {
      const solver::Case scene = papers_case(Load(shape, -2.0, 1e-5), permeability);
      for (const double r : {0.0, 0.3, 1.0, -0.5}) {
        const GapAmplitudes found = superposed(scene, r, 1.0 - r);
        // With drag the fast wave drags a little of the others along, which is not mirrored here.
        BOOST_TEST(std::abs(found.reflected - r) < (permeability > 1e-3 ? 1e-12 : 1e-8));
        BOOST_TEST(std::abs(found.transmitted - (1.0 - r)) < 1e-12);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(it_is_measured_between_the_passing_of_the_wave_and_its_return) {
  const auto defined = [](double end, const std::vector<double>& empty) {
    solver::Case scene = papers_case(Load(LoadShape::smooth_ramp, 1.0, 1e-5), 1e-2);
    scene.time.end = end;
    scene.discretization.empty_elements = empty;
    const GapAmplitudes found = superposed(scene, 0.0, 1.0);
    BOOST_TEST(std::isnan(found.reflected) == std::isnan(found.transmitted));
    return std::isfinite(found.reflected);
  };
  // The fast wave takes 43.5 us through the column; the ramp is 10 us long.
  BOOST_TEST(!defined(4e-5, {}));
  BOOST_TEST(!defined(3.1e-5, {0.05}));  // 22 us + 10 us
  BOOST_TEST(defined(3.3e-5, {0.05}));
  BOOST_TEST(defined(6.3e-5, {0.05}));  // 65 us: back from either end
  BOOST_TEST(!defined(6.6e-5, {0.05}));
  BOOST_TEST(!defined(4e-5, {0.03}));  // 39 us: reflected twice
  BOOST_TEST(!defined(4e-5, {0.05, 0.09}));
  BOOST_TEST(defined(4e-5, {0.05, 0.06}));
}

BOOST_AUTO_TEST_CASE(linear_shape_functions_reflect_everything) {
  solver::Case scene = papers_case(Load(LoadShape::smooth_ramp, 1.0, 1e-5), 1e-11);
  scene.discretization.transfer = solver::TransferName::shape;
  scene.discretization.kernel = solver::kernel_name<solver::BSpline1>;
  scene.discretization.support_radius = 1.0;
  scene.discretization.basis_order = 0;
  const GapAmplitudes gap = of_run(scene);
  BOOST_TEST_MESSAGE("reflected " << gap.reflected << ", transmitted " << gap.transmitted);
  BOOST_TEST(gap.transmitted == 0.0);
  BOOST_TEST(std::abs(gap.reflected - 1.0) < 0.02);
}

BOOST_AUTO_TEST_CASE(a_wide_weighting_lets_the_wave_pass) {
  solver::Case scene = papers_case(Load(LoadShape::smooth_ramp, 1.0, 1e-5), 1e-11);
  scene.discretization.elements = 201;
  scene.discretization.kernel = solver::kernel_name<solver::WendlandC2>;
  scene.discretization.support_radius = 5.0;
  const auto profile = reference_profile(scene);
  const GapAmplitudes gap = run_case(scene, *profile).measures.gap;
  solver::Case whole = scene;
  whole.discretization.empty_elements.clear();
  const auto snapshot = run_case(whole, *profile).snapshot;
  const auto without =
      verification::gap_amplitudes(scene, snapshot, reference_values(snapshot, *profile));
  BOOST_TEST_MESSAGE("reflected " << gap.reflected << ", transmitted " << gap.transmitted
                                  << "; without a gap " << without.reflected << ", "
                                  << without.transmitted);
  BOOST_TEST(std::abs(gap.transmitted - 1.0) < 0.01);
  BOOST_TEST(std::abs(gap.transmitted - without.transmitted) < 1e-3);
  BOOST_TEST(std::abs(gap.reflected - without.reflected) < 1e-3);
}

BOOST_AUTO_TEST_SUITE_END()
