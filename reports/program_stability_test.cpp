#include <boost/test/unit_test.hpp>

#include "reports/test_csv.hpp"
#include "reports/test_pictures.hpp"
#include "reports/test_program.hpp"

BOOST_AUTO_TEST_SUITE(program_stability)

using namespace porowave::tests;

namespace {

/// The paper's case on a small grid with regular points: linear shape functions, 0.707 or more.
CaseText small_case(const std::string& courant) {
  CaseText text;
  text.set("elements", "30").set("transfer", "\"shape\"").set("kernel", "\"bspline1\"");
  text.without("support_radius").without("basis_order").set("placement", "\"uniform\"");
  text.set("points_per_element", "1").set("courant", courant);
  return text;
}

porowave::reports::ProcessResult stability(const CaseText& text, const TestDirectory& folder,
                                           std::vector<std::string> more = {}) {
  write_text(folder / "case.toml", text.text());
  more.insert(more.begin(), {"stability", "case.toml"});
  return run_porowave(more, folder.path());
}

}  // namespace

BOOST_AUTO_TEST_CASE(it_prints_the_critical_step_and_estimates) {
  const TestDirectory folder;
  const auto result = stability(small_case("0.5"), folder);
  BOOST_TEST(result.exit_code == 0);
  BOOST_TEST(result.errors == "");
  for (const std::string part :
       {"time step ", "courant 0.4", "verdict            stable", "critical courant   0.7",
        "fast wave, h/c_1 ", "undrained wave", "linear shape functions", "(Mieremet)"}) {
    BOOST_TEST(contains(result.output, part), result.output << " lacks " << part);
  }
}

BOOST_AUTO_TEST_CASE(an_unstable_step_fails_a_check_only) {
  const TestDirectory folder;
  BOOST_TEST(stability(small_case("0.5"), folder, {"--check"}).exit_code == 0);
  const auto told = stability(small_case("0.8"), folder);
  BOOST_TEST(told.exit_code == 0);
  BOOST_TEST(contains(told.output, "verdict            unstable"));
  BOOST_TEST(stability(small_case("0.8"), folder, {"--check"}).exit_code == 1);
  BOOST_TEST(stability(small_case("0.8"), folder, {"--check", "--growth", "1"}).exit_code == 0);
}

BOOST_AUTO_TEST_CASE(files_hold_the_scan_and_the_mode) {
  const TestDirectory folder;
  const auto result = stability(small_case("0.5"), folder, {"--output", "out"});
  BOOST_TEST(result.exit_code == 0);
  const CsvText growth = read_csv(text_of(folder / "out/growth.csv"));
  BOOST_TEST(growth.header == "courant,time_step,growth,stable");
  BOOST_TEST(growth.rows.size() == 20u);
  const CsvText mode = read_csv(text_of(folder / "out/mode.csv"));
  BOOST_TEST(mode.rows.size() == 61u);
  check_pictures(folder / "out", "stability");
  for (const char* name : {"growth.csv", "mode.csv", "stability.png"}) {
    BOOST_TEST(contains(result.output, std::string("wrote out/") + name), result.output);
  }
}

BOOST_AUTO_TEST_CASE(without_an_unstable_step_no_mode_is_written) {
  const TestDirectory folder;
  const auto result = stability(small_case("0.5"), folder, {"--output", "out", "--highest", "0.6"});
  BOOST_TEST(result.exit_code == 0);
  BOOST_TEST(contains(result.output, "0.6 or more"));
  BOOST_TEST(!std::filesystem::exists(folder / "out/mode.csv"));
  check_pictures(folder / "out", "stability");
}

BOOST_AUTO_TEST_CASE(what_the_solver_refuses_is_refused) {
  const TestDirectory folder;
  CaseText text = small_case("0.5");
  text.set("transfer", "\"mls\"").add("discretization", "support_radius = 1.0");
  text.add("discretization", "empty_elements = [0.001, 0.004]");
  check_failure(stability(text, folder), 4, {"step 0", "loaded end"});
}

BOOST_AUTO_TEST_CASE(wrong_input_is_explained_in_one_line) {
  const TestDirectory folder;
  check_failure(run_porowave({"stability", "missing.toml"}), 2, {"missing.toml"});
  check_failure(stability(small_case("2"), folder), 2, {"case.toml", "courant"});
  check_failure(stability(small_case("0.5"), folder, {"--growth", "0"}), 2, {"--growth"});
  check_failure(stability(small_case("0.5"), folder, {"--highest", "much"}), 2, {"--highest"});
  check_failure(stability(small_case("0.5"), folder, {"--output", "case.toml"}), 5, {"case.toml"});
}

BOOST_AUTO_TEST_CASE(a_study_is_mapped) {
  const TestDirectory folder;
  const std::string axes =
      "[study]\nname = \"map\"\n[axes]\n\"discretization.points_per_element\" = [1, 2]\n"
      "\"time.courant\" = [0.3, 0.5]\n";
  write_text(folder / "study.toml", small_case("0.5").text() + axes);
  const auto result =
      run_porowave({"stability", "study.toml", "--output", "map", "--jobs", "1"}, folder.path());
  BOOST_TEST(result.exit_code == 0, result.errors);
  BOOST_TEST(contains(result.output, "4 cases in "));
  const CsvText map = read_csv(text_of(folder / "map/stability_map.csv"));
  BOOST_TEST_REQUIRE(map.rows.size() == 4u);
  BOOST_TEST(map.rows[0][2].starts_with("0.7"));
  check_pictures(folder / "map", "stability_map");
  check_failure(run_porowave({"stability", "study.toml"}, folder.path()), 2, {"--output"});
}

BOOST_AUTO_TEST_CASE(a_study_with_seeds_has_their_distribution) {
  const TestDirectory folder;
  write_text(folder / "study.toml", small_case("0.5").text() +
                                        "[study]\nname = \"seeds\"\n[axes]\n"
                                        "\"discretization.points_per_element\" = [1, 2]\n"
                                        "\"discretization.seed\" = [1, 2]\n");
  const auto result = run_porowave({"stability", "study.toml", "--output", "map"}, folder.path());
  BOOST_TEST(result.exit_code == 0, result.errors);
  BOOST_TEST(read_csv(text_of(folder / "map/stability_map.csv")).rows.size() == 4u);
  const CsvText seeds = read_csv(text_of(folder / "map/stability_seeds.csv"));
  BOOST_TEST_REQUIRE(seeds.rows.size() == 2u);
  BOOST_TEST(seeds.rows[0][1] == "2");
  check_pictures(folder / "map", "stability_seeds");
}

BOOST_AUTO_TEST_CASE(the_example_runs) {
  const TestDirectory folder;
  const auto result = run_example("stability", (folder / "out").string());
  BOOST_TEST(result.exit_code == 0, result.errors);
  check_pictures(folder / "out", "stability");
}

BOOST_AUTO_TEST_SUITE_END()
