// Other solvers behind an adapter: porowave itself, which must come out as it does inside, and the
// tutorial of verification/adapters, command by command.

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "reports/test_program.hpp"
#include "verification/sweep/sweep.hpp"

BOOST_AUTO_TEST_SUITE(program_adapter)

using namespace porowave::tests;
using namespace porowave::verification;
namespace fs = std::filesystem;

namespace {

const std::string axes =
    "[study]\nname = \"trial\"\n[axes]\n\"discretization.elements\" = [20, 40]\n"
    "\"discretization.seed\" = [1, 2]\n";

/// porowave solve as somebody else's solver.
const std::string adapter =
    "[adapter]\ncommand = [\"sh\", \"-c\", '\"$0\" solve \"$1\" --output \"$2\"', "
    "'" POROWAVE_PROGRAM "']\n";

std::vector<Record> rows_of(const std::string& text, const TestDirectory& folder,
                            const std::string& store_name) {
  write_text(folder / "study.toml", text);
  const Study study = load_study((folder / "study.toml").string());
  Store store = Store::create_or_open((folder / store_name).string());
  sweep(study, store, {.jobs = 2});
  std::vector<Record> rows;
  for (const StudyCase& one : study.cases) rows.push_back(store.find(one.id).value());
  return rows;
}

/// The commands of a text: its lines that are indented by four spaces.
std::vector<std::string> commands_of(const std::string& text) {
  std::vector<std::string> commands;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("    ")) commands.push_back(line.substr(4));
  }
  return commands;
}

}  // namespace

BOOST_AUTO_TEST_CASE(our_solver_behind_an_adapter_has_the_errors_it_has_inside) {
  const TestDirectory folder;
  const auto inside = rows_of(CaseText().text() + axes, folder, "inside");
  const auto outside = rows_of(CaseText().text() + axes + adapter, folder, "outside");
  BOOST_TEST_REQUIRE(inside.size() == 4U);
  BOOST_TEST_REQUIRE(outside.size() == 4U);
  for (std::size_t i = 0; i < inside.size(); ++i) {
    BOOST_TEST((outside[i].status == CaseStatus::done), outside[i].reason);
    BOOST_TEST(outside[i].points == inside[i].points);
    BOOST_TEST(outside[i].id != inside[i].id);
    for (const std::string& name : measure_names()) {
      const double ours = inside[i].measures[*measure_index(name)];
      const double theirs = outside[i].measures[*measure_index(name)];
      if (contains(name, "_points_")) {
        BOOST_TEST(ours > 0.0);
        BOOST_TEST(std::abs(theirs / ours - 1.0) < 1e-9, name);
      } else if (contains(name, "_field_")) {
        BOOST_TEST(std::isnan(theirs), name);
      }
    }
  }
  BOOST_TEST(outside[0].measures != outside[1].measures);
}

BOOST_AUTO_TEST_CASE(a_breakdown_of_the_other_solver_is_a_row_with_what_it_said) {
  const TestDirectory folder;
  const std::string exploding = CaseText()
                                    .set("transfer", "\"shape\"")
                                    .without("kernel")
                                    .without("support_radius")
                                    .without("basis_order")
                                    .set("courant", "1.0")
                                    .set("end", "1e-4")
                                    .text();
  const auto rows = rows_of(exploding + "[study]\nname = \"trial\"\n" + adapter, folder, "results");
  BOOST_TEST_REQUIRE(rows.size() == 1U);
  BOOST_TEST((rows[0].status == CaseStatus::broke_down));
  BOOST_TEST(rows[0].reason.starts_with("exit code 4: porowave: "), rows[0].reason);
  BOOST_TEST(contains(rows[0].reason, "the run broke down: step "), rows[0].reason);
}

BOOST_AUTO_TEST_CASE(every_command_of_the_tutorial_runs) {
  const TestDirectory folder;
  const std::string source = std::string(POROWAVE_SOURCE_DIR) + "/verification/adapters";
  for (const char* name : {"skeleton.sh", "difference_solver.awk", "case.toml", "study.toml"}) {
    fs::copy(source + "/" + name, folder / name);
  }
  fs::create_directory(folder / "bin");
  fs::create_symlink(POROWAVE_PROGRAM, folder / "bin/porowave");
  const char* const path = std::getenv("PATH");
  BOOST_TEST_REQUIRE(path != nullptr);
  const TestVariable variable("PATH", (folder / "bin").string() + ":" + path);
  const auto commands = commands_of(text_of(source + "/README.md"));
  BOOST_TEST_REQUIRE(commands.size() == 5U);
  std::string output;
  for (const std::string& command : commands) {
    const auto result = porowave::reports::run_process({"sh", "-c", command}, folder.path());
    BOOST_TEST(result.exit_code == 0, command << ": " << result.errors << result.output);
    BOOST_TEST(result.errors == "", command << ": " << result.errors);
    output += result.output;
  }
  BOOST_TEST(contains(output, "100 points at t = 4e-05 s, weighted by their volume"));
  BOOST_TEST(contains(output, "3 cases: 0 were in the store"));
  BOOST_TEST(contains(output, "3 done"));
  BOOST_TEST(contains(output, "pass: 4 pass, 0 fail, 0 xfail, 0 xpass, 0 inconclusive"), output);
  BOOST_TEST_MESSAGE(output);
}

BOOST_AUTO_TEST_CASE(the_skeleton_refuses_what_its_solver_cannot_do) {
  const TestDirectory folder;
  const std::string source = std::string(POROWAVE_SOURCE_DIR) + "/verification/adapters/";
  const std::string good = text_of(source + "case.toml");
  const auto run = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const auto at = text.find(from);
    BOOST_TEST_REQUIRE(at != std::string::npos);
    write_text(folder / "case.toml", text.replace(at, from.size(), to));
    return porowave::reports::run_process(
        {source + "skeleton.sh", source + "difference_solver.awk", "case.toml", "points.csv"},
        folder.path());
  };
  const auto refused = [&](const std::string& from, const std::string& to,
                           const std::string& words) {
    const auto result = run(from, to);
    BOOST_TEST(result.exit_code == 1);
    BOOST_TEST(result.errors == words + "\n");
    BOOST_TEST(folder.contents() == "case.toml");
  };
  refused("rigid_sealed", "half_space", "only far = rigid_sealed is possible here");
  refused("porosity", "porositty", "[material] porosity is missing");
  refused("duration = 2.0e-5", "", "[load] duration is missing");
  BOOST_TEST(run("elements = 100", "elements = 10  # few").exit_code == 0);
  BOOST_TEST(folder.contents() == "case.toml points.csv");
}

BOOST_AUTO_TEST_SUITE_END()
