#include "reports/history_figures.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "reference/problem/problem_fixtures.hpp"
#include "reports/test_pictures.hpp"

BOOST_AUTO_TEST_SUITE(history_figures)

using namespace porowave;
using namespace porowave::reports;
using namespace porowave::tests;

namespace {

const RunHistory& history() {
  static const RunHistory made = [] {
    solver::Case scene;
    scene.problem = fixtures::paper_problem();
    scene.discretization.elements = 25;
    scene.discretization.adaptive_support = true;
    scene.discretization.empty_elements = {0.05};
    scene.time.end = 3e-5;
    return run_history(scene, 4);
  }();
  return made;
}

std::string text(const Figure& figure, const std::string& variable) {
  for (const auto& [name, value] : figure.texts) {
    if (name == variable) return value;
  }
  return "absent";
}

long lines_with(const std::string& data, char mark) {
  return std::count(data.begin(), data.end(), mark);
}

}  // namespace

BOOST_AUTO_TEST_CASE(space_and_time_are_coloured_and_crossed_by_waves) {
  const Figure figure = space_time_figure("space_time", "It's <a> \"title\"", history());
  BOOST_TEST(text(figure, "gaps") == "0.048000000 0.052000000 ");
  BOOST_TEST(lines_with(figure.data, '#') == 3);
  BOOST_TEST(!contains(figure.data, "nan"));
  const TestDirectory folder;
  draw(figure, folder.path());
  check_pictures(folder.path(), "space_time");
}

BOOST_AUTO_TEST_CASE(an_animation_has_a_block_a_frame_and_a_gif) {
  const Figure figure = animation_figure("past_the_gap", "title", history());
  BOOST_TEST(lines_with(figure.data, '#') == 4);
  BOOST_TEST(lines_with(text(figure, "times"), ' ') == 4);
  const TestDirectory folder;
  BOOST_TEST(draw(figure, folder.path()).size() == 5u);
  check_pictures(folder.path(), "past_the_gap");
  const std::string gif = text_of(folder.path() / "past_the_gap.gif");
  BOOST_TEST(gif.rfind("GIF89a", 0) == 0u);
  BOOST_TEST(contains(gif, "NETSCAPE2.0"));  // plays more than one frame
}

BOOST_AUTO_TEST_SUITE_END()
