// The critical time step that the step operator predicts, against the one that real runs show.
//
//   verification_studies_tests --run_test=predicted_step/runs_agree_with_the_operator -- 200
//
// takes that many random scenes instead of the few of the test suite.

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "reference/problem/errors.hpp"
#include "solver/stability/critical_step.hpp"
#include "verification/stability/observed_growth.hpp"
#include "verification/stability/random_scene.hpp"
#include "verification/study/study.hpp"

BOOST_AUTO_TEST_SUITE(predicted_step)

using namespace porowave;
using namespace porowave::verification;

namespace {

constexpr long steps_of_run = 16'000;

int scenes_wanted() {
  const auto& suite = boost::unit_test::framework::master_test_suite();
  return suite.argc > 1 ? std::stoi(suite.argv[1]) : 12;
}

solver::CriticalSettings search_settings() {
  solver::CriticalSettings settings;
  settings.highest = 1.6;  // beyond what a case may ask for, so that most scenes have a limit
  settings.tolerance = 4e-3;
  settings.whole_scan = false;
  return settings;
}

solver::CriticalStep predicted(const solver::Case& scene) {
  solver::SceneGrowth growth(scene);
  return solver::critical_step([&](double courant) { return growth.at(courant).per_step; },
                               search_settings());
}

solver::CriticalStep observed(const solver::Case& scene) {
  const auto settings = search_settings();
  return solver::critical_step(
      [&](double courant) {
        return observed_growth(scene, courant, steps_of_run, settings.limit).per_step;
      },
      settings);
}

}  // namespace

// Both by the same search and the same limit of growth, 1e-3 a step. The observed one knows nothing
// of the operator: it runs the solver from noise, 16,000 steps or more at every Courant number.
BOOST_AUTO_TEST_CASE(runs_agree_with_the_operator) {
  const int wanted = scenes_wanted();
  int compared = 0, limited = 0, unstable = 0, refused = 0, apart = 0;
  double worst = 0.0;
  for (std::uint64_t number = 1; compared < wanted; ++number) {
    const solver::Case scene = random_scene(number);
    solver::CriticalStep prediction;
    try {
      prediction = predicted(scene);
    } catch (const BreakdownError&) {  // no point at the loaded end: no run either
      ++refused;
      BOOST_CHECK_THROW(observed(scene), BreakdownError);
      continue;
    }
    const solver::CriticalStep observation = observed(scene);
    ++compared;
    const double difference = prediction.courant == observation.courant
                                  ? 0.0
                                  : std::abs(prediction.courant - observation.courant) /
                                        std::max(prediction.courant, observation.courant);
    limited += prediction.unstable > 0.0 && prediction.courant > 0.0 ? 1 : 0;
    unstable += prediction.courant == 0.0 ? 1 : 0;
    apart += difference > 0.02 ? 1 : 0;
    worst = std::max(worst, difference);
    const std::string what =
        fmt::format("scene {}: predicted {:.4f}, observed {:.4f} ({:.2f} %): {}", number,
                    prediction.courant, observation.courant, 100.0 * difference, described(scene));
    BOOST_TEST_MESSAGE(what);
    BOOST_TEST(difference <= 0.02, what);
  }
  BOOST_TEST_MESSAGE(fmt::format(
      "{} scenes: {} with a limit below 1.6, {} stable up to it, {} unstable at every step; {} "
      "apart "
      "by more than 2 %, worst {:.2f} %; {} refused",
      compared, limited, compared - limited - unstable, unstable, apart, 100.0 * worst, refused));
  BOOST_TEST(3 * limited > wanted);
}

// The seeds with the lowest limits of the 1,000 of verification/studies/stability_seeds.toml, and
// the one of 8,000 columns that no step keeps stable (there runs and operator say so at every
// sample).
BOOST_AUTO_TEST_CASE(worst_of_a_thousand_seeds_agree) {
  struct Worst {
    const char* kernel;
    solver::Strain strain;
    std::uint64_t seed;
    double limit;  // as the study gave it
  };
  const solver::Case base =
      load_study(POROWAVE_SOURCE_DIR "/verification/studies/stability_seeds.toml").cases[0].scene;
  for (const auto& [kernel, strain, seed, limit] :
       {Worst{"bspline1", solver::Strain::cell, 268, 0.658594},
        Worst{"bspline2", solver::Strain::cell, 91, 0.741406},
        Worst{"bspline1", solver::Strain::recovered, 238, 0.810937},
        Worst{"bspline3", solver::Strain::recovered, 25, 0.0}}) {
    solver::Case scene = base;
    scene.discretization.kernel = solver::kernel_from_name(kernel).value();
    scene.discretization.support_radius = solver::natural_radius(scene.discretization.kernel);
    scene.discretization.strain = strain;
    scene.discretization.seed = seed;
    const double prediction = predicted(scene).courant;
    const double observation = observed(scene).courant;
    BOOST_TEST_MESSAGE(fmt::format("{} seed {}: study {:.4f}, predicted {:.4f}, observed {:.4f}",
                                   kernel, seed, limit, prediction, observation));
    BOOST_TEST(std::abs(prediction - observation) <= 0.02 * limit);
    BOOST_TEST(std::abs(prediction - limit) <= 0.01 * limit);
  }
}

BOOST_AUTO_TEST_SUITE_END()
