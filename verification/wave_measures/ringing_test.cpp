#include "verification/wave_measures/ringing.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "verification/run.hpp"
#include "verification/wave_measures/wave_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(ringing)

using namespace porowave;
using namespace porowave::verification;
using wave_fixtures::column;

namespace {

constexpr int cells = 120;

/// A function of x in cells, at cell middles or nodes.
template <class Function>
std::vector<double> sampled(Places places, Function f) {
  std::vector<double> values;
  const bool nodes = places == Places::nodes;
  for (int i = 0; i < cells + nodes; ++i) values.push_back(f(i + (nodes ? 0.0 : 0.5)));
  return values;
}

/// Cosine of a wavelength in cells.
double wave(double x, double wavelength) {
  return std::cos(2.0 * std::numbers::pi * x / wavelength);
}

Ringing of_error(Places places, const std::function<double(double)>& error) {
  const auto reference = sampled(places, [](double) { return 2.0; });
  return verification::ringing(sampled(places, [&](double x) { return 2.0 + error(x); }), reference,
                               places);
}

}  // namespace

BOOST_AUTO_TEST_CASE(short_and_long_waves_in_an_error_are_told_apart) {
  for (const Places places : {Places::cell_middles, Places::nodes}) {
    const auto r =
        of_error(places, [](double x) { return 0.3 * wave(x, 3.0) + 0.4 * wave(x, 24.0); });
    BOOST_TEST(r.share == 0.09 / 0.25, boost::test_tools::tolerance(1e-12));
    // A cosine of amplitude 0.3 has the root mean square 0.3/sqrt(2); the reference has 2.
    BOOST_TEST(r.amplitude == 0.3 / std::sqrt(2.0) / 2.0, boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(a_wave_of_four_cells_is_the_first_that_is_long) {
  for (const Places places : {Places::cell_middles, Places::nodes}) {
    BOOST_TEST(of_error(places, [](double x) { return wave(x, 4.0); }).share < 1e-20);
    const double next = 2.0 * cells / (cells / 2 + 1.0);
    BOOST_TEST(of_error(places, [&](double x) { return wave(x, next); }).share > 1.0 - 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(a_sine_that_does_not_fit_the_column_leaks_little) {
  for (const Places places : {Places::cell_middles, Places::nodes}) {
    const auto sine = [&](double wavelength) {
      return of_error(places,
                      [&](double x) {
                        return std::sin(2.0 * std::numbers::pi * (x + 0.3) / wavelength);
                      })
          .share;
    };
    BOOST_TEST(sine(2.7) > 0.98);
    BOOST_TEST(sine(9.1) < 0.02);
    BOOST_TEST(sine(37.3) < 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(short_and_long_part_make_up_the_l2_error) {
  const auto reference = sampled(Places::cell_middles, [](double x) { return 1.0 + 0.01 * x; });
  const auto values = sampled(Places::cell_middles, [](double x) { return 0.9 + 0.011 * x * x; });
  const std::vector<double> weights(cells, 1.0);
  const auto r = verification::ringing(values, reference, Places::cell_middles);
  const double l2 = relative_norms(values, reference, weights).l2;
  BOOST_TEST(r.amplitude == l2 * std::sqrt(r.share), boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(no_error_no_ringing_and_no_number_no_measure) {
  const std::vector<double> one(cells, 1.0);
  const std::vector<double> zero(cells, 0.0);
  const auto zigzag = sampled(Places::cell_middles, [](double x) { return wave(x, 3.0); });
  BOOST_TEST(verification::ringing(one, one, Places::cell_middles).amplitude == 0.0);
  BOOST_TEST(verification::ringing(one, one, Places::cell_middles).share == 0.0);
  BOOST_TEST(verification::ringing(zero, zero, Places::cell_middles).amplitude == 0.0);
  BOOST_TEST(std::isnan(verification::ringing(zigzag, zero, Places::cell_middles).amplitude));
  std::vector<double> bad = one;
  bad[5] = std::nan("");
  BOOST_TEST(std::isnan(verification::ringing(bad, one, Places::cell_middles).amplitude));
  BOOST_TEST(std::isnan(verification::ringing(bad, one, Places::cell_middles).share));
  BOOST_TEST(std::isnan(verification::ringing(one, bad, Places::cell_middles).share));
  BOOST_CHECK_THROW(verification::ringing(one, std::vector{1.0}, Places::cell_middles),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_step_rings_more_than_a_ramp) {
  const auto of_run = [](const Load& load) {
    solver::Case scene;
    scene.problem = column(load);
    scene.discretization.elements = 200;
    scene.time.end = 4e-5;
    return run_case(scene, *reference_profile(scene)).measures.ringing;
  };
  const auto step = of_run(Load(LoadShape::step, 1.0));
  const auto ramp = of_run(Load(LoadShape::smooth_ramp, 1.0, 1e-5));
  for (std::size_t f = 0; f < 4; ++f) {
    BOOST_TEST_MESSAGE(field_names[f] << ": step " << step[f].amplitude << ", share "
                                      << step[f].share << "; ramp " << ramp[f].amplitude
                                      << ", share " << ramp[f].share);
    BOOST_TEST(step[f].amplitude > 50.0 * ramp[f].amplitude);
    BOOST_TEST(step[f].share > 0.03);
    BOOST_TEST(ramp[f].share < 0.01);
  }
}

BOOST_AUTO_TEST_SUITE_END()
