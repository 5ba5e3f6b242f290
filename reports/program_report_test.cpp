#include <boost/test/unit_test.hpp>
#include <chrono>
#include <ctime>
#include <map>
#include <thread>

#include "reports/report/report_fixtures.hpp"
#include "reports/test_pictures.hpp"
#include "reports/test_program.hpp"
#include "verification/store/store.hpp"

BOOST_AUTO_TEST_SUITE(program_report)

using namespace porowave::tests;
using porowave::verification::Record;
using porowave::verification::Store;

namespace {

/// Two kernels, two seeds, three coarse levels.
std::string study_text(const std::string& name, const std::string& axes, const std::string& rest) {
  return CaseText()
             .set("shape", "\"sin4_pulse\"")
             .set("duration", "2e-5")
             .add("discretization", "strain = \"recovered\"")
             .text() +
         "[study]\nname = '" + name + "'\n[axes]\n" + axes + rest;
}

const std::string small_axes =
    "\"discretization.kernel\" = [\"bspline1\", \"bspline2\"]\n"
    "\"discretization.seed\" = { first = 1, count = 2 }\n"
    "\"discretization.elements\" = [50, 100, 200]\n"
    "[refine]\nby = \"discretization.elements\"\n";

struct Report {
  TestDirectory folder;

  void sweep(const std::string& text) const {
    write_text(folder / "study.toml", text);
    const auto result = run_porowave({"sweep", "study.toml", "--store", "results"}, folder.path());
    BOOST_REQUIRE_MESSAGE(result.exit_code == 0, result.errors);
  }
  porowave::reports::ProcessResult operator()(std::vector<std::string> words = {},
                                              const std::string& output = "report") const {
    words.insert(words.begin(), {"report", "results", "--output", output});
    const auto given = [&](const char* option) {
      return std::find(words.begin(), words.end(), option) != words.end();
    };
    if (!given("--runs") && !given("--run-seconds")) words.insert(words.end(), {"--runs", "0"});
    return run_porowave(words, folder.path());
  }
  std::string page(const std::string& output = "report") const {
    return text_of(folder / output / "index.html");
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_swept_store_becomes_a_report_twice_the_same) {
  const Report report;
  report.sweep(study_text("small \"<study>\" & more", small_axes, "[gate]\norder = 2.0\n"));
  const auto result = report({"--runs", "1"});
  BOOST_TEST(result.exit_code == 0);
  BOOST_TEST(result.errors == "");
  BOOST_TEST(contains(result.output, "wrote report/index.html\n"));
  const std::string names = report.folder.contents();
  for (const char* name : {"convergence_01.pdf", "convergence_01.csv", "convergence_01.gp",
                           "work_precision_01.png", "cost_1.svg", "groups.csv", "groups.tex",
                           "cases.csv", "pareto.csv", "summary.md", "index.html"}) {
    BOOST_TEST(contains(names, std::string("report/") + name), name);
  }
  BOOST_TEST(contains(report.page(), "small &quot;&lt;study&gt;&quot; &amp; more"));
  const auto second = [] { return std::time(nullptr); };
  for (const auto first = second(); second() == first;) {  // a PDF may hold the time in seconds
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  // The page names the directory that it is written to.
  std::filesystem::rename(report.folder / "report", report.folder / "again");
  BOOST_REQUIRE(report({"--runs", "1"}).exit_code == 0);
  for (const auto& entry : std::filesystem::directory_iterator(report.folder / "report")) {
    BOOST_TEST(
        (text_of(entry.path()) == text_of(report.folder / "again" / entry.path().filename())),
        entry.path());
  }
}

BOOST_AUTO_TEST_CASE(verdicts_are_those_of_the_gate_and_come_first) {
  const Report report;
  report.sweep(study_text("small", small_axes, "[gate]\norder = 3.0\n"));
  const auto gate =
      run_porowave({"gate", "study.toml", "--store", "results", "--all"}, report.folder.path());
  BOOST_TEST(gate.exit_code == 1);
  BOOST_REQUIRE(report({"--study", "study.toml"}).exit_code == 0);
  const std::string text = report.page();
  // "fail: 8 pass, ..." is the gate's last line.
  const auto last = gate.output.rfind('\n', gate.output.size() - 2) + 1;
  const std::string outcome = gate.output.substr(last, gate.output.size() - last - 1);
  BOOST_TEST(contains(text, outcome), outcome);
  BOOST_TEST(text.find(outcome) < text.find("<figure"));
  BOOST_TEST(contains(text_of(report.folder / "report/summary.md"), "**" + outcome + "**"));
  const std::string verdicts = text_of(report.folder / "report/verdicts.csv");
  BOOST_TEST(std::count(verdicts.begin(), verdicts.end(), '\n') == 1 + 2 * 8);
  BOOST_TEST(contains(text, "porowave sweep study.toml --store results --case "));
}

/// What `porowave gate` prints of every verdict: "kind: group: measure: reason".
void check_same_verdicts(const Report& report, const std::vector<std::string>& options) {
  std::vector<std::string> words = {"gate",  "study.toml", "--store", "results",
                                    "--all", "--junit",    "gate.xml"};
  words.insert(words.end(), options.begin(), options.end());
  const auto gate = run_porowave(words, report.folder.path());
  words = {"--study", "study.toml", "--junit", "report.xml"};
  words.insert(words.end(), options.begin(), options.end());
  const auto made = report(words);
  BOOST_REQUIRE_MESSAGE(made.exit_code == 0, made.errors);
  BOOST_TEST(contains(made.output, "wrote report.xml\n"));
  BOOST_TEST(text_of(report.folder / "report.xml") == text_of(report.folder / "gate.xml"));
  BOOST_TEST(contains(text_of(report.folder / "gate.xml"), "<testcase "));
}

BOOST_AUTO_TEST_CASE(junit_is_that_of_the_gate_with_costs_and_causes_of_floors) {
  const Report report;
  report.sweep(
      study_text("<small> & \"odd\"", small_axes, "[gate]\norder = 2.0\ncost_tolerance = 1.0\n"));
  check_same_verdicts(report, {});
  BOOST_TEST(contains(text_of(report.folder / "report.xml"), "relative_cost"));
  BOOST_TEST(contains(text_of(report.folder / "report.xml"),
                      "<testsuite name=\"&lt;small&gt; &amp; &quot;odd&quot;\""));
  check_failure(report({"--junit", "j.xml"}), 2, {"--junit", "--study"});
  check_failure(report({"--study", "study.toml", "--junit", "none/j.xml"}, "other"), 5,
                {"none/j.xml"});
  BOOST_TEST(!std::filesystem::exists(report.folder / "other"));
}

// Shorter steps do not help where the elements are long.
BOOST_AUTO_TEST_CASE(floors_have_the_cause_that_the_gate_names) {
  const Report report;
  report.sweep(study_text("still",
                          "\"time.courant\" = [0.4, 0.2, 0.1, 0.05]\n"
                          "[refine]\nby = \"time.courant\"\n",
                          "[gate]\norder = 2.0\nmeasures = [\"effective_stress_field_l2\"]\n"));
  check_same_verdicts(report, {});
  BOOST_TEST(contains(text_of(report.folder / "report/verdicts.csv"), "made by the elements: "));
  BOOST_TEST(contains(report.page(), "made by the elements: "));
  BOOST_REQUIRE(report({"--study", "study.toml", "--floor-seconds", "0"}).exit_code == 0);
  BOOST_TEST(!contains(report.page(), "made by the elements"));
  BOOST_TEST(contains(report.page(), "porowave gate study.toml --store results names"));
}

BOOST_AUTO_TEST_CASE(the_command_of_a_case_runs_it_again) {
  const Report report;
  report.sweep(study_text("small", "\"discretization.elements\" = [50]\n", ""));
  BOOST_REQUIRE(report({"--study", "study.toml"}).exit_code == 0);
  const auto id = Store::open((report.folder / "results").string()).all().front().id;
  BOOST_TEST(contains(report.page(), id));
  const auto again = run_porowave({"sweep", "study.toml", "--store", "results", "--case", id},
                                  report.folder.path());
  BOOST_TEST(again.exit_code == 0);
}

BOOST_AUTO_TEST_CASE(some_cases_are_run_again_for_their_fields) {
  const Report report;
  report.sweep(study_text("small", small_axes, ""));
  BOOST_REQUIRE(report({"--runs", "1"}).exit_code == 0);
  const std::string page = report.page();
  for (const char* name : {"run_1_profiles", "run_1_spectra", "run_1_space_time_1"}) {
    BOOST_TEST(contains(page, std::string("<figure id=\"figure_") + name), name);
    BOOST_TEST(contains(page, std::string("<a href=\"") + name + ".dat\""), name);
    for (const char* ending : {".svg", ".png", ".pdf", ".gp", ".dat"}) {
      BOOST_TEST(std::filesystem::exists(report.folder / "report" / (std::string(name) + ending)));
    }
  }
  BOOST_TEST(!contains(page, "which another build has filled"));  // it is this build's
  BOOST_TEST(contains(page,
                      "3 more are beyond --runs 1. All of them: porowave report results "
                      "--output report --runs 4"));
  BOOST_TEST(!contains(page, "run_1_space_time_2"));
  BOOST_REQUIRE(report({"--runs", "0"}, "none").exit_code == 0);
  BOOST_TEST(!contains(report.page("none"), "figure_run_"));
  check_failure(report({"--runs", "-1"}), 2, {"--runs"});
  BOOST_REQUIRE(report({"--run-seconds", "0"}, "cheap").exit_code == 0);
  BOOST_TEST(contains(report.page("cheap"), "beyond --run-seconds 0"));
}

BOOST_AUTO_TEST_CASE(stores_with_failures_one_level_and_nothing) {
  const Report report;
  const std::string store = (report.folder / "results").string();
  Store::create_or_open(store);
  BOOST_TEST(report().exit_code == 0);
  BOOST_TEST(contains(report.page(), "the store holds no cases"));
  using namespace porowave::reports::report_fixtures;
  Store::create_or_open(store).add({broken(row({}, 0.1))});
  BOOST_TEST(report().exit_code == 0);
  BOOST_TEST(contains(report.page(), "trial: 1 cases, 1 broke down"));
  BOOST_TEST(contains(report.page(), "step 7: &lt;it&gt; broke &quot;down&quot;"));
  BOOST_TEST(contains(report.page(), "No case has ended"));
  Store::create_or_open(store).add(
      {row({"bspline2"}, 0.2), row({"bspline2", 2.0, "step", 100}, 0.1, "other")});
  BOOST_TEST(report().exit_code == 0);
  BOOST_TEST(contains(report.page(), "<h1>other, trial</h1>"));
  BOOST_TEST(contains(report.folder.contents(), "report/1_other_work_precision_01.svg"));
}

BOOST_AUTO_TEST_CASE(two_stores_are_compared) {
  const Report report;
  using namespace porowave::reports::report_fixtures;
  Store::create_or_open((report.folder / "results").string()).add(full_study());
  auto rows = full_study();
  for (Record& row : rows) {
    if (!contains(row.specification, "bspline2")) continue;
    for (double& m : row.measures) m *= 1.5;
  }
  Store::create_or_open((report.folder / "after").string()).add(rows);
  BOOST_TEST(report({"--compare", "after"}).exit_code == 0);
  BOOST_TEST(contains(report.page(), "Compared with after: 0 better, 2 worse, 2 same"));
  BOOST_TEST(contains(text_of(report.folder / "report/comparison.csv"), "worse,trial,"));
}

BOOST_AUTO_TEST_CASE(wrong_input_is_refused_and_leaves_nothing) {
  const Report report;
  check_failure(report(), 2, {"results", "store"});
  write_text(report.folder / "results",
             "no database, but long enough to be taken for a file of it");
  check_failure(report(), 2, {"results"});
  std::filesystem::remove(report.folder / "results");
  using namespace porowave::reports::report_fixtures;
  Store::create_or_open((report.folder / "results").string()).add(full_study());
  check_failure(report({"--study", "none.toml"}), 2, {"none.toml"});
  check_failure(report({"--baseline", "b.csv"}), 2, {"--baseline", "--study"});
  check_failure(report({"--measure", "p"}), 2, {"--measure p", "effective_stress_field_l2"});
  check_failure(report({"--compare", "none"}), 2, {"none"});
  auto odd = row({"bspline9"}, 0.1);
  odd.specification = "= 1";
  Store::create_or_open((report.folder / "odd").string()).add({odd});
  check_failure(run_porowave({"report", "odd", "--output", "report"}, report.folder.path()), 2,
                {"odd: row " + odd.id});
  BOOST_TEST(!std::filesystem::exists(report.folder / "report"));
}

BOOST_AUTO_TEST_CASE(an_environment_that_cannot_is_exit_5) {
  const Report report;
  using namespace porowave::reports::report_fixtures;
  Store::create_or_open((report.folder / "results").string()).add(full_study());
  write_text(report.folder / "file", "");
  check_failure(report({}, "file"), 5, {"file"});
  check_failure(report({}, "/proc/report"), 5, {"/proc/report"});
  const TestVariable path("PATH", "/nowhere");
  check_failure(report(), 5, {"gnuplot"});
  BOOST_TEST(!std::filesystem::exists(report.folder / "report"));
}

BOOST_AUTO_TEST_SUITE_END()
