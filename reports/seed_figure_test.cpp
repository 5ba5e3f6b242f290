#include "reports/seed_figure.hpp"

#include <boost/test/unit_test.hpp>
#include <stdexcept>

#include "reference/problem/toml_document.hpp"
#include "reports/test_pictures.hpp"

BOOST_AUTO_TEST_SUITE(seed_figure)

using namespace porowave;
using namespace porowave::reports;
using namespace porowave::tests;

namespace {

verification::Study seeds_of_repository() {
  return verification::load_study(POROWAVE_SOURCE_DIR "/verification/studies/stability_seeds.toml");
}

/// As if the study had found them: limits of the first combination 0, 0.25, 0.25, 0.5.
std::vector<verification::SeedDistribution> four_seeds(const verification::Study& study) {
  std::vector<verification::MappedStability> map(study.cases.size());
  auto found = verification::seed_distributions(study, map);
  for (auto& one : found) one.courant = {0.0, 0.25, 0.25, 0.5};
  return found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(curves_rise_from_none_to_all_at_the_limits) {
  const auto study = seeds_of_repository();
  const auto found = four_seeds(study);
  const Figure figure = reports::seed_figure(study, found, 1.0);
  BOOST_TEST(figure.data.starts_with(
      "# critical courant, share of the seeds (%)\n-1 0\n0 25\n0.25 75\n0.5 100\n"));
  bool told = false;
  for (const auto& [name, value] : figure.texts) {
    if (name != "curve1") continue;
    told = true;
    BOOST_TEST(contains(value, "kernel bspline1"));
    BOOST_TEST(value.ends_with("least 0, median 0.25; 1 of 4 unstable at every step"));
  }
  BOOST_TEST(told);
}

BOOST_AUTO_TEST_CASE(more_curves_than_can_be_told_apart_are_refused) {
  const auto study = seeds_of_repository();
  auto found = four_seeds(study);
  found.resize(most_seed_curves + 1, found.front());
  BOOST_CHECK_THROW(reports::seed_figure(study, found, 1.0), std::invalid_argument);
  BOOST_CHECK_THROW(reports::seed_figure(study, {}, 1.0), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(it_can_be_drawn) {
  const auto study = seeds_of_repository();
  const TestDirectory folder;
  draw(reports::seed_figure(study, four_seeds(study), 1.0), folder.path());
  check_pictures(folder.path(), "stability_seeds");
}

BOOST_AUTO_TEST_SUITE_END()
