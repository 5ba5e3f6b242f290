#include "reports/report/case_table.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <random>

#include "reference/problem/errors.hpp"
#include "reports/report/report_fixtures.hpp"
#include "reports/test_directory.hpp"

BOOST_AUTO_TEST_SUITE(case_table)

using namespace porowave;
using namespace porowave::reports;
using namespace porowave::reports::report_fixtures;
using verification::Record;

BOOST_AUTO_TEST_CASE(groups_are_all_but_levels_and_seeds) {
  const auto tables = case_tables(full_study());
  BOOST_REQUIRE(tables.size() == 1u);
  const StudyTable& table = tables.front();
  BOOST_TEST(table.study == "trial");
  BOOST_REQUIRE(table.axes.size() == 2u);
  BOOST_TEST(table.axes[0].title == "kernel");
  BOOST_TEST(table.axes[1].title == "support_radius");
  BOOST_REQUIRE(table.groups.size() == 4u);
  BOOST_TEST(table.groups[1].name == "kernel = bspline1, support_radius = 3.0");
  for (const TableGroup& group : table.groups) {
    BOOST_REQUIRE(group.levels.size() == 4u);
    BOOST_TEST(group.levels.front().text == "25");
    BOOST_TEST(group.levels.back().spacing == 0.1 / 200.0, boost::test_tools::tolerance(1e-14));
    for (const TableLevel& level : group.levels) {
      BOOST_REQUIRE(level.rows.size() == 3u);
      for (std::size_t s = 0; s < 3; ++s) {
        BOOST_TEST(table.seeds[level.rows[s]] == std::to_string(s + 1));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_order_of_the_rows_does_not_matter) {
  auto rows = full_study();
  const auto first = case_tables(rows).front();
  std::mt19937 random(1);
  std::shuffle(rows.begin(), rows.end(), random);
  const auto second = case_tables(rows).front();
  BOOST_REQUIRE(first.groups.size() == second.groups.size());
  for (std::size_t g = 0; g < first.groups.size(); ++g) {
    BOOST_TEST(first.groups[g].name == second.groups[g].name);
    for (std::size_t l = 0; l < first.groups[g].levels.size(); ++l) {
      const auto& a = first.groups[g].levels[l].rows;
      const auto& b = second.groups[g].levels[l].rows;
      BOOST_REQUIRE(a.size() == b.size());
      for (std::size_t s = 0; s < a.size(); ++s) {
        BOOST_TEST(first.rows[a[s]].id == second.rows[b[s]].id);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(numbers_stand_in_the_order_of_their_size) {
  std::vector<Record> rows;
  for (const double radius : {10.0, 2.0, 1.5}) rows.push_back(row({"bspline1", radius}, 0.1));
  const auto table = case_tables(rows).front();
  BOOST_TEST(table.axes[0].values == (std::vector<std::string>{"1.5", "2.0", "10.0"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(keys_that_change_together_are_one_axis) {
  // Three methods, each a kernel with its own radius; a full product with the loads.
  std::vector<Record> rows;
  for (const std::string shape : {"step", "ramp"}) {
    rows.push_back(row({"bspline1", 1.0, shape}, 0.1));
    rows.push_back(row({"bspline2", 1.5, shape}, 0.1));
    rows.push_back(row({"bspline3", 2.0, shape}, 0.1));
  }
  const auto table = case_tables(rows).front();
  BOOST_REQUIRE(table.axes.size() == 2u);
  BOOST_TEST(table.axes[0].title == "method");
  BOOST_TEST(table.axes[0].values[1] == "bspline2, support_radius 1.5");
  BOOST_TEST(!table.axes[0].of_problem);
  BOOST_TEST(table.axes[1].title == "shape");
  BOOST_TEST(table.axes[1].of_problem);
  BOOST_TEST(table.groups.size() == 6u);
}

BOOST_AUTO_TEST_CASE(one_row_and_none_are_tables_too) {
  BOOST_TEST(case_tables({}).empty());
  const auto table = case_tables({row({}, 0.1)}).front();
  BOOST_REQUIRE(table.groups.size() == 1u);
  BOOST_TEST(table.groups[0].name == "all cases");
  BOOST_TEST(table.groups[0].levels.size() == 1u);
  BOOST_TEST(table.axes.empty());
  BOOST_TEST(table.constants.size() == 5u);  // all but seed and elements
}

BOOST_AUTO_TEST_CASE(studies_stay_apart) {
  auto rows = full_study("b");
  rows.push_back(row({}, 0.1, "a"));
  const auto tables = case_tables(rows);
  BOOST_REQUIRE(tables.size() == 2u);
  BOOST_TEST(tables[0].study == "a");
  BOOST_TEST(tables[1].rows.size() == 48u);
}

BOOST_AUTO_TEST_CASE(one_specification_of_two_builds_is_two_groups) {
  auto old = row({}, 0.1);
  auto changed = old;
  changed.id = "other";
  changed.provenance = "q";
  const CaseTableOptions options{
      "store", "discretization.elements", {{"p", "1111"}, {"q", "2222"}}};
  const auto table = case_tables({old, changed}, options).front();
  BOOST_REQUIRE(table.groups.size() == 2u);
  BOOST_TEST(table.groups[1].name == "numerics = 2222");
}

BOOST_AUTO_TEST_CASE(errors_are_missing_where_cases_are) {
  auto rows = full_study();
  rows[0] = broken(rows[0]);     // bspline1, 2.0, seed 1, 25 elements
  rows.erase(rows.begin() + 1);  // 50 elements
  const auto table = case_tables(rows).front();
  const auto errors = errors_of(table, table.groups[0], 0);
  BOOST_REQUIRE(errors.levels() == 4u);
  BOOST_REQUIRE(errors.replicates() == 3u);
  BOOST_TEST(std::isnan(errors.errors[0][0]));
  BOOST_TEST(std::isnan(errors.errors[1][0]));
  BOOST_TEST(errors.errors[2][0] == 0.05 * std::exp(-0.1), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(errors.errors[1][1] == 0.1, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(a_column_without_a_length_has_counts) {
  auto record = row({}, 0.1);
  record.specification = "[discretization]\nelements = 50\n";
  const auto table = case_tables({record}).front();
  BOOST_TEST(!table.spacing_is_length);
  BOOST_TEST(table.groups[0].levels[0].spacing == 0.02, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(a_specification_that_is_none_is_named) {
  auto record = row({}, 0.1);
  record.specification = "elements = = 5";
  const auto message = tests::message_of<InputError>([&] {
    case_tables({record}, {"results", {}, {}});
  });
  BOOST_TEST(tests::contains(message, "results: row " + record.id), message);
}

BOOST_AUTO_TEST_SUITE_END()
