#include "verification/stability/stability_map.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/problem/toml_document.hpp"
#include "verification/stability/text_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(stability_map)

using namespace porowave;
using namespace porowave::verification;
namespace tt = boost::test_tools;
using fixtures::lines_of;

namespace {

/// Linear shape functions, uniform points, hardly any drag; with a gap at the loaded end a case
/// cannot be run.
Study study() {
  return read_study(TomlDocument::parse(fixtures::column_text("1.0") + R"([discretization]
elements = 24
transfer = "shape"
kernel = "bspline1"
[time]
end = 1e-5
[study]
name = "points"
[axes]
"discretization.empty_elements" = [[], [0.001]]
"discretization.points_per_element" = [1, 2, 4]
)",
                                        "study.toml"));
}

}  // namespace

// 1/sqrt(2 - w), w = mean (1 - 2t)^2 (solver/stability/growth_test.cpp).
BOOST_AUTO_TEST_CASE(every_case_has_its_limit_or_its_reason) {
  const Study points = study();
  std::size_t told = 0;
  const auto map = verification::stability_map(
      points, {}, 2, [&](std::size_t done) { BOOST_TEST(done == ++told); });
  BOOST_TEST(told == 6u);
  BOOST_TEST_REQUIRE(map.size() == 6u);
  const double seen[] = {0.0, 0.25, 0.3125};
  for (std::size_t k = 0; k < 3; ++k) {
    BOOST_TEST(map[k].refused == "");
    BOOST_TEST(map[k].critical.courant == 1.0 / std::sqrt(2.0 - seen[k]), tt::tolerance(1e-2));
    BOOST_TEST(map[k].critical.scan.size() == 20u);
    BOOST_TEST(map[3 + k].refused.find("loaded end") != std::string::npos, map[3 + k].refused);
  }
}

BOOST_AUTO_TEST_CASE(threads_change_nothing) {
  const Study points = study();
  std::ostringstream one, four;
  write_map_csv(points, verification::stability_map(points, {}, 1), one);
  write_map_csv(points, verification::stability_map(points, {}, 4), four);
  BOOST_TEST(one.str() == four.str());
}

BOOST_AUTO_TEST_CASE(it_is_a_table_with_the_axes_first) {
  const Study points = study();
  std::vector<MappedStability> map(6);
  map[0].critical = {0.7, 0.71, {{0.75, 1.2, false}, {0.7, 1.0, true}, {0.65, 1.004, false}}};
  map[0].crossing = 2.0;
  map[1].critical.courant = 1.0;
  map[5].refused = "no \"point\", nowhere";
  std::ostringstream csv;
  write_map_csv(points, map, csv);
  const auto lines = lines_of(csv.str());
  BOOST_TEST_REQUIRE(lines.size() == 7u);
  BOOST_TEST(lines[0] ==
             "discretization.empty_elements,discretization.points_per_element,critical_courant,"
             "unstable_courant,critical_time_step,unstable_below,growth_below,refused");
  BOOST_TEST(lines[1] == "[],1,0.7,0.71,1.4,1,0.004,");
  BOOST_TEST(lines[2] == "[],2,1,,0,0,0,");
  BOOST_TEST(lines[6] == "[0.001],4,,,,,,\"no \"\"point\"\", nowhere\"");
}

BOOST_AUTO_TEST_SUITE_END()
