#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "reports/test_csv.hpp"
#include "reports/test_program.hpp"

BOOST_AUTO_TEST_SUITE(program_grade)

using namespace porowave::tests;
using Json = nlohmann::json;

namespace {

const std::string peer_problem = study_path("peer_problem.toml");
const std::string peer_profile = study_path("peer_profile.csv");
const std::vector<std::string> fields = {"effective_stress", "pore_pressure", "solid_velocity",
                                         "fluid_velocity"};

porowave::reports::ProcessResult grade(const TestDirectory& folder, const std::string& profile,
                                       std::vector<std::string> more = {}) {
  std::vector<std::string> arguments = {"grade",      profile,  "--problem",
                                        peer_problem, "--json", "grade.json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_porowave(arguments, folder.path());
}

/// The first number of the line that begins with the field.
double printed_l1(const std::string& output, const std::string& field) {
  const auto at = output.find("\n" + field);
  BOOST_REQUIRE_MESSAGE(at != std::string::npos, output + " lacks " + field);
  return std::stod(output.substr(at + 1 + field.size()));
}

Json errors_in(const TestDirectory& folder) {
  return Json::parse(text_of(folder / "grade.json")).at("errors");
}

/// Grading the text is refused with these parts in the message, and nothing is written.
void check_refused(const std::string& text, const std::vector<std::string>& parts,
                   const std::vector<std::string>& more = {}) {
  const TestDirectory folder;
  write_text(folder / "p.csv", text);
  BOOST_TEST_CONTEXT(parts.front()) check_failure(grade(folder, "p.csv", more), 2, parts);
  BOOST_TEST(folder.contents() == "p.csv");
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_errors_of_the_peer) {
  const std::vector<double> expected = {0.0372, 0.1099, 0.0344, 0.0839};
  const TestDirectory folder;
  const auto result = grade(folder, peer_profile);
  BOOST_TEST(result.exit_code == 0);
  BOOST_TEST(result.errors == "");
  BOOST_TEST(contains(result.output, "1000 points at t = 1e-05 s, equal weights\n"));
  BOOST_TEST(contains(result.output, "wrote grade.json\n"));
  for (std::size_t f = 0; f < 4; ++f) {
    const double json = errors_in(folder).at(fields[f]).at("points").at("l1").get<double>();
    BOOST_TEST_MESSAGE("the peer's " << fields[f] << ": " << json);
    BOOST_TEST(std::abs(json - expected[f]) < 1e-4);
    BOOST_TEST(std::abs(printed_l1(result.output, fields[f]) - expected[f]) < 1e-4);
  }
}

BOOST_AUTO_TEST_CASE(points_of_solve_have_the_errors_that_solve_gives) {
  const TestDirectory folder;
  BOOST_TEST(run_porowave({"solve", paper_case, "--output", "points.csv", "--json", "solve.json"},
                          folder.path())
                 .exit_code == 0);
  const auto result = run_porowave(
      {"grade", "points.csv", "--problem", paper_case, "--time", "4e-5", "--json", "grade.json"},
      folder.path());
  BOOST_TEST(result.exit_code == 0);
  BOOST_TEST(result.errors == "");
  BOOST_TEST(contains(result.output, "weighted by their volume"));
  const Json solved = Json::parse(text_of(folder / "solve.json")).at("errors");
  for (const auto& field : fields) {
    for (const std::string norm : {"l1", "l2", "linf"}) {
      const double one = solved.at(field).at("points").at(norm).get<double>();
      const double other = errors_in(folder).at(field).at("points").at(norm).get<double>();
      BOOST_TEST(one > 0.0);
      BOOST_TEST(std::abs(other / one - 1.0) < 1e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_exact_fields_have_no_error_at_any_time) {
  const TestDirectory folder;
  BOOST_TEST(run_porowave({"reference", peer_problem, "--x", "0.0001:0.05:200", "--t",
                           "1e-5,2e-5,5e-5", "--output", "exact.csv"},
                          folder.path())
                 .exit_code == 0);
  const auto result = grade(folder, "exact.csv");
  BOOST_TEST(result.exit_code == 0);
  BOOST_TEST(contains(result.output, "columns not used: effective_stress_error, "));
  const Json json = Json::parse(text_of(folder / "grade.json"));
  BOOST_TEST(json.at("profiles").size() == 3u);
  for (const Json& profile : json.at("profiles")) {
    for (const auto& field : fields) {
      BOOST_TEST(profile.at("errors").at(field).at("points").at("linf").get<double>() < 1e-9);
    }
  }
}

BOOST_AUTO_TEST_CASE(other_names_of_columns_and_a_time_on_the_command_line) {
  const TestDirectory folder;
  const CsvText peer = read_csv(text_of(peer_profile));
  std::ostringstream text;  // without t, as a spreadsheet might write it
  text << "\xef\xbb\xbf\"Depth (m)\",\"s'\",p,comment\r\n";
  for (const auto& row : peer.rows) {
    text << row[0] << ",\"" << row[2] << "\"," << row[3] << ",\"a, b\"\r\n";
  }
  write_text(folder / "p.csv", text.str());
  const auto result = grade(folder, "p.csv",
                            {"--column", "x=Depth (m)", "--column", "effective_stress=s'",
                             "--column=pore_pressure=p", "--time", "1e-5"});
  BOOST_TEST(result.errors == "");
  BOOST_TEST(contains(result.output, "columns not used: comment\n"));
  BOOST_TEST(errors_in(folder).size() == 2u);
  BOOST_TEST(std::abs(printed_l1(result.output, "effective_stress") - 0.0372) < 1e-4);
  BOOST_TEST(std::abs(printed_l1(result.output, "pore_pressure") - 0.1099) < 1e-4);
}

BOOST_AUTO_TEST_CASE(wrong_tables) {
  check_refused("", {"porowave: p.csv: no header: expected a first row"});
  check_refused("x,t,pore_pressure\n", {"porowave: p.csv:2: no rows: expected"});
  check_refused("x,t,pore_pressure\n0.01,1e-5,nan\n", {"p.csv:2: pore_pressure nan: expected"});
  check_refused("x,t,pore_pressure\n0.06,1e-5,1\n",
                {"p.csv:2: x 0.06: expected a number >= 0 and <= 0.05"});
  check_refused("x,t,pore_pressure\n0.01,1e-5\n", {"p.csv:2: 2 values: expected 3"});
  check_refused("x,t,x,pore_pressure\n0,1,0,1\n", {"p.csv:1: x appears twice: expected one"});
  check_refused("x,pore_pressure\n0,1\n", {"p.csv:1: t is missing: expected", "--time"});
  check_refused("x,t,pressure\n0,1,1\n", {"p.csv:1: no field: expected", "pore_pressure"});
  check_refused(std::string("\0\1\2\n\3\n", 6), {"p.csv:1: "});
}

BOOST_AUTO_TEST_CASE(wrong_usage) {
  const std::string text = "x,pore_pressure\n0.01,1\n";
  const auto refused = [&](const std::vector<std::string>& more, const std::string& part) {
    check_refused(text, {part, "expected"}, more);
  };
  refused({"--time", "-1"}, "--time -1: ");
  refused({"--time", "nan"}, "--time nan: ");
  refused({"--time", "1", "--column", "x"}, "--column x: expected QUANTITY=NAME");
  refused({"--time", "1", "--column", "x="}, "--column x=: expected QUANTITY=NAME");
  refused({"--time", "1", "--column", "x=x", "--column", "x=y"}, "--column x=y: expected x only");
  refused({"--time", "1", "--column", "x=y"}, "p.csv:1: y is missing: ");
  check_refused(text, {"unknown quantity presure; "}, {"--time", "1", "--column", "presure=p"});
  const TestDirectory folder;
  check_failure(run_porowave({"grade", "no.csv", "--problem", peer_problem}, folder.path()), 2,
                {"no.csv: cannot be read: expected a CSV file"});
  check_failure(run_porowave({"grade", peer_profile, "--problem", "no.toml"}, folder.path()), 2,
                {"no.toml: cannot be read"});
  check_failure(run_porowave({"grade", peer_profile}, folder.path()), 2, {"--problem is required"});
  check_failure(grade(folder, peer_profile, {"--json", "no/grade.json"}), 2, {"--json"});
  check_failure(run_porowave({"grade", peer_profile, "--problem", peer_problem, "--json", "no/g"},
                             folder.path()),
                5, {"no/g: cannot be written"});
  BOOST_TEST(folder.contents() == "");
}

BOOST_AUTO_TEST_CASE(a_large_table_takes_little_time) {
  const TestDirectory folder;
  std::ostringstream text;
  text << "x,t,effective_stress,pore_pressure\n";
  for (int i = 0; i < 1'000'000; ++i) text << 5e-8 * i << ",1e-5,-900,100\n";
  write_text(folder / "p.csv", text.str());
  const auto result = grade(folder, "p.csv");
  BOOST_TEST(result.exit_code == 0);
  BOOST_TEST(contains(result.output, "1000000 points"));
}

BOOST_AUTO_TEST_SUITE_END()
