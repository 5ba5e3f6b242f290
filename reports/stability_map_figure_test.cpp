#include "reports/stability_map_figure.hpp"

#include <boost/test/unit_test.hpp>

#include "reference/problem/toml_document.hpp"
#include "reports/test_pictures.hpp"

BOOST_AUTO_TEST_SUITE(stability_map_figure)

using namespace porowave;
using namespace porowave::reports;
using namespace porowave::tests;

namespace {

const std::string map_study = POROWAVE_SOURCE_DIR "/verification/studies/stability_map.toml";

/// The study of the repository with critical steps made up: the case's number in hundreds.
std::vector<verification::MappedStability> made_up(const verification::Study& study) {
  std::vector<verification::MappedStability> map(study.cases.size());
  for (std::size_t i = 0; i < map.size(); ++i) {
    map[i].critical.courant = 1e-3 * static_cast<double>(i);
  }
  map[5].critical.scan = {{0.001, 1.01, false}};
  map[7].refused = "no point";
  return map;
}

std::string text(const Figure& figure, const std::string& variable) {
  for (const auto& [name, value] : figure.texts) {
    if (name == variable) return value;
  }
  return "absent";
}

}  // namespace

BOOST_AUTO_TEST_CASE(first_axes_go_down_and_the_others_across) {
  const auto study = verification::load_study(map_study);
  const Figure figure = reports::stability_map_figure(study, made_up(study));
  BOOST_TEST(text(figure, "rows") == "18");
  BOOST_TEST(text(figure, "columns") == "36");
  BOOST_TEST(text(figure, "row_names") == "kernel, then placement");
  BOOST_TEST(contains(text(figure, "row_labels"), "1.0 1 bspline1 4.0 1 bspline2 "));
  BOOST_TEST(contains(text(figure, "row_labels"), "0.0 2 uniform 1.0 2 stratified 2.0 2 random "));
  BOOST_TEST(contains(text(figure, "column_labels"), " 3 2.2e7 "));
  BOOST_TEST(contains(text(figure, "column_labels"), " 3 2.2e11 "));
  BOOST_TEST(contains(text(figure, "column_labels"), " 4 1e-9 "));
  BOOST_TEST(contains(figure.data, "\n5 0 0.0050\n"));
  BOOST_TEST(contains(figure.data, "\n7 0 -1.0000\n"));   // refused
  BOOST_TEST(contains(figure.data, "\n0 1 0.0360\n"));    // the next row
  BOOST_TEST(contains(figure.data, "\n35 17 0.6470\n"));  // the last one
  BOOST_TEST(figure.data.ends_with("\n-9 -9\n5 0\n"));    // one with unstable steps below
}

BOOST_AUTO_TEST_CASE(it_can_be_drawn) {
  const auto study = verification::load_study(map_study);
  const TestDirectory folder;
  draw(reports::stability_map_figure(study, made_up(study)), folder.path());
  check_pictures(folder.path(), "stability_map");
}

BOOST_AUTO_TEST_SUITE_END()
