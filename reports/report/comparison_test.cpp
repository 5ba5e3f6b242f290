#include "reports/report/comparison.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reports/report/report_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(comparison)

using namespace porowave;
using namespace porowave::reports;
using namespace porowave::reports::report_fixtures;
using verification::Record;
namespace tt = boost::test_tools;

namespace {

/// The same cases after a change of the program: other ids.
std::vector<Record> after(const std::function<void(Record&)>& change) {
  auto rows = full_study();
  for (Record& row : rows) {
    row.id += "x";
    change(row);
  }
  return rows;
}

bool has(const Record& row, const std::string& text) {
  return row.specification.find(text) != std::string::npos;
}

const ComparedGroup& named(const Comparison& comparison, const std::string& name) {
  const auto found = std::find_if(comparison.groups.begin(), comparison.groups.end(),
                                  [&](const auto& g) { return g.group == name; });
  BOOST_REQUIRE_MESSAGE(found != comparison.groups.end(), name);
  return *found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_same_rows_are_the_same) {
  const auto result = compare(case_tables(full_study()), after([](Record&) {}), 0);
  BOOST_REQUIRE(result.groups.size() == 4u);
  for (const auto& group : result.groups) {
    BOOST_TEST(group.verdict == "same");
    BOOST_TEST(group.error_ratio == 1.0, tt::tolerance(1e-14));
    BOOST_TEST(group.cases == 12u);
  }
  BOOST_TEST(result.only_before == 0u);
  BOOST_TEST(result.only_after == 0u);
}

BOOST_AUTO_TEST_CASE(better_and_worse_are_told_by_the_finest_level) {
  const auto rows = after([](Record& row) {
    const bool finest = has(row, "elements = 200");
    if (has(row, "bspline1")) {
      for (double& m : row.measures) m *= finest ? 1.05 : 0.5;
    } else if (has(row, "support_radius = 3")) {
      for (double& m : row.measures) m *= 0.9;
      row.cpu_seconds *= 2.0;
    } else {
      for (double& m : row.measures) m *= 1.005;
    }
  });
  const auto result = compare(case_tables(full_study()), rows, 0);
  const auto& worse = named(result, "kernel = bspline1, support_radius = 2.0");
  BOOST_TEST(worse.verdict == "worse");
  BOOST_TEST(worse.error_ratio == 1.05, tt::tolerance(1e-12));
  BOOST_TEST(worse.worst_ratio == 1.05, tt::tolerance(1e-12));
  const auto& better = named(result, "kernel = bspline2, support_radius = 3.0");
  BOOST_TEST(better.verdict == "better");
  BOOST_TEST(better.error_ratio == 0.9, tt::tolerance(1e-12));
  BOOST_TEST(better.cost_ratio == 2.0, tt::tolerance(1e-12));
  BOOST_TEST(named(result, "kernel = bspline2, support_radius = 2.0").verdict == "same");
  BOOST_TEST(result.groups.front().verdict == "worse");
  BOOST_TEST(result.groups.back().verdict == "better");
}

BOOST_AUTO_TEST_CASE(cases_that_break_down_now_make_a_group_worse) {
  bool first = true;
  const auto rows = after([&](Record& row) {
    for (double& m : row.measures) m *= 0.5;
    if (first) row = broken(row);
    first = false;
  });
  const auto result = compare(case_tables(full_study()), rows, 0);
  BOOST_TEST(result.groups.front().now_broken == 1u);
  BOOST_TEST(result.groups.front().verdict == "worse");
  BOOST_TEST(result.groups[1].verdict == "better");
}

BOOST_AUTO_TEST_CASE(what_only_one_store_has_is_counted) {
  auto rows = after([](Record&) {});
  std::erase_if(rows, [](const Record& row) { return has(row, "bspline2"); });
  rows.push_back(row({"bspline3"}, 0.1));
  const auto result = compare(case_tables(full_study()), rows, 0);
  BOOST_TEST(result.only_before == 24u);
  BOOST_TEST(result.only_after == 1u);
  BOOST_TEST(named(result, "kernel = bspline2, support_radius = 2.0").verdict ==
             "nothing in common");
}

BOOST_AUTO_TEST_SUITE_END()
