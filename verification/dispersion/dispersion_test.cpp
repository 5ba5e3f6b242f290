#include "verification/dispersion/dispersion.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "reference/modes.hpp"
#include "reference/problem/problem_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(dispersion)

using namespace porowave;
using namespace porowave::verification;
namespace tt = boost::test_tools;
using std::numbers::pi;

namespace {

constexpr double h = 1e-3;

solver::Case scene_of(solver::TransferName transfer, const char* kernel,
                      double permeability = 1e-11) {
  solver::Case scene;
  scene.problem = fixtures::paper_problem();
  scene.problem.material.intrinsic_permeability = permeability;
  scene.discretization.transfer = transfer;
  scene.discretization.elements = 100;
  if (transfer == solver::TransferName::mls) {
    scene.discretization.kernel = *solver::kernel_from_name(kernel);
    scene.discretization.support_radius = natural_radius(scene.discretization.kernel);
  }
  return scene;
}

/// Relative error of the fast wave's frequency, for a wave of so many cells.
double frequency_error(const solver::Case& scene, double courant, double cells_a_wave) {
  const double k = 2.0 * pi / (cells_a_wave * h);
  const double exact = travelling(exact_rates(scene.problem.material, k)).fast.imag();
  return travelling(SchemeDispersion(scene, courant).rates(k)).fast.imag() / exact - 1.0;
}

}  // namespace

// Without drag: two speeds, no damping. Strong drag: one wave with the undrained speed.
BOOST_AUTO_TEST_CASE(exact_rates_have_the_known_limits) {
  Material material = fixtures::paper_problem().material;
  const double k = 2.0 * pi / (10.0 * h);
  const WaveSpeeds speeds = wave_speeds(material);
  material.intrinsic_permeability = 1e8;
  const TravellingWaves free = travelling(exact_rates(material, k));
  BOOST_TEST(free.fast.imag() == k * speeds.p1, tt::tolerance(1e-12));
  BOOST_TEST(free.slow.value().imag() == k * speeds.p2, tt::tolerance(1e-12));
  BOOST_TEST(std::abs(free.fast.real()) < 1e-10 * free.fast.imag());
  material.intrinsic_permeability = 1e-17;
  const TravellingWaves held = travelling(exact_rates(material, k));
  BOOST_TEST(held.fast.imag() == k * material.undrained_speed(), tt::tolerance(1e-4));
  BOOST_TEST(!held.slow.has_value());
}

// The reference room solves the same equations for real frequency: λ(s) with s = the rate must be
// the wave number, i k = ± λ.
BOOST_AUTO_TEST_CASE(exact_rates_are_those_of_the_reference) {
  const Material material = fixtures::paper_problem().material;
  const reference::WaveModes modes(material);
  for (const double k : {300.0, 1e3, 5e3, 3e4}) {
    for (const std::complex<double> s : exact_rates(material, k)) {
      if (std::abs(s.imag()) < 1e-7 * std::abs(s)) continue;  // on the cut of the reference
      const auto state = modes.at(s);
      double least = 1e300;
      for (const auto& slowness : state.slowness) {
        const std::complex<double> square = slowness * s * slowness * s;
        least = std::min(least, std::abs(square + k * k) / (k * k));
      }
      BOOST_TEST(least < 1e-9);
    }
  }
}

BOOST_AUTO_TEST_CASE(long_waves_are_exact_with_the_order_of_the_scheme) {
  for (const char* kernel : {"bspline1", "bspline2", "wendland_c2"}) {
    const solver::Case scene = scene_of(solver::TransferName::mls, kernel);
    const double order =
        std::log2(frequency_error(scene, 0.5, 20.0) / frequency_error(scene, 0.5, 40.0));
    BOOST_TEST(std::abs(order - 2.0) < 0.1, kernel << ": order " << order);
  }
  solver::Case scene = scene_of(solver::TransferName::mls, "bspline2");
  scene.discretization.scheme = solver::Scheme::staggered4;
  scene.discretization.basis_order = 3;
  const double order =
      std::log2(frequency_error(scene, 0.01, 8.0) / frequency_error(scene, 0.01, 16.0));
  BOOST_TEST(std::abs(order - 4.0) < 0.3, "staggered4: order " << order);
}

// What nodes keep of a wave on its way to uniform points and back, by hat functions both ways.
double kept_by_points(double wave_number, int points_per_cell) {
  double sum = 0.0, kept = 0.0;
  for (int p = 0; p < points_per_cell; ++p) {
    const double x = (p + 0.5) / points_per_cell;  // from the node, in cells; and its mirror image
    const double weight = 1.0 - x;
    sum += weight;
    kept += weight * ((1.0 - x) + x * std::cos(wave_number * h));
  }
  return kept / sum;
}

// Strains follow the velocities of the nodes, q the same less what points smooth away: without
// drag the step of a wave is (1, −α; δ w, 1 − δ α), so |λ|² = det = 1 − δ α (1 − w), 2 − δ α = 2 Re
// λ.
BOOST_AUTO_TEST_CASE(flip_damps_what_points_smooth_away) {
  const solver::Case scene = scene_of(solver::TransferName::mls, "bspline1", 1e8);
  const SchemeDispersion scheme(scene, 0.5);
  for (const double cells_a_wave : {4.0, 10.0, 50.0}) {
    const double k = 2.0 * pi / (cells_a_wave * h);
    const double w = kept_by_points(k, scene.discretization.points_per_element);
    const TravellingWaves waves = travelling(scheme.rates(k));
    for (const std::complex<double> rate : {waves.fast, waves.slow.value()}) {
      const std::complex<double> step = std::exp(rate * scheme.time_step());
      BOOST_TEST(std::abs(std::norm(step) - 1.0 + 2.0 * (1.0 - step.real()) * (1.0 - w)) < 1e-9);
      BOOST_TEST(std::norm(step) < 1.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(pic_damps_more_than_flip) {
  solver::Case scene = scene_of(solver::TransferName::mls, "bspline2", 1e8);
  const double k = 2.0 * pi / (10.0 * h);
  const auto flip = travelling(SchemeDispersion(scene, 0.5).rates(k));
  scene.time.flip = 0.9;
  const auto mixed = travelling(SchemeDispersion(scene, 0.5).rates(k));
  BOOST_TEST(mixed.fast.real() < 1.1 * flip.fast.real());
  BOOST_TEST(flip.fast.real() < 0.0);
}

BOOST_AUTO_TEST_CASE(what_is_no_endless_grid_is_refused) {
  solver::Case scene = scene_of(solver::TransferName::mls, "bspline2");
  BOOST_CHECK_THROW(SchemeDispersion(scene, 0.5).rates(pi / h), std::invalid_argument);
  scene.discretization.placement = solver::Placement::stratified;
  BOOST_CHECK_THROW(SchemeDispersion(scene, 0.5), std::invalid_argument);
  scene.discretization.placement = solver::Placement::uniform;
  scene.discretization.empty_elements = {0.05};
  BOOST_CHECK_THROW(SchemeDispersion(scene, 0.5), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
