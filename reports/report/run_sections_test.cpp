#include "reports/report/run_sections.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <sstream>

#include "reference/problem/problem_fixtures.hpp"
#include "reports/report/report_fixtures.hpp"
#include "reports/report/run_claims.hpp"
#include "reports/test_pictures.hpp"
#include "verification/run.hpp"

BOOST_AUTO_TEST_SUITE(run_sections)

using namespace porowave;
using namespace porowave::reports;
using namespace porowave::tests;
using porowave::reports::report_fixtures::runnable_row;
using porowave::verification::Record;
namespace tt = boost::test_tools;

namespace {

constexpr std::size_t stress_field_l2 = 4;

std::string text(const Figure& figure, const std::string& variable) {
  for (const auto& [name, value] : figure.texts) {
    if (name == variable) return value;
  }
  return "absent";
}

ReportContent content_of(const std::vector<Record>& rows) {
  ReportContent content;
  content.options.store = "my store";
  content.options.output = "out";
  StudyReport study;
  study.table = case_tables(rows).front();
  study.measure = stress_field_l2;
  study.measures = {stress_field_l2};
  study.summaries = {summaries_of(study.table, stress_field_l2)};
  content.studies.push_back(std::move(study));
  return content;
}

std::string all_notes(const ReportContent& content) {
  std::string notes;
  for (const std::string& note : content.run_notes) notes += note + "\n";
  return notes;
}

const std::string unstable = "transfer = \"shape\"";

}  // namespace

BOOST_AUTO_TEST_CASE(a_problem_has_profiles_spectra_and_each_run_over_space_and_time) {
  auto content =
      content_of({runnable_row(25, 0.2), runnable_row(50, 0.1), runnable_row(100, 0.05)});
  add_runs(content);
  BOOST_TEST(all_notes(content) == "");
  BOOST_REQUIRE(content.studies[0].runs.size() == 1u);
  const auto& figures = content.studies[0].runs[0].figures;
  BOOST_REQUIRE(figures.size() == 4u);
  BOOST_TEST(figures[0].figure.name == "run_1_profiles");
  BOOST_TEST(figures[1].figure.name == "run_1_spectra");
  BOOST_TEST(figures[3].figure.name == "run_1_space_time_2");
  BOOST_TEST(text(figures[0].figure, "row1") ==
             "best method, finest level: 100 elements, t = 30 µs");
  // The load begins at t = 0 and travels with the speeds of both waves.
  const auto speeds = wave_speeds(fixtures::paper_problem().material);
  std::istringstream fronts(text(figures[0].figure, "fronts1"));
  double slow = 0.0, fast = 0.0;
  fronts >> slow >> fast;
  BOOST_TEST(slow == 3e-5 * speeds.p2, tt::tolerance(1e-8));
  BOOST_TEST(fast == 3e-5 * speeds.p1, tt::tolerance(1e-8));
  BOOST_TEST(text(figures[0].figure, "waves1") == "P2 P1 ");
  for (const ReportFigure& figure : figures) {
    BOOST_TEST(figure.alt.size() > figure.claim.size());
    BOOST_TEST(figure.figure.has_pdf());
  }
  const TestDirectory folder;
  for (const ReportFigure& figure : figures) {
    BOOST_TEST(draw(figure.figure, folder.path()).size() == 5u);
    check_pictures(folder.path(), figure.figure.name);
  }
}

// The error of the run is the store's if the store has that of this build; the row is made up, so
// the report must say that it differs.
BOOST_AUTO_TEST_CASE(the_error_of_a_run_is_that_of_the_case) {
  auto content = content_of({runnable_row(50, 0.25)});
  const auto runs = finished_runs(plan_runs(content), content);
  BOOST_REQUIRE(runs.size() == 1u);
  const auto scene = runs[0].plan.scene;
  const auto run = verification::run_case(scene, *verification::reference_profile(scene));
  BOOST_TEST(runs[0].error == run.errors[0].field.l2, tt::tolerance(1e-12));
  BOOST_TEST(contains(
      outcome_text(runs[0], content.studies[0]),
      "relative error " + error_text(run.errors[0].field.l2) + " here, " + error_text(0.25)));
  auto same = content_of({runnable_row(50, run.errors[0].field.l2)});
  BOOST_TEST(!contains(outcome_text(runs[0], same.studies[0]), "in the store"));
}

BOOST_AUTO_TEST_CASE(a_breakdown_is_shown_until_it_happens) {
  auto row = report_fixtures::broken(runnable_row(200, 0.1, unstable, 1.0));
  auto content = content_of({row});
  add_runs(content);
  const auto& section = content.studies[0].runs.at(0);
  BOOST_REQUIRE(!section.figures.empty());
  const ReportFigure& profiles = section.figures[0];
  BOOST_TEST(contains(profiles.claim, "broke down: "));
  BOOST_TEST(contains(profiles.claim, "breaks down: step "));
  const std::string title = text(profiles.figure, "row1");
  const double microseconds = std::stod(title.substr(title.find("t = ") + 4));
  BOOST_TEST(microseconds > 0.0);
  BOOST_TEST(microseconds < 30.0);
  BOOST_TEST(!contains(profiles.figure.data, "nan"));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_run_is_named_with_what_would) {
  auto other = runnable_row(50, 0.1);
  other.specification += "[adapter]\ncommand = [\"./mine\"]\n";
  auto adapter = content_of({other});
  add_runs(adapter);
  BOOST_TEST(adapter.studies[0].runs.empty());
  BOOST_TEST(contains(all_notes(adapter), "run by another program"));
  BOOST_TEST(contains(all_notes(adapter), "sweep its study into a new store"));
  BOOST_TEST(!contains(all_notes(adapter), "--case"));     // sweep --case takes cases of ours only
  auto odd = content_of({report_fixtures::row({}, 0.1)});  // no material
  add_runs(odd);
  BOOST_TEST(contains(all_notes(odd), "this program cannot run it: "));
  BOOST_TEST(contains(all_notes(odd), "[material]"));
}

BOOST_AUTO_TEST_CASE(the_bounds_on_number_and_time_hold_and_are_named) {
  auto content =
      content_of({runnable_row(25, 0.2), runnable_row(50, 0.1), runnable_row(100, 0.05)});
  content.options.runs = 1;
  RunPlan plan = plan_runs(content);
  BOOST_TEST(plan.runs.size() == 1u);
  BOOST_REQUIRE(plan.notes.size() == 1u);
  BOOST_TEST(contains(plan.notes[0],
                      "1 more are beyond --runs 1. All of them: porowave report "
                      "'my store' --output out --runs 2"));
  content.options.runs = 8;
  // The finest case has cost an hour; the other one fits.
  content.studies[0].table.rows[2].cpu_seconds = 3600.0;
  plan = plan_runs(content);
  BOOST_TEST(plan.runs.size() == 1u);
  BOOST_TEST((plan.runs[0].chosen.role == RunRole::best_middle));
  BOOST_REQUIRE(plan.notes.size() == 1u);
  BOOST_TEST(contains(plan.notes[0], "beyond --run-seconds 20"));
  BOOST_TEST(contains(plan.notes[0], "--run-seconds 3601"));
  // Either would fit alone.
  for (const std::size_t row : {1u, 2u}) content.studies[0].table.rows[row].cpu_seconds = 12.0;
  plan = plan_runs(content);
  BOOST_TEST(plan.runs.size() == 1u);
  BOOST_TEST((plan.runs[0].chosen.role == RunRole::best_finest));
  content.options.run_seconds = 25.0;
  BOOST_TEST(plan_runs(content).runs.size() == 2u);
  content.options.runs = 0;
  BOOST_TEST(plan_runs(content).runs.empty());
}

// A wave that comes late by half a cell everywhere: the error stands where the fields change most,
// and that is on the ways of the waves.
BOOST_AUTO_TEST_CASE(the_largest_error_is_found_with_the_wave_next_to_it) {
  solver::Case scene;
  scene.problem = fixtures::paper_problem(Load(LoadShape::step, 2.0));
  scene.discretization.elements = 100;
  scene.time.end = 3e-5;
  RunHistory history = run_history(scene, 3);
  for (auto& frame : history.frames) {
    for (std::size_t c = 0; c < frame.reference.size(); ++c) {
      frame.snapshot.effective_stress[c] = frame.reference[c].effective_stress;
    }
  }
  BOOST_TEST(largest_error(history).error == 0.0);
  auto& middle = history.frames[1];
  const double fast = wave_speeds(scene.problem.material).p1 * middle.snapshot.time;
  const auto cell = static_cast<std::size_t>(fast / 1e-3) - 2;
  middle.snapshot.effective_stress[cell] += 0.5;
  const LargestError found = largest_error(history);
  BOOST_TEST(found.error == 0.25, tt::tolerance(1e-12));
  BOOST_TEST(found.x == middle.snapshot.cell_x[cell]);
  BOOST_TEST(found.t == middle.snapshot.time);
  BOOST_REQUIRE(found.nearest.has_value());
  BOOST_TEST(found.nearest->fast);
  BOOST_TEST(found.nearest->cells == (fast - found.x) / 1e-3, tt::tolerance(1e-9));
  const double slow = wave_speeds(scene.problem.material).p2 * middle.snapshot.time;
  middle.snapshot.effective_stress[static_cast<std::size_t>(slow / 1e-3)] += 0.8;
  BOOST_TEST(!largest_error(history).nearest->fast);
  BOOST_TEST(largest_error(history).nearest->cells <= 0.5);
}

BOOST_AUTO_TEST_SUITE_END()
