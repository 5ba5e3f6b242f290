#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/energy.hpp"
#include "reports/test_csv.hpp"
#include "reports/test_program.hpp"

BOOST_AUTO_TEST_SUITE(program_reference_derived)

using namespace porowave::tests;
using porowave::reference::ColumnSolution;

namespace {

porowave::reports::ProcessResult run(const std::vector<std::string>& options,
                                     const std::filesystem::path& directory = ".") {
  std::vector<std::string> arguments = {"reference", paper_problem};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run_porowave(arguments, directory);
}

}  // namespace

BOOST_AUTO_TEST_CASE(derived_columns_follow_the_others_which_stay_as_they_are) {
  const std::vector<std::string> options = {"--x", "0:0.1:5", "--t", "1e-5,4e-5"};
  const CsvText plain = read_csv(run(options).output);
  auto more = options;
  more.push_back("--derived");
  const auto result = run(more);
  BOOST_TEST(result.exit_code == 0);
  BOOST_TEST(result.errors == "");
  const CsvText csv = read_csv(result.output);
  BOOST_TEST(csv.header ==
             plain.header +
                 ",total_stress,seepage_velocity,solid_displacement,fluid_displacement,"
                 "total_stress_error,seepage_velocity_error,solid_displacement_error,"
                 "fluid_displacement_error");
  BOOST_REQUIRE(csv.rows.size() == plain.rows.size());
  for (std::size_t i = 0; i < csv.rows.size(); ++i) {
    BOOST_REQUIRE(csv.rows[i].size() == 18u);
    for (std::size_t j = 0; j < 10; ++j) BOOST_TEST(csv.rows[i][j] == plain.rows[i][j]);
  }
}

BOOST_AUTO_TEST_CASE(derived_values_are_those_of_the_reference) {
  const ColumnSolution solution(porowave::load_problem(paper_problem));
  const CsvText csv = read_csv(run({"--derived", "--x", "0.011,0.04", "--t", "4e-5"}).output);
  BOOST_REQUIRE(csv.rows.size() == 2u);
  for (const auto& row : csv.rows) {
    const auto derived = derived_fields(solution, std::stod(row[0]), std::stod(row[1]));
    const auto check = [&](std::size_t column, const porowave::reference::Bounded& expected) {
      BOOST_TEST(expected.value != 0.0);
      BOOST_TEST(std::abs(std::stod(row[column]) - expected.value) <= 2.0 * expected.error);
      BOOST_TEST(std::stod(row[column + 4]) < 1e-10 * std::abs(expected.value));
    };
    check(10, derived.total_stress);
    check(11, derived.seepage_velocity);
    check(12, derived.solid_displacement);
    check(13, derived.fluid_displacement);
  }
}

BOOST_AUTO_TEST_CASE(energies_balance) {
  const auto result = run({"--energy", "--t", "0,4e-5,1e-5"});
  BOOST_TEST(result.exit_code == 0);
  BOOST_TEST(result.errors == "");
  const CsvText csv = read_csv(result.output);
  BOOST_TEST(csv.header == "t,settlement,work,kinetic_energy,elastic_energy,dissipated_energy");
  BOOST_REQUIRE(csv.rows.size() == 3u);
  BOOST_TEST(std::stod(csv.rows[0][2]) == 0.0);
  const std::vector<double> times = {0.0, 4e-5, 1e-5};
  for (std::size_t i = 1; i < 3; ++i) {
    const auto number = [&](std::size_t column) { return std::stod(csv.rows[i][column]); };
    BOOST_TEST(number(0) == times[i]);
    // The load is a step of 1 Pa: its work is the settlement.
    BOOST_TEST(std::abs(number(2) - number(1)) < 1e-12 * number(1));
    BOOST_TEST(std::abs(number(3) + number(4) + number(5) - number(2)) < 1e-14 * number(2));
    BOOST_TEST(number(5) > 0.0);
  }
}

BOOST_AUTO_TEST_CASE(a_file_gets_the_energies_too) {
  const TestDirectory folder;
  const auto printed = run({"--energy", "--t", "1e-5"}, folder.path());
  const auto written = run({"--energy", "--t", "1e-5", "--output", "energy.csv"}, folder.path());
  BOOST_TEST(written.exit_code == 0);
  BOOST_TEST(written.output == "wrote energy.csv\n");
  BOOST_TEST(text_of(folder / "energy.csv") == printed.output);
}

BOOST_AUTO_TEST_CASE(options_that_make_no_sense_together_are_refused) {
  check_failure(run({"--energy", "--x", "0", "--t", "1e-5"}), 2, {"--energy", "--x"});
  check_failure(run({"--energy", "--derived", "--t", "1e-5"}), 2, {"--energy", "--derived"});
  check_failure(run({"--energy"}), 2, {"--t is required"});
  check_failure(run({"--derived", "--t", "1e-5"}), 2, {"--x is required"});
}

BOOST_AUTO_TEST_SUITE_END()
