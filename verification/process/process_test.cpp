#include "verification/process/process.hpp"

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "reference/problem/errors.hpp"
#include "verification/process/scratch_directory.hpp"

BOOST_AUTO_TEST_SUITE(process)

using namespace porowave;
using namespace porowave::verification;
namespace fs = std::filesystem;

namespace {

ProcessResult shell(const std::string& script) {
  return run_process({"sh", "-c", script}, ".");
}

/// That the process whose number stands in the file does not run any more (its parent, which is not
/// ours, may not have taken notice yet).
void check_gone(const std::string& file) {
  std::ifstream in(file);
  int id = 0;
  BOOST_TEST_REQUIRE(static_cast<bool>(in >> id));
  for (int attempt = 0; attempt < 500; ++attempt) {
    std::ifstream stat("/proc/" + std::to_string(id) + "/stat");
    std::string text;
    if (!std::getline(stat, text) || text.find(") Z ") != std::string::npos) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  BOOST_ERROR("process " << id << " still runs");
}

}  // namespace

BOOST_AUTO_TEST_CASE(arguments_reach_the_program_unchanged) {
  const ScratchDirectory folder;
  const std::vector<std::string> arguments = {"two words",
                                              "'single'",
                                              "\"double\"",
                                              "$(touch made)",
                                              "`touch made`",
                                              "; touch made",
                                              "| touch made",
                                              "> made",
                                              "line\nbreak",
                                              "",
                                              "*",
                                              "~",
                                              "$HOME",
                                              "\\",
                                              "-n",
                                              "%s",
                                              "σ′"};
  std::vector<std::string> command = {"printf", "<%s>"};
  std::string expected;
  for (const auto& argument : arguments) {
    command.push_back(argument);
    expected += "<" + argument + ">";
  }
  const ProcessResult result = run_process(command, folder.path());
  BOOST_TEST(result.output == expected);
  BOOST_TEST(result.errors == "");
  BOOST_TEST(result.exit_code == 0);
  BOOST_TEST(fs::is_empty(folder.path()));
}

BOOST_AUTO_TEST_CASE(output_and_errors_are_kept_apart) {
  const ProcessResult result = shell("echo out; echo err >&2; echo more");
  BOOST_TEST(result.output == "out\nmore\n");
  BOOST_TEST(result.errors == "err\n");
}

BOOST_AUTO_TEST_CASE(much_text_on_both_streams_does_not_block) {
  // More than any pipe holds, first on one stream only, then on both in turn.
  const ProcessResult result = shell(
      "head -c 2000000 /dev/zero >&2; head -c 2000000 /dev/zero;"
      "for i in 1 2 3; do head -c 500000 /dev/zero; head -c 500000 /dev/zero >&2; done");
  BOOST_TEST(result.output.size() == 3500000u);
  BOOST_TEST(result.errors.size() == 3500000u);
  BOOST_TEST(result.output.find_first_not_of('\0') == std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_end_of_the_program_is_known) {
  for (const int code : {0, 1, 5, 127, 255}) {
    BOOST_TEST(shell("exit " + std::to_string(code)).exit_code == code);
  }
  BOOST_TEST(shell("kill -9 $$").exit_code == 128 + 9);
  BOOST_TEST(shell("kill -15 $$").exit_code == 128 + 15);
}

BOOST_AUTO_TEST_CASE(what_was_written_before_a_signal_is_kept) {
  const ProcessResult result = shell("echo before; kill -9 $$");
  BOOST_TEST(result.output == "before\n");
  BOOST_TEST(result.exit_code == 137);
}

BOOST_AUTO_TEST_CASE(a_program_that_is_missing_is_named) {
  BOOST_CHECK_EXCEPTION(
      run_process({"no-such-program"}, "."), EnvironmentError, [](const EnvironmentError& error) {
        const std::string message = error.what();
        return message.find("no-such-program: cannot be started") != std::string::npos &&
               message.find("expected it installed and in PATH") != std::string::npos;
      });
  BOOST_CHECK_THROW(run_process({"true"}, "no-such-directory"), EnvironmentError);
}

BOOST_AUTO_TEST_CASE(the_program_runs_in_its_directory_without_input) {
  const ScratchDirectory folder;
  const auto before = std::filesystem::current_path();
  const ProcessResult result = run_process({"sh", "-c", "touch here; cat"}, folder.path());
  BOOST_TEST(fs::exists(folder.file("here")));
  BOOST_TEST(result.output == "");
  BOOST_TEST(std::filesystem::current_path() == before);
}

BOOST_AUTO_TEST_CASE(its_cost_is_known) {
  const ProcessResult result =
      shell("i=0; while [ $i -lt 100000 ]; do i=$((i+1)); done; sleep 0.2");
  BOOST_TEST(result.cpu_seconds > 0.01);
  BOOST_TEST(result.wall_seconds > 0.2);
  BOOST_TEST(result.wall_seconds > result.cpu_seconds);
  BOOST_TEST(result.peak_rss_bytes > 100'000);
  BOOST_TEST(!result.timed_out);
}

BOOST_AUTO_TEST_CASE(at_its_time_limit_a_program_and_what_it_started_are_ended) {
  const ScratchDirectory folder;
  // Streams open, streams closed, and signals ignored.
  for (const std::string script :
       {"sleep 600 & echo $! > child; echo begun; sleep 600",
        "sleep 600 >&- 2>&- & echo $! > child; echo begun; exec >&- 2>&-; sleep 600",
        "trap '' TERM INT HUP; sleep 600 & echo $! > child; echo begun; while :; do sleep 1; "
        "done"}) {
    const ProcessResult result = run_process({"sh", "-c", script}, folder.path(), {.seconds = 0.5});
    BOOST_TEST(result.timed_out);
    BOOST_TEST(result.exit_code == 128 + 9);
    BOOST_TEST(result.output == "begun\n");
    BOOST_TEST(result.wall_seconds >= 0.5);
    BOOST_TEST(result.wall_seconds < 30.0);
    check_gone(folder.file("child"));
  }
}

BOOST_AUTO_TEST_CASE(what_a_program_leaves_behind_does_not_outlive_it) {
  const ScratchDirectory folder;
  const ProcessResult result = run_process({"sh", "-c", "sleep 600 & echo $! > child; exit 3"},
                                           folder.path(), {.seconds = 300.0});
  BOOST_TEST(!result.timed_out);
  BOOST_TEST(result.exit_code == 3);
  BOOST_TEST(result.wall_seconds < 100.0);
  check_gone(folder.file("child"));
}

BOOST_AUTO_TEST_CASE(a_limit_that_is_not_reached_changes_nothing) {
  const ProcessResult result =
      run_process({"sh", "-c", "echo out; echo err >&2; exit 4"}, ".", {.seconds = 300.0});
  BOOST_TEST(!result.timed_out);
  BOOST_TEST(result.exit_code == 4);
  BOOST_TEST(result.output == "out\n");
  BOOST_TEST(result.errors == "err\n");
}

BOOST_AUTO_TEST_CASE(of_endless_text_the_end_is_kept) {
  const ProcessResult result =
      run_process({"sh", "-c", "head -c 5000000 /dev/zero; echo the end; yes >&2"}, ".",
                  {.seconds = 1.0, .kept = 1000});
  BOOST_TEST(result.timed_out);
  BOOST_TEST(result.output.size() == 1000U);
  BOOST_TEST(result.output.ends_with("the end\n"));
  BOOST_TEST(result.errors.size() == 1000U);
}

BOOST_AUTO_TEST_SUITE_END()
