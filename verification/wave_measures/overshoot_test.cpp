#include "verification/wave_measures/overshoot.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "verification/run.hpp"
#include "verification/wave_measures/wave_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(overshoot)

using namespace porowave;
using namespace porowave::verification;
using Values = std::vector<double>;
using wave_fixtures::column;

namespace {

WaveMeasures measures_of_run(const Load& load) {
  solver::Case scene;
  scene.problem = column(load);
  scene.discretization.elements = 200;
  scene.time.end = 4e-5;
  return run_case(scene, *reference_profile(scene)).measures;
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_excess_is_a_share_of_the_range_of_the_reference) {
  const Values jump = {-2.0, -2.0, -2.0, 0.0, 0.0};
  BOOST_TEST(verification::overshoot(jump, jump).excess == 0.0);
  BOOST_TEST(verification::overshoot(Values{-2.0, -1.0, -2.0, 0.0, 0.0}, jump).excess == 0.0);
  BOOST_TEST(verification::overshoot(Values{-2.0, -2.0, -2.5, 0.0, 0.0}, jump).excess == 0.25);
  BOOST_TEST(verification::overshoot(Values{-2.0, -2.0, -2.5, 0.75, 0.0}, jump).excess == 0.375);
}

BOOST_AUTO_TEST_CASE(a_bump_costs_total_variation_twice_its_height) {
  const Values jump = {-2.0, -2.0, -2.0, 0.0, 0.0};
  const auto variation = [&](const Values& v) {
    return verification::overshoot(v, jump).total_variation;
  };
  BOOST_TEST(variation(jump) == 1.0);
  BOOST_TEST(variation({-2.0, -2.0, 0.0, 0.0, 0.0}) == 1.0);    // shifted
  BOOST_TEST(variation({-2.0, -1.5, -1.0, -0.5, 0.0}) == 1.0);  // smeared
  BOOST_TEST(variation({-2.0, -2.0, -2.5, 0.0, 0.0}) == 1.5);
  BOOST_TEST(variation({-1.0, -1.0, -1.0, 0.0, 0.0}) == 0.5);
}

BOOST_AUTO_TEST_CASE(a_field_at_rest_is_either_right_or_not_to_be_measured) {
  const Values rest = {0.0, 0.0};
  BOOST_TEST(verification::overshoot(rest, rest).excess == 0.0);
  BOOST_TEST(verification::overshoot(rest, rest).total_variation == 1.0);
  BOOST_TEST(std::isnan(verification::overshoot(Values{0.0, 1.0}, rest).excess));
  BOOST_TEST(std::isnan(verification::overshoot(Values{0.0, 1.0}, rest).total_variation));
}

BOOST_AUTO_TEST_CASE(values_that_are_not_finite_never_look_good) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Values jump = {-2.0, 0.0, 0.0};
  for (const double bad : {std::nan(""), infinity, -infinity}) {
    for (std::size_t i = 0; i < jump.size(); ++i) {
      Values spoiled = jump;
      spoiled[i] = bad;
      BOOST_TEST(std::isnan(verification::overshoot(spoiled, jump).excess));
      BOOST_TEST(std::isnan(verification::overshoot(jump, spoiled).total_variation));
    }
  }
  BOOST_CHECK_THROW(verification::overshoot({}, {}), std::invalid_argument);
  BOOST_CHECK_THROW(verification::overshoot(Values{1.0}, jump), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_step_overshoots_more_than_a_ramp) {
  const WaveMeasures step = measures_of_run(Load(LoadShape::step, 1.0));
  const WaveMeasures ramp = measures_of_run(Load(LoadShape::smooth_ramp, 1.0, 1e-5));
  for (std::size_t f = 0; f < 4; ++f) {
    BOOST_TEST_MESSAGE(field_names[f] << ": step " << step.overshoot[f].excess << ", "
                                      << step.overshoot[f].total_variation << "; ramp "
                                      << ramp.overshoot[f].excess << ", "
                                      << ramp.overshoot[f].total_variation);
    BOOST_TEST(step.overshoot[f].total_variation > 1.3);
    BOOST_TEST(std::abs(ramp.overshoot[f].total_variation - 1.0) < 0.05);
  }
  // The slow wave's front is the extreme of pressure and of the fluid's velocity.
  for (const std::size_t f : {1u, 3u}) {
    BOOST_TEST(step.overshoot[f].excess > 0.1);
    BOOST_TEST(ramp.overshoot[f].excess < 0.02);
  }
}

BOOST_AUTO_TEST_SUITE_END()
