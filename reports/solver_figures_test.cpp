#include "reports/solver_figures.hpp"

#include <boost/test/unit_test.hpp>
#include <iterator>
#include <sstream>

#include "reports/test_pictures.hpp"

BOOST_AUTO_TEST_SUITE(solver_figures)

using namespace porowave;
using namespace porowave::reports;
using namespace porowave::tests;

namespace {

/// Every method at two resolutions, finer ones at ten times the cost and a tenth of the error; each
/// method ten per cent dearer than the one before.
std::vector<verification::WorkPrecision> measurements() {
  solver::Case column;
  std::vector<verification::WorkPrecision> measured;
  double cost = 1e-3;
  for (const auto& method : verification::every_method(column)) {
    for (const double factor : {1.0, 10.0}) {
      measured.push_back({method, {}, cost * factor});
      for (auto& error : measured.back().run.errors) error.field.l2 = 1e-2 / factor;
    }
    cost *= 1.1;
  }
  return measured;
}

std::string text(const Figure& figure, const std::string& variable) {
  for (const auto& [name, value] : figure.texts) {
    if (name == variable) return value;
  }
  return "absent";
}

std::vector<std::string> words(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_method_is_a_curve_in_the_panel_of_its_family) {
  const auto measured = measurements();
  const Figure figure = solver_work_precision(measured);
  const std::size_t methods = measured.size() / 2;
  BOOST_TEST(text(figure, "curves") == std::to_string(methods));
  const auto panels = words(text(figure, "panels"));
  const auto dashes = words(text(figure, "dashes"));
  BOOST_TEST_REQUIRE(panels.size() == methods);
  BOOST_TEST_REQUIRE(dashes.size() == methods);
  for (std::size_t i = 0; i < methods; ++i) {
    const std::string title = text(figure, "title" + std::to_string(i + 1));
    BOOST_TEST(title == measured[2 * i].method.name);
    const bool mls = title.starts_with("mls");
    BOOST_TEST(panels[i] == (mls ? "2" : title.starts_with("staggered4") ? "3" : "1"));
    BOOST_TEST(dashes[i] == (contains(title, "recovered") ? "2" : "1"));
  }
}

BOOST_AUTO_TEST_CASE(the_first_block_is_the_best_of_all) {
  const Figure figure = solver_work_precision(measurements());
  const auto end = figure.data.find("\n\n\n");
  const auto line = figure.data.find('\n');
  BOOST_TEST(figure.data.substr(line + 1, end - line) ==
             "1.0000e-03 1.0000e-02\n1.0000e-02 1.0000e-03\n");
}

BOOST_AUTO_TEST_CASE(it_can_be_drawn) {
  const TestDirectory folder;
  draw(solver_work_precision(measurements()), folder.path());
  check_pictures(folder.path(), "solver_work_precision");
}

BOOST_AUTO_TEST_SUITE_END()
