#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <random>
#include <thread>

#include "reports/test_program.hpp"
#include "verification/store/store.hpp"

BOOST_AUTO_TEST_SUITE(program_sweep)

using namespace porowave::tests;
using porowave::verification::Record;
using porowave::verification::Store;

namespace {

/// The paper's case on coarse grids, many seeds: some seconds of work.
std::string study_text(int seeds) {
  return CaseText().set("elements", "50").text() +
         "[study]\nname = \"trial\"\n[axes]\n\"discretization.kernel\" = [\"bspline1\", "
         "\"bspline2\"]\n\"discretization.seed\" = { first = 1, count = " +
         std::to_string(seeds) + " }\n\"discretization.elements\" = [50, 100]\n";
}

/// Everything of a row that must not depend on when and how it was made.
std::string essence(const Record& row) {
  std::string text = row.id + row.specification + row.reason + std::to_string(row.steps);
  for (const double m : row.measures) {
    char bits[64];
    std::snprintf(bits, sizeof bits, " %a", m);
    text += bits;
  }
  return text;
}

std::vector<std::string> essences(const std::filesystem::path& store) {
  std::vector<std::string> rows;
  for (const Record& row : Store::open(store.string()).all()) rows.push_back(essence(row));
  return rows;
}

/// 0 where there is no store yet, or one whose making was cut short.
std::size_t rows_in(const std::filesystem::path& store) {
  try {
    return Store::open(store.string()).all().size();
  } catch (const std::exception&) {
    return 0;
  }
}

/// Starts a sweep, kills it without warning after a while; true if it was still running.
bool kill_after(const TestDirectory& folder, int milliseconds) {
  const pid_t child = fork();
  if (child == 0) {
    if (chdir(folder.path().c_str()) != 0 || !freopen("/dev/null", "w", stdout)) _exit(127);
    execl(POROWAVE_PROGRAM, POROWAVE_PROGRAM, "sweep", "study.toml", "--store", "results", nullptr);
    _exit(127);
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_sweep_killed_ten_times_ends_with_the_rows_of_one_that_was_not) {
  const TestDirectory folder;
  write_text(folder / "study.toml", study_text(300));
  const auto start = std::chrono::steady_clock::now();
  BOOST_TEST(run_porowave({"sweep", "study.toml", "--store", "alone"}, folder.path()).exit_code ==
             0);
  const auto whole = std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::steady_clock::now() - start);
  std::mt19937 random(20261122);
  int killed = 0;
  std::size_t before = 0;
  double longest = static_cast<double>(whole.count()) / 6.0;  // ms
  for (int i = 0; i < 10; ++i) {
    killed +=
        kill_after(folder, static_cast<int>(std::uniform_real_distribution(0.0, longest)(random)));
    before = rows_in(folder / "results");
    // A busy machine is now slower, now faster than when the whole sweep was timed.
    if (before == 0) longest *= 1.3;
    if (before > 600) longest *= 0.2;
  }
  const auto last = run_porowave({"sweep", "study.toml", "--store", "results"}, folder.path());
  BOOST_TEST(last.exit_code == 0);
  BOOST_TEST_MESSAGE(killed << " of 10 sweeps were killed at work, one takes " << whole.count()
                            << " ms; they left " << before
                            << " rows; the last one said: " << last.output);
  BOOST_TEST(killed >= 3);
  const auto rows = essences(folder / "results");
  BOOST_TEST(rows.size() == 1200U);
  BOOST_TEST(before > 0U);  // or nothing was continued
  BOOST_TEST(before < rows.size());
  BOOST_TEST(rows == essences(folder / "alone"), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(shards_merge_to_the_whole) {
  const TestDirectory folder;
  write_text(folder / "study.toml", study_text(3));
  BOOST_TEST(run_porowave({"sweep", "study.toml", "--store", "alone"}, folder.path()).exit_code ==
             0);
  for (const std::string part : {"1", "2"}) {
    const auto result = run_porowave(
        {"sweep", "study.toml", "--store", "part" + part, "--shard", part + "/2"}, folder.path());
    BOOST_TEST(contains(result.output, "6 cases: 0 were in the store"));
  }
  const auto merged = run_porowave({"merge", "whole", "part1", "part2"}, folder.path());
  BOOST_TEST(merged.output == "12 rows, 12 of them new\nwrote whole\n");
  write_text(folder / "part3", "");  // of a sweep killed while it made its store
  const auto more = run_porowave({"merge", "whole", "part1", "part3"}, folder.path());
  BOOST_TEST(more.exit_code == 0);
  BOOST_TEST(contains(more.output, "part3 is empty: no rows\n12 rows, 0 of them new"), more.output);
  check_failure(run_porowave({"merge", "whole", "part1", "whole"}, folder.path()), 2,
                {"whole: is the store that takes the rows"});
  BOOST_TEST(essences(folder / "whole") == essences(folder / "alone"),
             boost::test_tools::per_element());
  const auto again = run_porowave({"sweep", "study.toml", "--store", "whole"}, folder.path());
  BOOST_TEST(contains(again.output, "12 cases: 12 were in the store"));
}

BOOST_AUTO_TEST_CASE(one_case_can_be_repeated_and_compared) {
  const TestDirectory folder;
  write_text(folder / "study.toml", study_text(1));
  run_porowave({"sweep", "study.toml", "--store", "results"}, folder.path());
  Record row;
  {
    const auto rows = Store::open((folder / "results").string()).all();
    BOOST_REQUIRE(rows.size() == 4U);
    row = rows[2];
  }
  const auto repeat = [&](const std::string& store, const std::string& id) {
    return run_porowave({"sweep", "study.toml", "--store", store, "--case", id}, folder.path());
  };
  const auto same = repeat("results", row.id.substr(0, 12));
  BOOST_TEST(same.exit_code == 0);
  BOOST_TEST(contains(same.output, row.id));
  BOOST_TEST(!contains(same.output, "differs"));
  row.measures[1] *= 1.001;
  Store::create_or_open((folder / "changed").string()).add(std::vector{row});
  const auto changed = repeat("changed", row.id);
  BOOST_TEST(changed.exit_code == 1);
  BOOST_TEST(contains(changed.output, "differs"));
  check_failure(repeat("results", "zz"), 2, {"results", "0 rows", "zz", "expected one"});
}

BOOST_AUTO_TEST_CASE(wrong_input_is_refused_and_leaves_no_store) {
  const TestDirectory folder;
  write_text(folder / "study.toml", study_text(2));
  write_text(folder / "wrong.toml", study_text(2) + "[refine]\nby = \"discretization.h\"\n");
  const auto sweep = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "sweep");
    return run_porowave(words, folder.path());
  };
  check_failure(sweep({"wrong.toml", "--store", "s"}), 2, {"wrong.toml:", "[refine] by", "axis"});
  check_failure(sweep({"none.toml", "--store", "s"}), 2, {"none.toml"});
  check_failure(sweep({"study.toml"}), 2, {"--store"});
  for (const std::string shard : {"0/2", "3/2", "a/b", "1/2x", "1"}) {
    check_failure(sweep({"study.toml", "--store", "s", "--shard", shard}), 2, {"--shard", shard});
  }
  check_failure(sweep({"study.toml", "--store", "s", "--jobs", "0"}), 2, {"--jobs"});
  // A variable that is not set is no option that is absent.
  for (const std::string option : {"--case", "--cases", "--shard"}) {
    check_failure(sweep({"study.toml", "--store", "s", option, ""}), 2, {option, "not empty"});
  }
  check_failure(sweep({"study.toml", "--store", ""}), 2, {"--store", "not empty"});
  for (const std::string option : {"--cases", "--shard", "--jobs"}) {
    check_failure(sweep({"study.toml", "--store", "s", "--case", "ab", option, "1"}), 2,
                  {"--case", option});
  }
  check_failure(sweep({"study.toml", "--store", "s", "--case", "ab", "--dry-run"}), 2,
                {"--dry-run"});
  check_failure(sweep({"study.toml", "--store", "study.toml"}), 2, {"study.toml", "store"});
  check_failure(sweep({"study.toml", "--store", "no/such/folder/s"}), 5, {"no/such/folder/s"});
  check_failure(run_porowave({"merge", "s", "study.toml"}, folder.path()), 2, {"study.toml"});
  check_failure(run_porowave({"merge", "s", "none"}, folder.path()), 2, {"none"});
  BOOST_TEST(folder.contents() == "study.toml wrong.toml");
  BOOST_TEST(sweep({"study.toml", "--store", "s", "--dry-run"}).output == "trial: 8 cases\n");
  BOOST_TEST(folder.contents() == "study.toml wrong.toml");
  // A name by which SQLite means no file.
  BOOST_TEST(sweep({"study.toml", "--store", ":memory:"}).exit_code == 0);
  BOOST_TEST(std::filesystem::is_regular_file(folder / ":memory:"));
}

BOOST_AUTO_TEST_SUITE_END()
