#include "reports/stability_figures.hpp"

#include <boost/test/unit_test.hpp>

#include "reference/problem/problem_fixtures.hpp"
#include "reports/test_pictures.hpp"

BOOST_AUTO_TEST_SUITE(stability_figures)

using namespace porowave;
using namespace porowave::reports;
using namespace porowave::tests;

namespace {

verification::SceneStability stability_of(double highest) {
  solver::Case scene;
  scene.problem = fixtures::paper_problem();
  scene.discretization.elements = 16;
  scene.discretization.placement = solver::Placement::stratified;
  scene.time.end = 1e-5;
  solver::CriticalSettings settings;
  settings.highest = highest;
  settings.lowest = 0.5;
  settings.spacing = 0.1;
  return verification::scene_stability(scene, settings);
}

std::string text(const Figure& figure, const std::string& variable) {
  for (const auto& [name, value] : figure.texts) {
    if (name == variable) return value;
  }
  return "absent";
}

int blocks(const Figure& figure) {
  int count = 1;
  for (auto at = figure.data.find("\n\n\n"); at != std::string::npos;
       at = figure.data.find("\n\n\n", at + 1)) {
    ++count;
  }
  return count;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_mode_has_two_panels_of_its_own) {
  const auto found = stability_of(1.4);
  BOOST_TEST_REQUIRE(found.mode.has_value());
  const Figure figure = stability_figure(found, "a title", 1e-3);
  BOOST_TEST(blocks(figure) == 3);
  BOOST_TEST(text(figure, "caption") == "a title");
  BOOST_TEST(text(figure, "limit") == "0.00100000");
  BOOST_TEST(std::stod(text(figure, "critical")) == found.critical.courant,
             boost::test_tools::tolerance(1e-5));
  BOOST_TEST(contains(text(figure, "mode"), "Fastest mode at courant"));
  const TestDirectory folder;
  draw(figure, folder.path());
  check_pictures(folder.path(), "stability");
}

BOOST_AUTO_TEST_CASE(without_a_mode_there_is_growth_alone) {
  const auto found = stability_of(0.8);
  BOOST_TEST_REQUIRE(!found.mode.has_value());
  const Figure figure = stability_figure(found, "a title", 1e-3);
  BOOST_TEST(blocks(figure) == 1);
  BOOST_TEST(text(figure, "mode") == "");
  BOOST_TEST(contains(figure.data, "e-07\n"));  // nothing grows
  const TestDirectory folder;
  draw(figure, folder.path());
  check_pictures(folder.path(), "stability");
}

BOOST_AUTO_TEST_SUITE_END()
