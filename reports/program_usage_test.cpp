#include <boost/test/unit_test.hpp>

#include "reports/test_program.hpp"

BOOST_AUTO_TEST_SUITE(program_usage)

using namespace porowave::tests;

namespace {

const std::vector<std::string> commands = {"reference", "waves",     "solve", "grade",
                                           "report",    "stability", "demo"};

}  // namespace

BOOST_AUTO_TEST_CASE(help_and_version_of_every_command) {
  std::vector<std::vector<std::string>> prefixes = {{}};
  for (const auto& command : commands) prefixes.push_back({command});
  for (auto arguments : prefixes) {
    arguments.push_back("--version");
    const auto version = run_porowave(arguments);
    BOOST_TEST(version.exit_code == 0);
    BOOST_TEST(version.output.rfind("porowave ", 0) == 0u);
    BOOST_TEST(is_one_line(version.output));
    BOOST_TEST(version.errors == "");
    arguments.back() = "--help";
    const auto help = run_porowave(arguments);
    BOOST_TEST(help.exit_code == 0);
    BOOST_TEST(contains(help.output, "Usage: porowave"));
    BOOST_TEST(help.errors == "");
  }
  const std::string help = run_porowave({"--help"}).output;
  for (const auto& command : commands) BOOST_TEST(contains(help, "\n  " + command + " "));
}

BOOST_AUTO_TEST_CASE(wrong_usage_is_explained_in_one_line) {
  const TestDirectory folder;
  const auto refused = [&](const std::vector<std::string>& arguments,
                           const std::vector<std::string>& parts) {
    BOOST_TEST_CONTEXT("porowave " << (arguments.empty() ? "" : arguments.front())) {
      check_failure(run_porowave(arguments, folder.path()), 2, parts);
    }
  };
  refused({}, {"expected one of the commands", "reference", "waves", "solve", "grade", "demo"});
  refused({"resolve"}, {"resolve: expected one of the commands"});
  refused({"--fast"}, {"--fast"});
  refused({"solve"}, {"case", "porowave solve --help"});
  refused({"solve", paper_case, "more"}, {"more"});
  refused({"solve", paper_case, "--fast"}, {"--fast"});
  refused({"solve", paper_case, "--output"}, {"--output"});
  refused({"reference", paper_problem}, {"is required"});
  refused({"reference", paper_problem, "--x", "0"}, {"--t is required"});
  refused({"reference", paper_problem, "--t", "0"}, {"--x is required"});
  refused({"reference", "--x", "0", "--t", "0"}, {"problem is required"});
  refused({"waves"}, {"problem is required", "porowave waves --help"});
  refused({"report", "--output", "there"}, {"store is required", "porowave report --help"});
  refused({"report", "results"}, {"--output is required"});
  refused({"demo", "there"}, {"there"});
  for (const std::string limit : {"abc", "1:", "1:2:3:4", "2h", ""}) {
    refused({"sweep", "s.toml", "--store", "s", "--slurm", "--time", limit},
            {"--time: " + limit + ": expected minutes"});
  }
  BOOST_TEST(folder.contents() == "");
}

BOOST_AUTO_TEST_CASE(the_examples_run) {
  const TestDirectory folder;
  for (const std::string command : {"reference", "waves", "solve", "grade"}) {
    const auto result = run_example(command, (folder / command).string());
    BOOST_TEST(result.exit_code == 0);
    BOOST_TEST(result.errors == "");
    BOOST_TEST(result.output != "");
  }
  BOOST_TEST(folder.contents() == "solve");
}

BOOST_AUTO_TEST_CASE(a_full_standard_output_is_no_success) {
  if (!std::filesystem::exists("/dev/full")) {
    BOOST_TEST_MESSAGE("no /dev/full: nothing to test");
    return;
  }
  const auto full = [](const std::string& arguments) {
    const std::string script = "exec \"" POROWAVE_PROGRAM "\" " + arguments + " > /dev/full";
    check_failure(porowave::reports::run_process({"sh", "-c", script}, "."), 5,
                  {"standard output: cannot be written"});
  };
  full("reference \"" + paper_problem + "\" --x 0.01 --t 4e-5");
  full("reference \"" + paper_problem + "\" --x 0:0.1:501 --t 1e-6");
  full("--help");
}

BOOST_AUTO_TEST_SUITE_END()
