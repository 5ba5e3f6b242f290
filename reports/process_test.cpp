#include "reports/process.hpp"

#include <boost/test/unit_test.hpp>

#include "reference/problem/errors.hpp"
#include "reports/test_directory.hpp"

using namespace porowave;
using namespace porowave::reports;
using namespace porowave::tests;

namespace {

ProcessResult shell(const std::string& script) {
  return run_process({"sh", "-c", script}, ".");
}

}  // namespace

BOOST_AUTO_TEST_SUITE(process)

BOOST_AUTO_TEST_CASE(arguments_reach_the_program_unchanged) {
  const TestDirectory folder;
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
  BOOST_TEST(folder.contents() == "");
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
  const auto message = message_of<EnvironmentError>([] { run_process({"no-such-program"}, "."); });
  BOOST_TEST(contains(message, "no-such-program: cannot be started"));
  BOOST_TEST(contains(message, "expected it installed and in PATH"));
  BOOST_CHECK_THROW(run_process({"true"}, "no-such-directory"), EnvironmentError);
}

BOOST_AUTO_TEST_CASE(the_program_runs_in_its_directory_without_input) {
  const TestDirectory folder;
  const auto before = std::filesystem::current_path();
  const ProcessResult result = run_process({"sh", "-c", "touch here; cat"}, folder.path());
  BOOST_TEST(folder.contents() == "here");
  BOOST_TEST(result.output == "");
  BOOST_TEST(std::filesystem::current_path() == before);
}

BOOST_AUTO_TEST_SUITE_END()
