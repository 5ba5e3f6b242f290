#include "reports/figures.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <sstream>

#include "reference/problem/problem_fixtures.hpp"
#include "reports/test_directory.hpp"
#include "reports/test_pictures.hpp"
#include "verification/run.hpp"

BOOST_AUTO_TEST_SUITE(figures)

using namespace porowave;
using namespace porowave::reports;
using namespace porowave::tests;
namespace tt = boost::test_tools;

namespace {

using Row = std::vector<double>;
using Block = std::vector<Row>;

/// As gnuplot reads it: two empty lines part blocks, # begins a comment.
std::vector<Block> blocks_of(const std::string& data) {
  std::vector<Block> blocks(1);
  std::istringstream in(data);
  int empty = 0;
  for (std::string line; std::getline(in, line);) {
    empty = line.empty() ? empty + 1 : 0;
    if (empty == 2) blocks.emplace_back();
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    Row row;
    for (std::string word; words >> word;) row.push_back(std::stod(word));
    blocks.back().push_back(row);
  }
  if (blocks.back().empty()) blocks.pop_back();
  return blocks;
}

std::string text(const Figure& figure, const std::string& variable) {
  const auto found = std::find_if(figure.texts.begin(), figure.texts.end(),
                                  [&](const auto& entry) { return entry.first == variable; });
  BOOST_REQUIRE_MESSAGE(found != figure.texts.end(), variable + " is not there");
  return found->second;
}

double number(const Figure& figure, const std::string& variable) {
  return std::stod(text(figure, variable));
}

ProfileRow row_at(double end, double length = 0.1) {
  solver::Case scene;
  scene.problem = fixtures::paper_problem(Load(LoadShape::step, 2.0));
  scene.problem.column.length = length;
  scene.discretization.elements = 40;
  scene.discretization.placement = solver::Placement::random;
  scene.time.end = end;
  return {"t = " + std::to_string(end), scene,
          verification::run_case(scene, *verification::reference_profile(scene)).snapshot};
}

void check_points(const Block& block, const solver::PhasePoints& points, double load) {
  BOOST_REQUIRE(block.size() == points.x.size());
  std::vector<std::pair<double, double>> expected;
  for (std::size_t p = 0; p < points.x.size(); ++p) {
    expected.emplace_back(points.x[p], points.stress[p] / load);
  }
  std::sort(expected.begin(), expected.end());
  for (std::size_t i = 0; i < block.size(); ++i) {
    BOOST_TEST(block[i].size() == 2u);
    BOOST_TEST(block[i][0] == expected[i].first, tt::tolerance(1e-9));
    BOOST_TEST(block[i][1] == expected[i].second, tt::tolerance(1e-9));
  }
}

ConvergenceCurve curve(const std::string& title, double error) {
  return {title, {{100, 1e-3, error, 1e-3}, {200, 5e-4, error / 4.0, 4e-3}}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_row_is_the_reference_and_the_points_of_both_phases) {
  const std::vector<ProfileRow> rows = {row_at(2e-5), row_at(4e-5)};
  const Figure figure = profile_figure("profiles", "caption", rows);
  const auto blocks = blocks_of(figure.data);
  BOOST_REQUIRE(blocks.size() == 6u);
  for (std::size_t r = 0; r < 2; ++r) {
    const reference::ColumnSolution solution(rows[r].scene.problem);
    const auto& curve = blocks[3 * r];
    BOOST_TEST(curve.size() >= 801u);
    BOOST_TEST(curve.front()[0] == 0.0);
    BOOST_TEST(curve.back()[0] == 0.1);
    const auto by_x = [](const Row& a, const Row& b) { return a[0] < b[0]; };
    BOOST_TEST(std::is_sorted(curve.begin(), curve.end(), by_x));
    const auto exact = solution.at(curve[100][0], rows[r].scene.time.end).value;
    BOOST_TEST(curve[100][1] == exact.effective_stress / 2.0, tt::tolerance(1e-8));
    BOOST_TEST(curve[100][2] == exact.pore_pressure / 2.0, tt::tolerance(1e-8));
    check_points(blocks[3 * r + 1], rows[r].snapshot.solid, 2.0);
    check_points(blocks[3 * r + 2], rows[r].snapshot.fluid, 2.0);
  }
  BOOST_TEST(text(figure, "rows") == "2");
  BOOST_TEST(text(figure, "row1") == rows[0].title);
  BOOST_TEST(text(figure, "row2") == rows[1].title);
  BOOST_TEST(text(figure, "caption") == "caption");
  BOOST_TEST(number(figure, "x_end") == 0.1);
  BOOST_TEST(text(figure, "gaps1") == "");
}

BOOST_AUTO_TEST_CASE(fronts_are_marked_and_drawn_upright) {
  const ProfileRow row = row_at(2e-5);
  const Figure figure = profile_figure("profiles", "", {row});
  std::istringstream words(text(figure, "fronts1"));
  std::vector<double> fronts;
  for (double x = 0.0; words >> x;) fronts.push_back(x);
  const auto speeds = wave_speeds(row.scene.problem.material);
  BOOST_REQUIRE(fronts.size() == 2u);
  BOOST_TEST(fronts[0] == speeds.p2 * 2e-5, tt::tolerance(1e-8));
  BOOST_TEST(fronts[1] == speeds.p1 * 2e-5, tt::tolerance(1e-8));
  const auto blocks = blocks_of(figure.data);
  for (const double front : fronts) {
    double before = 0.0;
    double after = 1.0;
    for (const Row& point : blocks[0]) {
      if (std::abs(point[0] - front) > 1e-9) continue;
      before = std::min(before, point[1]);
      after = std::min(after, std::abs(point[1] - before));
    }
    BOOST_TEST(after < 0.9);
    BOOST_TEST(before < -0.01);
  }
}

BOOST_AUTO_TEST_CASE(all_rows_share_axes_that_show_the_reference) {
  std::vector<ProfileRow> rows = {row_at(1e-5), row_at(6e-5)};
  rows[1].snapshot.solid.stress[7] = 1e6;  // a point far off must not flatten the rest
  const Figure figure = profile_figure("profiles", "", rows);
  const auto blocks = blocks_of(figure.data);
  for (const auto& [column, name] : {std::pair<std::size_t, std::string>(1, "stress"),
                                     std::pair<std::size_t, std::string>(2, "pressure")}) {
    double low = 0.0;
    double high = 0.0;
    for (const std::size_t block : {0, 3}) {
      for (const Row& point : blocks[block]) {
        low = std::min(low, point[column]);
        high = std::max(high, point[column]);
      }
    }
    BOOST_TEST(number(figure, name + "_low") < low);
    BOOST_TEST(number(figure, name + "_high") > high);
    BOOST_TEST(number(figure, name + "_low") > low - 1.1 * (high - low));
    BOOST_TEST(number(figure, name + "_high") < high + 1.1 * (high - low));
  }
}

BOOST_AUTO_TEST_CASE(points_without_a_finite_value_are_left_out) {
  ProfileRow row = row_at(2e-5);
  row.snapshot.solid.stress[3] = std::nan("");
  row.snapshot.solid.stress[5] = std::numeric_limits<double>::infinity();
  row.snapshot.fluid.stress[0] = -std::numeric_limits<double>::infinity();
  const Figure figure = profile_figure("profiles", "", {row});
  const auto blocks = blocks_of(figure.data);
  BOOST_REQUIRE(blocks.size() == 3u);
  BOOST_TEST(blocks[1].size() == row.snapshot.solid.x.size() - 2);
  BOOST_TEST(blocks[2].size() == row.snapshot.fluid.x.size() - 1);
  BOOST_TEST(!contains(figure.data, "nan"));
  BOOST_TEST(!contains(figure.data, "inf"));
  for (const auto& entry : figure.texts) BOOST_TEST(!contains(entry.second, "inf"));
}

BOOST_AUTO_TEST_CASE(of_many_points_those_that_stand_out_are_drawn) {
  ProfileRow row = row_at(2e-5);
  const std::size_t count = row.snapshot.solid.x.size();
  BOOST_REQUIRE(count == 160u);
  row.snapshot.solid.stress[7] = -9.0;
  row.snapshot.solid.stress[90] = 9.0;
  row.most_points = 40;
  const auto blocks = blocks_of(profile_figure("profiles", "", {row}).data);
  BOOST_TEST(blocks[1].size() <= 42u);
  BOOST_TEST(blocks[1].size() >= 30u);
  const auto has = [&](double value) {
    return std::any_of(blocks[1].begin(), blocks[1].end(),
                       [&](const Row& point) { return point[1] == value / 2.0; });
  };
  BOOST_TEST(has(-9.0));
  BOOST_TEST(has(9.0));
  const auto by_x = [](const Row& a, const Row& b) { return a[0] < b[0]; };
  BOOST_TEST(std::is_sorted(blocks[1].begin(), blocks[1].end(), by_x));
  row.most_points = count;
  BOOST_TEST(blocks_of(profile_figure("profiles", "", {row}).data)[1].size() == count);
}

BOOST_AUTO_TEST_CASE(given_fronts_are_marked_with_their_wave) {
  ProfileRow row = row_at(2e-5);
  row.fronts = {{0.01, false}, {0.02, true}};
  const Figure figure = profile_figure("profiles", "", {row});
  BOOST_TEST(text(figure, "fronts1") == "0.01000000000 0.02000000000");
  BOOST_TEST(text(figure, "waves1") == "P2 P1 ");
}

BOOST_AUTO_TEST_CASE(the_empty_element_is_shaded) {
  ProfileRow row = row_at(2e-5);
  row.scene.discretization.empty_elements = {0.0512};  // h = 0.0025
  const Figure figure = profile_figure("profiles", "", {row});
  std::istringstream gaps(text(figure, "gaps1"));
  double begin = 0.0, end = 0.0;
  gaps >> begin >> end;
  BOOST_TEST(begin == 0.05, tt::tolerance(1e-9));
  BOOST_TEST(end == 0.0525, tt::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_curve_is_a_block_with_its_levels) {
  const Figure figure = convergence_figure("convergence", "caption",
                                           {curve("one\n1 2 3 4\n\n\n", 0.04), curve("two", 0.02)});
  const auto blocks = blocks_of(figure.data);
  BOOST_REQUIRE(blocks.size() == 2u);
  const Row fine = {200.0, 5e-4, 0.005, 4e-3};
  BOOST_REQUIRE(blocks[0].size() == 2u);
  BOOST_TEST(blocks[0][0] == Row({100.0, 1e-3, 0.04, 1e-3}), tt::per_element());
  BOOST_TEST(blocks[1][1] == fine, tt::per_element());
  BOOST_TEST(text(figure, "curves") == "2");
  BOOST_TEST(text(figure, "curve2") == "two");
  BOOST_TEST(number(figure, "triangle_h") > 5e-4);
}

BOOST_AUTO_TEST_CASE(both_kinds_can_be_drawn) {
  const TestDirectory folder;
  ProfileRow row = row_at(2e-5);
  row.title = "it's\n`row` 1";
  draw(profile_figure("profiles", "caption", {row, row_at(4e-5)}), folder.path());
  draw(convergence_figure("convergence", "caption", {curve("one", 0.04), curve("two", 0.02)}),
       folder.path());
  check_pictures(folder.path(), "profiles");
  check_pictures(folder.path(), "convergence");
}

BOOST_AUTO_TEST_CASE(powers_of_ten_can_be_drawn) {
  // Gnuplot reads no number like 1e-05 from a string.
  const TestDirectory folder;
  draw(profile_figure("profiles", "", {row_at(3e-9, 1e-5)}), folder.path());
  check_pictures(folder.path(), "profiles");
  const ConvergenceCurve tiny{"tiny", {{100, 1e-5 / 2.2, 1e-5 / 1.6, 1e-3}}};
  draw(convergence_figure("convergence", "", {tiny}), folder.path());
  check_pictures(folder.path(), "convergence");
}

BOOST_AUTO_TEST_SUITE_END()
