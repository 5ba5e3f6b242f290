#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "reports/test_csv.hpp"
#include "reports/test_program.hpp"

BOOST_AUTO_TEST_SUITE(program_solve)

using namespace porowave::tests;
using Json = nlohmann::json;

namespace {

/// Runs the text as case.toml in the directory, with points.csv and errors.json as output.
porowave::reports::ProcessResult solve(const CaseText& text, const TestDirectory& folder) {
  write_text(folder / "case.toml", text.text());
  return run_porowave({"solve", "case.toml", "--output", "points.csv", "--json", "errors.json"},
                      folder.path());
}

CaseText small_case() {
  return CaseText().set("elements", "50");
}

/// Linear shape functions, random points, the full time step: unstable.
CaseText exploding_case() {
  return small_case()
      .set("transfer", "\"shape\"")
      .without("kernel")
      .without("support_radius")
      .without("basis_order")
      .set("courant", "1.0")
      .set("end", "1e-4");
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_table_has_every_point_of_both_phases) {
  const TestDirectory folder;
  const auto result = solve(small_case(), folder);
  BOOST_TEST(result.exit_code == 0);
  BOOST_TEST(result.errors == "");
  BOOST_TEST(contains(result.output, "wrote points.csv\nwrote errors.json\n"));
  BOOST_TEST(folder.contents() == "case.toml errors.json points.csv");
  const CsvText csv = read_csv(text_of(folder / "points.csv"));
  BOOST_TEST(csv.header == "phase,x,volume,velocity,effective_stress,pore_pressure");
  BOOST_TEST(csv.rows.size() == 400u);
  std::map<std::string, int> count;
  std::map<std::string, double> volume;
  for (const auto& row : csv.rows) {
    BOOST_REQUIRE(row.size() == 6u);
    const std::string& phase = row[0];
    BOOST_TEST((phase == "solid" || phase == "fluid"));
    ++count[phase];
    volume[phase] += std::stod(row[2]);
    BOOST_TEST(std::stod(row[1]) >= 0.0);
    BOOST_TEST(std::stod(row[1]) <= 0.1);
    BOOST_TEST(std::isfinite(std::stod(row[3])));
    BOOST_TEST(row[phase == "solid" ? 5 : 4] == "");
    BOOST_TEST(std::abs(std::stod(row[phase == "solid" ? 4 : 5])) < 3.0);
  }
  BOOST_TEST(count["solid"] == 200);
  BOOST_TEST(count["fluid"] == 200);
  BOOST_TEST(volume["solid"] == 0.1, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(volume["fluid"] == 0.1, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(the_json_has_errors_and_cost) {
  const TestDirectory folder;
  BOOST_TEST(solve(small_case(), folder).exit_code == 0);
  const Json json = Json::parse(text_of(folder / "errors.json"));
  for (const std::string field :
       {"effective_stress", "pore_pressure", "solid_velocity", "fluid_velocity"}) {
    for (const std::string place : {"points", "field"}) {
      for (const std::string norm : {"l1", "l2", "linf"}) {
        const double error = json.at("errors").at(field).at(place).at(norm).get<double>();
        BOOST_TEST(error > 0.0);
        BOOST_TEST(error < 1.0);
      }
    }
  }
  BOOST_TEST(json.at("errors").size() == 4u);
  BOOST_TEST(json.at("path").get<std::string>() == "frozen");
  BOOST_TEST(json.at("diverged").get<bool>() == false);
  BOOST_TEST(json.at("points").get<int>() == 400);
  const double steps = json.at("steps").get<double>();
  BOOST_TEST(steps == 92.0);  // c_1 = 2297.7 m/s, courant = 0.5, h = 2 mm
  const double cpu = json.at("cpu_seconds").get<double>();
  BOOST_TEST(cpu > 0.0);
  BOOST_TEST(json.at("wall_seconds").get<double>() > 0.0);
  BOOST_TEST(json.at("ns_per_point_step").get<double>() == 1e9 * cpu / (400.0 * steps),
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST(json.at("peak_rss_bytes").get<long>() > 1000000);
}

BOOST_AUTO_TEST_CASE(the_same_case_gives_the_same_points) {
  const TestDirectory first;
  const TestDirectory second;
  const TestDirectory other_seed;
  solve(small_case(), first);
  solve(small_case(), second);
  solve(small_case().set("seed", "2"), other_seed);
  BOOST_TEST(text_of(first / "points.csv") == text_of(second / "points.csv"));
  BOOST_TEST(text_of(first / "points.csv") != text_of(other_seed / "points.csv"));
}

BOOST_AUTO_TEST_CASE(refinement_brings_the_result_to_the_reference) {
  const auto error = [](const std::string& elements) {
    const TestDirectory folder;
    solve(small_case().set("elements", elements), folder);
    const Json json = Json::parse(text_of(folder / "errors.json"));
    return json.at("errors").at("effective_stress").at("field").at("l2").get<double>();
  };
  BOOST_TEST(error("100") > 2.0 * error("200"));
}

BOOST_AUTO_TEST_CASE(a_run_that_explodes_is_no_result) {
  const TestDirectory folder;
  const auto result = solve(exploding_case(), folder);
  BOOST_TEST(result.exit_code == 4);
  BOOST_TEST(is_one_line(result.errors));
  BOOST_TEST(result.errors.rfind("porowave: case.toml: the run broke down: step ", 0) == 0u,
             result.errors);
  BOOST_TEST(contains(result.errors, "effective_stress = "));
  for (const char* words : {" at x = ", " m, solid point ",
                            "more than 1e6 times the load; likely cause: "
                            "the time step is too long: fields grow by a factor of ",
                            "try a smaller courant: 0."}) {
    BOOST_TEST(contains(result.errors, words), result.errors);
  }
  BOOST_TEST(!contains(result.output, "relative L2 error"));
  const Json json = Json::parse(text_of(folder / "errors.json"));
  BOOST_TEST(json.at("diverged").get<bool>());
  BOOST_TEST(json.at("errors").is_null());
  BOOST_TEST(contains(result.errors, json.at("reason").get<std::string>()));
  BOOST_TEST(contains(json.at("reason").get<std::string>(),
                      "step " + std::to_string(json.at("steps").get<long>()) + ","));
}

BOOST_AUTO_TEST_CASE(a_run_that_explodes_leaves_its_points_and_marks_them) {
  const TestDirectory folder;
  const auto result = solve(exploding_case(), folder);
  BOOST_TEST(result.exit_code == 4);
  BOOST_TEST(contains(result.output, "wrote points.csv, of a run that broke down\n"),
             result.output);
  BOOST_TEST(folder.contents() == "case.toml errors.json points.csv");
  const CsvText csv = read_csv(text_of(folder / "points.csv"));
  BOOST_TEST(csv.rows.size() == 400u);
  double largest = 0.0;
  for (const auto& row : csv.rows) {
    if (row[0] == "solid") largest = std::max(largest, std::abs(std::stod(row[4])));
  }
  // The value that ended the run is among them.
  const Json json = Json::parse(text_of(folder / "errors.json"));
  const auto reason = json.at("reason").get<std::string>();
  const double named = std::stod(reason.substr(reason.find(" = ", reason.find(" s: ")) + 3));
  BOOST_TEST(largest == std::abs(named), boost::test_tools::tolerance(1e-5));
}

// With the step that the message of a breakdown names, the run ends well.
BOOST_AUTO_TEST_CASE(what_the_message_advises_works) {
  const TestDirectory folder;
  const std::string words = "try a smaller courant: ";
  const std::string errors = solve(exploding_case(), folder).errors;
  const auto at = errors.find(words);
  BOOST_TEST_REQUIRE(at != std::string::npos);
  const double advised = std::stod(errors.substr(at + words.size()));
  BOOST_TEST(advised < 1.0);
  const TestDirectory again;
  BOOST_TEST(solve(exploding_case().set("courant", std::to_string(advised)), again).exit_code == 0);
}

BOOST_AUTO_TEST_CASE(a_loaded_end_without_points_breaks_down_at_once) {
  const TestDirectory folder;
  check_failure(solve(exploding_case().add("discretization", "empty_elements = [0.001]"), folder),
                4, {"step 0", "x = 0", "nodal mass"});
  BOOST_TEST(folder.contents() == "case.toml");
}

BOOST_AUTO_TEST_SUITE_END()
