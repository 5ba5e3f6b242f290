// Wrong input: exit code 2 and one line that says where and what was expected; nothing is written.

#include <unistd.h>

#include <boost/test/unit_test.hpp>

#include "reports/test_program.hpp"

BOOST_AUTO_TEST_SUITE(program_input)

using namespace porowave::tests;
namespace fs = std::filesystem;

namespace {

struct Commands {
  bool reference = false;  ///< whether `reference` refuses it too
};
constexpr Commands solve_only{false};
constexpr Commands both{true};

/// Runs the commands on case.toml in a directory of its own; it is refused at `place` (":12: ", or
/// what follows the file's name).
void check_refused(const std::string& text, const std::string& place,
                   const std::vector<std::string>& parts, Commands commands) {
  const TestDirectory folder;
  write_text(folder / "case.toml", text);
  auto expected = parts;
  expected.push_back("porowave: case.toml" + place);
  BOOST_TEST_CONTEXT(place << " " << parts.front()) {
    check_failure(run_porowave({"solve", "case.toml", "--output", "p.csv", "--json", "p.json"},
                               folder.path()),
                  2, expected);
    if (commands.reference) {
      check_failure(run_porowave({"reference", "case.toml", "--x", "0:0.1:3", "--t", "1e-5",
                                  "--output", "p.csv"},
                                 folder.path()),
                    2, expected);
    }
    BOOST_TEST(folder.contents() == "case.toml");
  }
}

/// The line with these words is refused; the message shows them, and what was expected.
void check_line(const CaseText& text, const std::string& table, const std::string& words,
                const std::string& expected, Commands commands = solve_only) {
  const std::string place = ":" + std::to_string(text.line_of(words)) + ": [" + table + "] ";
  check_refused(text.text(), place, {place + words, expected}, commands);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_file_that_is_missing) {
  const TestDirectory folder;
  for (const std::string command : {"solve", "reference"}) {
    std::vector<std::string> arguments = {command, "no/case.toml", "--output", "p.csv"};
    if (command == "reference") arguments.insert(arguments.end(), {"--x", "0", "--t", "0"});
    check_failure(run_porowave(arguments, folder.path()), 2,
                  {"no/case.toml: cannot be read: expected a TOML file"});
  }
  BOOST_TEST(folder.contents() == "");
}

BOOST_AUTO_TEST_CASE(a_file_that_is_not_toml) {
  check_refused("[material]\nporosity = = 0.4\n", ":2: not TOML: ", {"not TOML"}, both);
  check_refused(std::string("\0\xff\xfe\x01", 4), ":1: not TOML: ", {"not TOML"}, both);
  check_refused("x,t\n1,2\n", ":1: not TOML: ", {"not TOML"}, both);
  check_refused("", ": [material] porosity is missing: ", {"expected a number"}, both);
}

BOOST_AUTO_TEST_CASE(an_unknown_key_or_table) {
  check_line(CaseText().add("material", "porositty = 0.4"), "material", "porositty = 0.4",
             "unknown key; did you mean porosity?", both);
  check_line(CaseText().add("discretization", "elemnts = 10"), "discretization", "elemnts = 10",
             "unknown key; did you mean elements?");
  const std::string table = "[discretisation]\nelements = 10\n";
  const CaseText text;
  const int line = 1 + static_cast<int>(std::count(text.text().begin(), text.text().end(), '\n'));
  check_refused(text.text() + table, ":" + std::to_string(line) + ": ",
                {"[discretisation]: unknown table; did you mean discretization?"}, both);
}

BOOST_AUTO_TEST_CASE(a_wrong_type) {
  check_line(CaseText().set("porosity", "\"high\""), "material", "porosity = \"high\"",
             "expected a number > 0 and < 1", both);
  check_line(CaseText().set("elements", "20.5"), "discretization", "elements = 20.5",
             "expected a whole number from 2");
  check_line(CaseText().set("kernel", "2"), "discretization", "kernel = 2", "expected one of");
}

BOOST_AUTO_TEST_CASE(a_value_that_cannot_be) {
  check_line(CaseText().set("porosity", "1.2"), "material", "porosity = 1.2",
             "expected a number > 0 and < 1", both);
  check_line(CaseText().set("constrained_modulus", "-5000000000.0"), "material",
             "constrained_modulus = -5000000000", "expected a number > 0", both);
}

BOOST_AUTO_TEST_CASE(an_unknown_kernel) {
  check_line(CaseText().set("kernel", "\"bspline4\""), "discretization", "kernel = \"bspline4\"",
             "expected one of bspline1, bspline2, bspline3, wendland_c2, wendland_c4");
}

BOOST_AUTO_TEST_CASE(a_support_smaller_than_the_spacing_of_points) {
  check_line(CaseText().set("support_radius", "0.2"), "discretization", "support_radius = 0.2",
             "expected a number >= 0.25");
}

BOOST_AUTO_TEST_CASE(no_elements) {
  check_line(CaseText().set("elements", "0"), "discretization", "elements = 0",
             "expected a whole number from 2");
}

BOOST_AUTO_TEST_CASE(an_output_that_cannot_be_written) {
  const TestDirectory folder;
  write_text(folder / "file", "");
  const auto refused = [&](const std::string& place) {
    const std::vector<std::string> parts = {place + ": cannot be written: ", "expected"};
    for (const std::string option : {"--output", "--json"}) {
      check_failure(run_porowave({"solve", paper_case, option, place}, folder.path()), 5, parts);
    }
    const std::vector<std::string> reference = {"reference", paper_problem, "--x",      "0",
                                                "--t",       "0",           "--output", place};
    check_failure(run_porowave(reference, folder.path()), 5, parts);
    check_failure(run_porowave({"demo", "--output", place}, folder.path()), 5, parts);
  };
  refused("file/p.csv");
  refused(std::string(300, 'n'));
  BOOST_TEST(folder.contents() == "file");
  if (geteuid() == 0) return;  // whom no directory keeps out
  fs::create_directory(folder / "closed");
  fs::permissions(folder / "closed", fs::perms::owner_read | fs::perms::owner_exec);
  refused("closed/p.csv");
  BOOST_TEST(folder.contents() == "closed file");
}

BOOST_AUTO_TEST_CASE(an_output_that_cannot_be_written_is_found_before_the_work) {
  const TestDirectory folder;
  write_text(folder / "case.toml",
             CaseText().add("discretization", "empty_elements = [0.0001, 0.0006]").text());
  // Both would fail otherwise: no point is at the loaded end, and none of the column is at x = 9.
  BOOST_TEST(run_porowave({"solve", "case.toml"}, folder.path()).exit_code == 4);
  for (const std::string option : {"--output", "--json"}) {
    check_failure(run_porowave({"solve", "case.toml", option, "no/p"}, folder.path()), 5, {"no/p"});
  }
  check_failure(run_porowave({"reference", "case.toml", "--x", "9", "--t", "0", "--output", "no/p"},
                             folder.path()),
                5, {"no/p"});
}

BOOST_AUTO_TEST_CASE(points_that_cannot_be_eliminated) {
  CaseText text;
  text.without("flip").add("time", "path = \"frozen\"").add("time", "xpic_order = 2");
  check_line(text, "time", "path = \"frozen\"", "\"auto\" or \"points\"");
}

BOOST_AUTO_TEST_CASE(keys_that_do_not_belong_together) {
  const auto shape = [](const std::string& keep) {
    CaseText text;
    text.set("transfer", "\"shape\"");
    for (const std::string key : {"kernel", "support_radius", "basis_order"}) {
      if (key != keep) text.without(key);
    }
    return text;
  };
  const std::string with_shape = "with transfer = \"shape\"";
  check_line(shape("kernel").set("kernel", "\"wendland_c2\""), "discretization",
             "kernel = \"wendland_c2\"", with_shape);
  check_line(shape("support_radius"), "discretization", "support_radius = 1.5", with_shape);
  check_line(shape("basis_order"), "discretization", "basis_order = 1", with_shape);
  check_line(CaseText().add("discretization", "jitter = 0.3"), "discretization", "jitter = 0.3",
             "no jitter unless placement = \"jittered\"");
  check_line(CaseText().set("far", "\"half_space\""), "column", "length = 0.1",
             "no length with far = \"half_space\"", both);
  check_line(CaseText().set("shape", "\"step\"").set("duration", "1e-05"), "load",
             "duration = 1e-05", "no duration with shape = \"step\"", both);
  check_line(CaseText().add("load", "file = \"load.csv\""), "load", "file = \"load.csv\"",
             "no file unless shape = \"table\"", both);
}

BOOST_AUTO_TEST_CASE(points_and_times_that_are_no_numbers) {
  const TestDirectory folder;
  const auto refused = [&](const std::string& x, const std::string& t, const std::string& part) {
    check_failure(
        run_porowave({"reference", paper_problem, "--x=" + x, "--t=" + t, "--output", "p.csv"},
                     folder.path()),
        2, {part, "expected"});
  };
  refused("0:1", "4e-5", "--x 0:1: ");
  refused("0,a", "4e-5", "--x 0,a: ");
  refused("0", "now", "--t now: ");
  refused("0,0.2", "4e-5", "x = 0.2");
  refused("-0.01", "4e-5", "x = -0.01");
  BOOST_TEST(folder.contents() == "");
}

BOOST_AUTO_TEST_SUITE_END()
