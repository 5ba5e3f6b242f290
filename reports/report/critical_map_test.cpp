#include "reports/report/critical_map.hpp"

#include <boost/test/unit_test.hpp>

#include "reports/report/report_fixtures.hpp"
#include "reports/test_pictures.hpp"

BOOST_AUTO_TEST_SUITE(critical_map)

using namespace porowave;
using namespace porowave::reports;
using namespace porowave::tests;
using porowave::reports::report_fixtures::runnable_row;
using porowave::verification::Record;

namespace {

ReportContent content_of(const std::vector<Record>& rows) {
  ReportContent content;
  content.options.store = "results";
  content.options.output = "out";
  StudyReport study;
  study.table = case_tables(rows).front();
  content.studies.push_back(std::move(study));
  return content;
}

/// Two transfers, hardly any drag.
std::vector<Record> two_transfers(int elements, double courant) {
  std::vector<Record> rows;
  for (const char* transfer : {"shape", "mls"}) {
    const std::string words = std::string("transfer = \"") + transfer + "\"";
    rows.push_back(runnable_row(elements, 0.1, words + "\nplacement = \"uniform\"", courant));
    std::string& text = rows.back().specification;
    text.replace(text.find("1e-11"), 5, "1e-06");
  }
  return rows;
}

}  // namespace

// Linear shape functions with uniform points: stable up to 1/sqrt(2) (solver/time_step.hpp).
BOOST_AUTO_TEST_CASE(cases_beyond_their_critical_step_are_counted) {
  auto content = content_of(two_transfers(20, 0.5));
  add_critical_maps(content);
  BOOST_REQUIRE(content.studies[0].runs.size() == 1u);
  const ReportFigure& figure = content.studies[0].runs[0].figures.at(0);
  BOOST_TEST(contains(figure.claim, "(20 elements)"));
  BOOST_TEST(contains(figure.claim, "Of 2 scenes 1 are stable up to courant 1;"), figure.claim);
  BOOST_TEST(contains(figure.claim, "; 0 have a case beyond its critical step"));
  BOOST_TEST(contains(figure.claim, "transfer = shape"), figure.claim);
  const auto at = figure.claim.find("Lowest: ");
  BOOST_REQUIRE(at != std::string::npos);
  const double lowest = std::stod(figure.claim.substr(at + 8));
  BOOST_TEST(lowest >= 0.70);  // proven stable up to there
  BOOST_TEST(lowest < 0.9);
  auto beyond = content_of(two_transfers(20, 0.9));
  add_critical_maps(beyond);
  BOOST_TEST(contains(beyond.studies[0].runs.at(0).figures.at(0).claim, "; 1 have a case beyond"));
  const TestDirectory folder;
  BOOST_TEST(draw(figure.figure, folder.path()).size() == 5u);
  check_pictures(folder.path(), "stability_map");
}

// Groups that differ in the Courant number are one scene, which has a case beyond its critical step
// if any of them is.
BOOST_AUTO_TEST_CASE(the_longest_step_of_a_scene_is_held_against_it) {
  auto rows = two_transfers(20, 0.5);
  for (const auto& row : two_transfers(20, 0.9)) rows.push_back(row);
  auto content = content_of(rows);
  BOOST_REQUIRE(content.studies[0].table.groups.size() == 4u);
  add_critical_maps(content);
  const std::string claim = content.studies[0].runs.at(0).figures.at(0).claim;
  BOOST_TEST(contains(claim, "Of 2 scenes "), claim);
  BOOST_TEST(contains(claim, "; 1 have a case beyond"), claim);
}

BOOST_AUTO_TEST_CASE(what_takes_long_is_left_out_with_its_command) {
  auto content = content_of(two_transfers(1000, 0.5));
  add_critical_maps(content);
  BOOST_TEST(content.studies[0].runs.empty());
  BOOST_REQUIRE(content.run_notes.size() == 1u);
  BOOST_TEST(contains(content.run_notes[0], "of the 2 scenes of trial"));
  BOOST_TEST(contains(content.run_notes[0], "beyond --map-seconds 5"));
  BOOST_TEST(contains(content.run_notes[0], "porowave report results --output out --map-seconds "));
}

// Two studies, each of which would fit alone.
BOOST_AUTO_TEST_CASE(the_time_allowed_is_for_all_studies) {
  auto content = content_of(two_transfers(40, 0.5));
  auto none = content;
  none.options.map_seconds = 0.0;
  add_critical_maps(none);
  const std::string& note = none.run_notes.at(0);
  const double seconds = std::stod(note.substr(note.find("about ") + 6));
  content.studies.push_back(content.studies[0]);
  content.options.map_seconds = 1.5 * seconds;
  add_critical_maps(content);
  BOOST_TEST(content.studies[0].runs.size() == 1u);
  BOOST_TEST(content.studies[1].runs.empty());
  BOOST_REQUIRE(content.run_notes.size() == 1u);
  const std::string& left_out = content.run_notes[0];
  const auto at = left_out.find("--map-seconds ", left_out.find("drawn by"));
  BOOST_TEST(std::stod(left_out.substr(at + 14)) >= 1.9 * seconds);  // two digits are shown
}

// Groups that differ in the end of the run are one scene, and one scene is no map.
BOOST_AUTO_TEST_CASE(load_and_end_have_no_part_in_it) {
  auto rows = two_transfers(20, 0.5);
  const auto row = rows[0];
  rows = {row, row};
  rows[1].specification.replace(rows[1].specification.find("end = 3e-5"), 10, "end = 2e-5");
  rows[1].id += "x";
  auto content = content_of(rows);
  BOOST_REQUIRE(content.studies[0].table.groups.size() == 2u);
  add_critical_maps(content);
  BOOST_TEST(content.studies[0].runs.empty());
  BOOST_TEST(content.run_notes.empty());
}

BOOST_AUTO_TEST_SUITE_END()
