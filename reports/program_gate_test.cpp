#include <boost/test/unit_test.hpp>

#include "reports/test_program.hpp"
#include "verification/store/store.hpp"

BOOST_AUTO_TEST_SUITE(program_gate)

using namespace porowave::tests;
using porowave::verification::Record;
using porowave::verification::Store;

namespace {

/// One kernel, smooth load, three levels: its order is two.
std::string study_text(const std::string& gate) {
  return CaseText()
             .set("shape", "\"sin4_pulse\"")
             .set("duration", "2e-5")
             .set("placement", "\"uniform\"")
             .add("discretization", "strain = \"recovered\"")
             .text() +
         "[study]\nname = \"trial <&>\"\n[axes]\n\"discretization.elements\" = [100, 200, 400]\n"
         "[refine]\nby = \"discretization.elements\"\n" +
         gate;
}

struct Gate {
  TestDirectory folder;

  Gate() {
    write_text(folder / "study.toml", study_text(""));
    BOOST_REQUIRE(
        run_porowave({"sweep", "study.toml", "--store", "results"}, folder.path()).exit_code == 0);
  }
  porowave::reports::ProcessResult operator()(const std::string& rules,
                                              std::vector<std::string> words = {}) const {
    write_text(folder / "study.toml", study_text(rules));
    words.insert(words.begin(), {"gate", "study.toml", "--store", "results"});
    return run_porowave(words, folder.path());
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(exit_codes_of_all_five_verdicts) {
  const Gate gate;
  const std::string known = "[[known_failure]]\nreason = \"issue 7\"\n";
  const auto pass = gate("[gate]\norder = 2.0\n", {"--all"});
  BOOST_TEST(pass.exit_code == 0);
  BOOST_TEST(contains(pass.output, "pass: 8 pass, 0 fail, 0 xfail, 0 xpass, 0 inconclusive\n"),
             pass.output);
  const auto fail = gate("[gate]\norder = 3.0\n");
  BOOST_TEST(fail.exit_code == 1);
  BOOST_TEST(contains(fail.output, "expected 3 ± 0.25: too low"), fail.output);
  const auto xfail = gate("[gate]\norder = 3.0\n" + known, {"--all"});
  BOOST_TEST(xfail.exit_code == 0);
  BOOST_TEST(contains(xfail.output, "8 xfail"), xfail.output);
  const auto xpass = gate("[gate]\norder = 2.0\n" + known);
  BOOST_TEST(xpass.exit_code == 1);
  BOOST_TEST(contains(xpass.output, "issue 7"), xpass.output);
  const auto inconclusive = gate("");
  BOOST_TEST(inconclusive.exit_code == 3);
  BOOST_TEST(contains(inconclusive.output, "nothing to compare with"), inconclusive.output);
}

BOOST_AUTO_TEST_CASE(a_baseline_is_made_with_a_reason_and_then_holds) {
  const Gate gate;
  const auto made = gate("", {"--baseline", "b.csv", "--rebaseline", "first figures"});
  BOOST_TEST(made.exit_code == 0);
  BOOST_TEST(contains(text_of(gate.folder / "b.csv"), ": first figures\n"));
  BOOST_TEST(gate("", {"--baseline", "b.csv"}).exit_code == 0);
  // A row of the finest level that is 3 % worse.
  std::vector<Record> rows = Store::open((gate.folder / "results").string()).all();
  std::filesystem::remove(gate.folder / "results");
  for (Record& row : rows) {
    if (!contains(row.specification, "elements = 400")) continue;
    for (double& m : row.measures) m *= 1.03;
  }
  Store::create_or_open((gate.folder / "results").string()).add(rows);
  const auto worse = gate("", {"--baseline", "b.csv", "--junit", "junit.xml"});
  BOOST_TEST(worse.exit_code == 1);
  BOOST_TEST(contains(worse.output, "+3.0 % against the baseline"), worse.output);
  const std::string junit = text_of(gate.folder / "junit.xml");
  BOOST_TEST(contains(junit, "<testsuite name=\"trial &lt;&amp;&gt;\" tests=\"8\" failures=\"8\""));
  BOOST_TEST(contains(junit, "<failure type=\"fail\" message=\"level = 400: error"));
}

BOOST_AUTO_TEST_CASE(missing_cases_are_inconclusive_and_named) {
  const Gate gate;
  const auto rows = Store::open((gate.folder / "results").string()).all();
  std::filesystem::remove(gate.folder / "results");
  Store::create_or_open((gate.folder / "results").string()).add({rows[0], rows[1]});
  const auto result = gate("[gate]\norder = 2.0\n");
  BOOST_TEST(result.exit_code == 3);
  BOOST_TEST(contains(result.output, "incomplete: 1 of 3 cases missing: discretization.elements ="),
             result.output);
}

BOOST_AUTO_TEST_CASE(wrong_input_is_refused) {
  const Gate gate;
  check_failure(gate("", {"--baseline", "none.csv"}), 2, {"none.csv"});
  check_failure(gate("", {"--rebaseline", "why"}), 2, {"--baseline"});
  check_failure(gate("", {"--baseline", "b.csv", "--rebaseline", "two\nlines"}), 2, {"one line"});
  check_failure(gate("", {"--baseline", "b.csv", "--rebaseline", ""}), 2, {"not empty"});
  check_failure(gate("[gate]\nmeasures = [\"p\"]\n"), 2, {"[gate] measures"});
  BOOST_TEST(gate.folder.contents() == "results study.toml");
  std::filesystem::remove(gate.folder / "results");
  check_failure(gate("[gate]\norder = 2.0\n"), 2, {"results", "store"});
}

BOOST_AUTO_TEST_SUITE_END()
