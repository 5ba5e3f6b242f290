#include "reports/report/chosen_runs.hpp"

#include <boost/test/unit_test.hpp>

#include "reports/report/report_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(chosen_runs)

using namespace porowave::reports;
using namespace porowave::reports::report_fixtures;
using porowave::verification::Record;

namespace {

constexpr std::size_t measure = 1;

struct Chosen {
  StudyTable table;
  std::vector<ChosenRun> runs;

  explicit Chosen(const std::vector<Record>& rows) : table(case_tables(rows).front()) {
    runs = choose_runs(table, summaries_of(table, measure), measure);
  }
  const std::string& specification(std::size_t i) const {
    return table.rows[runs[i].row].specification;
  }
  std::vector<RunRole> roles() const {
    std::vector<RunRole> list;
    for (const ChosenRun& run : runs) list.push_back(run.role);
    return list;
  }
};

}  // namespace

// bspline2 with radius 2 has the smallest errors, bspline1 with radius 3 the largest; of the three
// seeds the second one has the error between the others'.
BOOST_AUTO_TEST_CASE(best_and_worst_at_the_finest_and_the_middle_level_by_the_median_seed) {
  const Chosen chosen(full_study());
  BOOST_REQUIRE(chosen.runs.size() == 4u);
  BOOST_TEST(chosen.specification(0) ==
             (MadeCase{"bspline2", 2.0, "step", 200, 2}.specification()));
  BOOST_TEST(chosen.specification(1) ==
             (MadeCase{"bspline1", 3.0, "step", 200, 2}.specification()));
  BOOST_TEST(chosen.specification(2) == (MadeCase{"bspline2", 2.0, "step", 50, 2}.specification()));
  BOOST_TEST(chosen.specification(3) == (MadeCase{"bspline1", 3.0, "step", 50, 2}.specification()));
  const std::vector<RunRole> expected = {RunRole::best_finest, RunRole::worst_finest,
                                         RunRole::best_middle, RunRole::worst_middle};
  BOOST_TEST((chosen.roles() == expected));
}

// Errors of two problems do not compare: the second one's are all larger, and still has its best.
BOOST_AUTO_TEST_CASE(every_problem_has_its_own_and_the_finest_levels_come_first) {
  auto rows = full_study();
  const std::size_t count = rows.size();
  for (std::size_t i = 0; i < count; ++i) {
    Record other = rows[i];
    other.specification.replace(other.specification.find("\"step\""), 6, "\"ramp\"");
    other.id += "r";
    for (double& m : other.measures) m *= 100.0;
    rows.push_back(other);
  }
  const Chosen chosen(rows);
  BOOST_REQUIRE(chosen.runs.size() == 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    BOOST_TEST(chosen.runs[i].problem == i % 2);
    BOOST_TEST(
        (chosen.specification(i).find(i % 2 == 0 ? "\"ramp\"" : "\"step\"") != std::string::npos));
    BOOST_TEST((chosen.runs[i].role <= RunRole::worst_finest) == (i < 4));
  }
}

BOOST_AUTO_TEST_CASE(what_broke_down_is_neither_best_nor_worst_but_has_a_run_of_its_own) {
  auto rows = full_study();
  for (Record& row : rows) {
    const bool best = row.specification.find("bspline2") != std::string::npos &&
                      row.specification.find("support_radius = 2.0") != std::string::npos;
    const bool here = row.specification.find("elements = 100") != std::string::npos ||
                      row.specification.find("elements = 200") != std::string::npos;
    if (best && here) row = broken(row);
  }
  rows[0] = broken(rows[0]);  // another group has one only
  const Chosen chosen(rows);
  BOOST_REQUIRE(chosen.runs.size() == 5u);
  BOOST_TEST(chosen.specification(0) ==
             (MadeCase{"bspline2", 3.0, "step", 200, 2}.specification()));
  BOOST_TEST((chosen.runs[2].role == RunRole::broke_down));
  BOOST_TEST(chosen.specification(2) ==
             (MadeCase{"bspline2", 2.0, "step", 100, 1}.specification()));
}

BOOST_AUTO_TEST_CASE(one_group_one_level_and_nothing_that_ended) {
  const Chosen one({row({}, 0.1)});
  BOOST_REQUIRE(one.runs.size() == 1u);
  BOOST_TEST((one.runs[0].role == RunRole::best_finest));
  const Chosen nothing({broken(row({}, 0.1))});
  BOOST_REQUIRE(nothing.runs.size() == 1u);
  BOOST_TEST((nothing.runs[0].role == RunRole::broke_down));
  const Chosen two({row({}, 0.1), row({"bspline1", 2.0, "step", 100}, 0.05)});
  BOOST_REQUIRE(two.runs.size() == 2u);
  BOOST_TEST((two.runs[1].role == RunRole::best_middle));
  BOOST_TEST(two.specification(1) == MadeCase{}.specification());
}

// Of two seeds none is between; the smaller error is taken, whatever the order of the rows.
BOOST_AUTO_TEST_CASE(of_two_seeds_the_smaller_error) {
  for (const bool first : {true, false}) {
    const Chosen chosen({row({"bspline1", 2.0, "step", 50, 1}, first ? 0.1 : 0.2),
                         row({"bspline1", 2.0, "step", 50, 2}, first ? 0.2 : 0.1)});
    BOOST_REQUIRE(chosen.runs.size() == 1u);
    BOOST_TEST(chosen.table.seeds[chosen.runs[0].row] == (first ? "1" : "2"));
  }
}

BOOST_AUTO_TEST_SUITE_END()
