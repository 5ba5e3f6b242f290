#include "reports/report/report_figures.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <sstream>

#include "reports/report/report_fixtures.hpp"
#include "reports/test_directory.hpp"
#include "reports/test_pictures.hpp"

BOOST_AUTO_TEST_SUITE(report_figures)

using namespace porowave;
using namespace porowave::reports;
using namespace porowave::reports::report_fixtures;
using namespace porowave::tests;
using verification::Record;

namespace {

constexpr std::size_t measure = 4;  // effective_stress_field_l2

struct Made {
  explicit Made(std::vector<Record> rows)
      : table(case_tables(std::move(rows)).front()), summaries(summaries_of(table, measure)) {}
  FigureInput input() const { return {table, summaries, measure, ""}; }

  StudyTable table;
  std::vector<GroupSummary> summaries;
};

std::string text(const Figure& figure, const std::string& variable) {
  const auto found = std::find_if(figure.texts.begin(), figure.texts.end(),
                                  [&](const auto& entry) { return entry.first == variable; });
  BOOST_REQUIRE_MESSAGE(found != figure.texts.end(), variable + " is not there");
  return found->second;
}

std::vector<std::string> lines_of(const std::string& data) {
  std::vector<std::string> lines;
  std::istringstream in(data);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// All names and values of a study as nasty as can be.
std::vector<Record> nasty_study() {
  auto rows = full_study(nasty_name());
  for (Record& row : rows) {
    const auto at = row.specification.find("bspline2");
    if (at == std::string::npos) continue;
    std::string value;
    for (const char c : nasty_name())
      value += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
    row.specification.replace(at, 8, value);
  }
  return rows;
}

}  // namespace

BOOST_AUTO_TEST_CASE(curves_are_the_method_and_panels_its_numbers) {
  const Made made(full_study());
  const FigureAxes axes = figure_axes(made.table);
  BOOST_REQUIRE((axes.curve && axes.panel));
  BOOST_TEST(made.table.axes[*axes.curve].title == "kernel");
  BOOST_TEST(made.table.axes[*axes.panel].title == "support_radius");
  BOOST_TEST(axes.rest.empty());
}

BOOST_AUTO_TEST_CASE(convergence_shows_every_level_and_the_order) {
  const Made made(full_study());
  const auto figures = convergence_figures(made.input());
  BOOST_REQUIRE(figures.size() == 1u);
  const Figure& figure = figures[0].figure;
  BOOST_TEST(lines_of(figure.data).size() == 1u + 4u * 4u);
  BOOST_TEST(contains(figure.data, "\n1,1,0.004,2.0000e-01,1.8097e-01,2.2103e-01,"));
  BOOST_TEST(text(figure, "legend_1_1") == "bspline1: 1.000 ± 0.000");
  BOOST_TEST(text(figure, "legend_2_2") == "bspline2: 2.000 ± 0.000");
  BOOST_TEST(text(figure, "floor_1_1") == "");
  BOOST_TEST(text(figure, "title2") == "support_radius = 3.0");
  BOOST_TEST(text(figure, "x_tics") == "0.0005 0.001 0.002 0.004 ");
  // The triangle has the order of the best curve of its panel, and lies below that.
  std::istringstream triangle(text(figure, "triangle1"));
  double h = 0.0, error = 0.0, order = 0.0;
  triangle >> h >> error >> order;
  BOOST_TEST(order == 2.0);
  BOOST_TEST(error < 0.2 * std::pow(h / 0.004, 2.0));
  BOOST_TEST(contains(figures[0].claim,
                      "Smallest error: kernel = bspline2, support_radius = 2.0, "
                      "with 0.0031 at elements = 200 (order: 2.000 ± 0.000)"));
  BOOST_TEST(contains(figures[0].claim, "Largest: kernel = bspline1, support_radius = 3.0"));
}

BOOST_AUTO_TEST_CASE(a_floor_is_drawn) {
  std::vector<Record> rows;
  for (int seed = 1; seed <= 3; ++seed) {
    for (const int elements : {25, 50, 100, 200, 400}) {
      const double scatter = std::exp(0.001 * std::sin(seed + 0.1 * elements));
      rows.push_back(row({"bspline1", 2.0, "step", elements, seed},
                         (0.1 * std::pow(25.0 / elements, 2.0) + 0.003) * scatter));
    }
  }
  const Made made(rows);
  const auto figures = convergence_figures(made.input());
  BOOST_REQUIRE(figures.size() == 1u);
  BOOST_TEST(std::stod(text(figures[0].figure, "floor_1_1")) == 0.003,
             boost::test_tools::tolerance(0.05));
}

BOOST_AUTO_TEST_CASE(no_convergence_of_one_level_and_no_map_of_one_axis) {
  auto rows = full_study();
  std::erase_if(rows, [](const Record& row) {
    return row.specification.find("elements = 50") == std::string::npos;
  });
  const Made one_level(rows);
  BOOST_TEST(convergence_figures(one_level.input()).empty());
  BOOST_TEST(heat_map_figures(one_level.input()).size() == 1u);
  std::erase_if(rows, [](const Record& row) {
    return row.specification.find("support_radius = 2") == std::string::npos;
  });
  const Made one_axis(rows);
  BOOST_TEST(heat_map_figures(one_axis.input()).empty());
  BOOST_TEST(work_precision_figures(one_axis.input()).size() == 1u);
}

BOOST_AUTO_TEST_CASE(nothing_that_ended_is_no_figure) {
  auto rows = full_study();
  for (Record& row : rows) row = broken(row);
  BOOST_TEST(figures_of(Made(rows).input()).empty());
}

BOOST_AUTO_TEST_CASE(the_pareto_front_is_what_nothing_beats) {
  std::vector<GroupSummary> summaries(40);
  std::vector<std::size_t> groups;
  for (std::size_t g = 0; g < summaries.size(); ++g) {
    const double x = static_cast<double>(g);
    LevelSummary level;
    level.cpu_seconds = 1.0 + std::fmod(7.3 * x, 5.0);
    level.error = 1.0 + std::fmod(3.1 * x, 4.0);
    level.cases = 2;
    level.ended = g == 11 ? 1 : 2;
    summaries[g].levels = {level};
    groups.push_back(g);
  }
  summaries[11].levels[0].error = 1e-3;  // the best of all, had it always ended
  const auto front = pareto_front(summaries, groups);
  const auto whole = [&](std::size_t g) { return summaries[g].levels[0].ended == 2; };
  for (const std::size_t g : groups) {
    const bool beaten = std::any_of(groups.begin(), groups.end(), [&](std::size_t other) {
      const auto& a = summaries[other].levels[0];
      const auto& b = summaries[g].levels[0];
      return whole(other) && a.cpu_seconds <= b.cpu_seconds && a.error <= b.error &&
             (a.cpu_seconds < b.cpu_seconds || a.error < b.error);
    });
    const bool on_front =
        std::any_of(front.begin(), front.end(), [&](const FrontMember& m) { return m.group == g; });
    BOOST_TEST(on_front == (whole(g) && !beaten), "group " << g);
  }
}

BOOST_AUTO_TEST_CASE(problems_have_fronts_of_their_own) {
  auto rows = full_study();
  const std::size_t count = rows.size();
  for (std::size_t i = 0; i < count; ++i) {
    Record other = rows[i];
    const auto at = other.specification.find("\"step\"");
    other.specification.replace(at, 6, "\"ramp\"");
    other.id += "r";
    rows.push_back(other);
  }
  const auto figures = work_precision_figures(Made(rows).input());
  BOOST_REQUIRE(figures.size() == 2u);
  BOOST_TEST(contains(figures[0].claim, "shape = ramp: "));
  BOOST_TEST(contains(figures[1].claim, "shape = step: "));
  BOOST_TEST(
      contains(figures[1].claim, "Most precise: bspline2, support_radius 2.0, 200 elements"));
}

BOOST_AUTO_TEST_CASE(heat_map_cells_have_error_order_and_what_broke_down) {
  auto rows = full_study();
  rows[3] = broken(rows[3]);
  const auto figures = heat_map_figures(Made(rows).input());
  BOOST_REQUIRE(figures.size() == 1u);
  const auto lines = lines_of(figures[0].figure.data);
  BOOST_REQUIRE(lines.size() == 5u);
  BOOST_TEST(lines[1].rfind("1,1,1,nan,0,1 of 3,broke down,", 0) == 0u, lines[1]);
  BOOST_TEST(lines[4].rfind("1,2,2,-2.3291,", 0) == 0u, lines[4]);
  BOOST_TEST(contains(lines[4], ",4.7e-03,p = 2.00,"), lines[4]);
  BOOST_TEST(contains(figures[0].claim, "In 1 cells runs broke down"));
}

BOOST_AUTO_TEST_CASE(all_figures_are_drawn_whatever_the_names_and_twice_the_same) {
  const TestDirectory first;
  const TestDirectory second;
  for (const auto& figure : figures_of(Made(nasty_study()).input())) {
    BOOST_TEST_CONTEXT(figure.figure.name) {
      const auto files = draw(figure.figure, first.path());
      draw(figure.figure, second.path());
      BOOST_TEST(files.size() == 5u);
      const std::string svg = text_of(first / (figure.figure.name + ".svg"));
      const std::string png = text_of(first / (figure.figure.name + ".png"));
      BOOST_TEST(is_svg(svg));
      BOOST_TEST(is_png(png));
      BOOST_TEST((svg == text_of(second / (figure.figure.name + ".svg"))));
      BOOST_TEST((png == text_of(second / (figure.figure.name + ".png"))));
      BOOST_TEST(text_of(first / (figure.figure.name + ".pdf")).rfind("%PDF", 0) == 0u);
      BOOST_TEST(!contains(svg, "<b>"));
      BOOST_TEST(figure.alt != "");
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
