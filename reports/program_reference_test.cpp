#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/column_solution.hpp"
#include "reports/test_csv.hpp"
#include "reports/test_program.hpp"

BOOST_AUTO_TEST_SUITE(program_reference)

using namespace porowave::tests;

namespace {

std::vector<std::string> reference_arguments(const std::string& x, const std::string& t) {
  return {"reference", paper_problem, "--x", x, "--t", t};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_table_has_the_columns_and_rows_that_were_asked_for) {
  const auto result = run_porowave(reference_arguments("0:0.1:11", "1e-5,4e-5"));
  BOOST_TEST(result.exit_code == 0);
  BOOST_TEST(result.errors == "");
  const CsvText csv = read_csv(result.output);
  BOOST_TEST(csv.header ==
             "x,t,effective_stress,pore_pressure,solid_velocity,fluid_velocity,"
             "effective_stress_error,pore_pressure_error,solid_velocity_error,"
             "fluid_velocity_error");
  BOOST_REQUIRE(csv.rows.size() == 22u);
  for (std::size_t i = 0; i < csv.rows.size(); ++i) {
    BOOST_REQUIRE(csv.rows[i].size() == 10u);
    const double x = i % 11 == 10 ? 0.1 : 0.1 * static_cast<double>(i % 11) / 10.0;
    BOOST_TEST(std::stod(csv.rows[i][0]) == x);
    BOOST_TEST(std::stod(csv.rows[i][1]) == (i < 11 ? 1e-5 : 4e-5));
  }
}

BOOST_AUTO_TEST_CASE(the_loaded_end_has_the_load) {
  const CsvText csv = read_csv(run_porowave(reference_arguments("0:0.1:101", "4e-5")).output);
  BOOST_REQUIRE(csv.rows.size() == 101u);
  const auto& first = csv.rows.front();
  BOOST_TEST(std::abs(std::stod(first[2]) + 1.0) <= std::stod(first[6]));
  BOOST_TEST(std::abs(std::stod(first[3])) <= std::stod(first[7]));
  BOOST_TEST(std::stod(first[6]) < 1e-10);
  BOOST_TEST(std::stod(first[7]) < 1e-10);
}

BOOST_AUTO_TEST_CASE(values_keep_all_their_digits) {
  const porowave::reference::ColumnSolution solution(porowave::load_problem(paper_problem));
  const CsvText csv =
      read_csv(run_porowave(reference_arguments("0.003,0.0312345678901234567", "3.3e-5")).output);
  BOOST_REQUIRE(csv.rows.size() == 2u);
  BOOST_TEST(std::stod(csv.rows[1][0]) == 0.0312345678901234567);
  for (const auto& row : csv.rows) {
    const auto fields = solution.at(std::stod(row[0]), std::stod(row[1])).value;
    BOOST_TEST(fields.effective_stress != 0.0);
    BOOST_TEST(std::stod(row[2]) == fields.effective_stress);
    BOOST_TEST(std::stod(row[3]) == fields.pore_pressure);
    BOOST_TEST(std::stod(row[4]) == fields.solid_velocity);
    BOOST_TEST(std::stod(row[5]) == fields.fluid_velocity);
  }
}

BOOST_AUTO_TEST_CASE(a_file_gets_what_standard_output_would) {
  const TestDirectory folder;
  auto arguments = reference_arguments("0:0.1:7", "4e-5");
  const auto printed = run_porowave(arguments, folder.path());
  arguments.insert(arguments.end(), {"--output", "fields.csv"});
  const auto written = run_porowave(arguments, folder.path());
  BOOST_TEST(written.exit_code == 0);
  BOOST_TEST(written.output == "wrote fields.csv\n");
  BOOST_TEST(text_of(folder / "fields.csv") == printed.output);
  BOOST_TEST(folder.contents() == "fields.csv");
}

BOOST_AUTO_TEST_CASE(a_case_file_will_do) {
  const auto result = run_porowave({"reference", paper_case, "--x", "0", "--t", "4e-5"});
  BOOST_TEST(result.exit_code == 0);
  BOOST_TEST(read_csv(result.output).rows.size() == 1u);
}

BOOST_AUTO_TEST_CASE(every_method_gives_the_same_table) {
  const auto table = [](const std::vector<std::string>& method) {
    // The case has a load that all routes can do.
    std::vector<std::string> arguments = {"reference", paper_case, "--x",
                                          "0:0.1:5",   "--t",      "1e-5,5e-5"};
    arguments.insert(arguments.end(), method.begin(), method.end());
    const auto result = run_porowave(arguments);
    BOOST_TEST(result.exit_code == 0);
    BOOST_TEST(result.errors == "");
    return read_csv(result.output);
  };
  const CsvText contour = table({});
  BOOST_TEST(table({"--method", "contour"}).rows == contour.rows);
  for (const std::string method : {"bromwich", "modal"}) {
    const CsvText csv = table({"--method", method});
    BOOST_TEST(csv.header == contour.header);
    BOOST_REQUIRE(csv.rows.size() == 10u);
    BOOST_TEST(csv.rows != contour.rows);  // another route rounds differently
    for (std::size_t i = 0; i < csv.rows.size(); ++i) {
      for (std::size_t f = 2; f < 6; ++f) {
        const double difference = std::stod(csv.rows[i][f]) - std::stod(contour.rows[i][f]);
        BOOST_TEST(std::abs(difference) <=
                   1e-14 + std::stod(csv.rows[i][f + 4]) + std::stod(contour.rows[i][f + 4]));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_method_that_cannot_do_the_problem_is_refused) {
  auto arguments = reference_arguments("0:0.1:5", "1e-5");
  arguments.insert(arguments.end(), {"--method", "modal"});
  check_failure(run_porowave(arguments), 2,
                {paper_problem, "modal: load shape = \"step\": expected smooth_ramp"});
  arguments.back() = "guess";
  check_failure(run_porowave(arguments), 2, {"--method", "guess", "contour", "modal"});
}

BOOST_AUTO_TEST_CASE(the_cross_check_says_how_far_the_routes_differ) {
  const auto smooth = run_porowave(
      {"reference", paper_case, "--x", "0:0.1:5", "--t", "1e-5,5e-5", "--cross-check"});
  BOOST_TEST(smooth.exit_code == 0);
  BOOST_TEST(smooth.errors == "");
  for (const std::string route : {"bromwich", "modal"}) {
    const auto line = smooth.output.find("\n" + route);
    BOOST_REQUIRE(line != std::string::npos);
    BOOST_TEST(std::stoi(smooth.output.substr(line + 1 + route.size())) == 40);
  }
  BOOST_TEST(contains(smooth.output, "the routes agree"));

  auto arguments = reference_arguments("0:0.1:5", "1e-5");
  arguments.push_back("--cross-check");
  const auto step = run_porowave(arguments);
  BOOST_TEST(step.exit_code == 0);
  BOOST_TEST(contains(step.output, "modal      not compared: modal: load shape = \"step\""));
  arguments.insert(arguments.end(), {"--output", "fields.csv"});
  check_failure(run_porowave(arguments), 2, {"--cross-check", "--output"});
}

BOOST_AUTO_TEST_CASE(a_cross_check_that_compares_nothing_is_inconclusive) {
  // Where and when the load begins all fields jump, and no route says more than that.
  auto arguments = reference_arguments("0", "0");
  arguments.push_back("--cross-check");
  const auto result = run_porowave(arguments);
  BOOST_TEST(result.exit_code == 3);
  BOOST_TEST(contains(result.output, "no value could be compared"));
}

BOOST_AUTO_TEST_SUITE_END()
