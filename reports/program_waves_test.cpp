#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/fronts.hpp"
#include "reference/waves.hpp"
#include "reports/test_csv.hpp"
#include "reports/test_program.hpp"

BOOST_AUTO_TEST_SUITE(program_waves)

using namespace porowave::tests;
using porowave::reference::WaveModes;
namespace tt = boost::test_tools;

namespace {

porowave::reports::ProcessResult waves(std::vector<std::string> more) {
  more.insert(more.begin(), {"waves", paper_problem});
  return run_porowave(more);
}

std::string problem_text(const std::string& column, const std::string& load) {
  return "[material]\nporosity = 0.4\ngrain_density = 2650.0\nfluid_density = 1000.0\n"
         "constrained_modulus = 5e9\nfluid_bulk_modulus = 2.2e9\n"
         "intrinsic_permeability = 1e-11\nfluid_viscosity = 1e-3\n[column]\n" +
         column + "[load]\n" + load;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_summary_has_the_scales_of_the_problem) {
  const auto result = waves({});
  BOOST_TEST(result.exit_code == 0);
  BOOST_TEST(result.errors == "");
  for (const std::string part :
       {"P1 speed, frozen               2297.73 m/s", "P2 speed, frozen               1144.72 m/s",
        "undrained speed                2297.04 m/s",
        "consolidation coefficient      26.1905 m^2/s", "theta L/c1",
        "At low frequency P1 becomes the undrained wave, P2 diffuses"}) {
    BOOST_TEST(contains(result.output, part), result.output << " lacks " << part);
  }
}

BOOST_AUTO_TEST_CASE(a_half_space_has_no_crossing_time) {
  const TestDirectory folder;
  const auto path = folder / "half.toml";
  write_text(path, problem_text("far = \"half_space\"\n"
                                "near = \"velocity\"\n",
                                "shape = \"step\"\nmagnitude = 1.0\n"));
  const auto result = run_porowave({"waves", path.string()});
  BOOST_TEST(result.exit_code == 0);
  BOOST_TEST(contains(result.output, "characteristic frequency"));
  BOOST_TEST(!contains(result.output, "crossing time"));
  BOOST_TEST(!contains(result.output, "theta L/c1"));
}

BOOST_AUTO_TEST_CASE(dispersion_is_a_table_even_in_the_logarithm) {
  const auto result = waves({"--frequency", "1e2:1e8:13"});
  BOOST_TEST(result.exit_code == 0);
  const CsvText csv = read_csv(result.output);
  BOOST_TEST(csv.header ==
             "frequency,p1_phase_velocity,p1_attenuation,p1_inverse_q,p2_phase_velocity,"
             "p2_attenuation,p2_inverse_q");
  BOOST_REQUIRE(csv.rows.size() == 13u);
  const WaveModes modes(porowave::load_problem(paper_problem).material);
  for (std::size_t i = 0; i < csv.rows.size(); ++i) {
    BOOST_REQUIRE(csv.rows[i].size() == 7u);
    const double f = std::stod(csv.rows[i][0]);
    BOOST_TEST(f == std::pow(10.0, 2.0 + 0.5 * static_cast<double>(i)), tt::tolerance(1e-13));
    const auto expected = porowave::reference::dispersion(modes, f);
    for (std::size_t k = 0; k < 2; ++k) {
      BOOST_TEST(std::stod(csv.rows[i][1 + 3 * k]) == expected[k].phase_velocity);
      BOOST_TEST(std::stod(csv.rows[i][2 + 3 * k]) == expected[k].attenuation);
      BOOST_TEST(std::stod(csv.rows[i][3 + 3 * k]) == expected[k].inverse_q);
    }
  }
}

BOOST_AUTO_TEST_CASE(fronts_are_a_table_of_positions_and_jumps) {
  const auto result = waves({"--t", "2e-5,6e-5"});
  BOOST_TEST(result.exit_code == 0);
  const CsvText csv = read_csv(result.output);
  BOOST_TEST(csv.header ==
             "t,x,mode,direction,crossings,effective_stress_jump,pore_pressure_jump,"
             "solid_velocity_jump,fluid_velocity_jump,started,kind");
  BOOST_REQUIRE(csv.rows.size() == 4u);
  const auto expected = [&](std::size_t row, const std::string& mode, const std::string& direction,
                            const std::string& crossings) {
    BOOST_TEST(csv.rows[row][2] == mode);
    BOOST_TEST(csv.rows[row][3] == direction);
    BOOST_TEST(csv.rows[row][4] == crossings);
    BOOST_TEST(csv.rows[row][10] == "jump");
  };
  expected(0, "p2", "up", "0");
  expected(1, "p1", "up", "0");
  expected(2, "p1", "down", "1");
  expected(3, "p2", "up", "0");
  const porowave::Problem problem = porowave::load_problem(paper_problem);
  const auto fronts = porowave::reference::fronts_at(problem, WaveModes(problem.material), 6e-5);
  BOOST_TEST(std::stod(csv.rows[2][1]) == fronts[0].x);
  BOOST_TEST(std::stod(csv.rows[2][5]) == fronts[0].jump.effective_stress);
  BOOST_TEST(std::stod(csv.rows[2][8]) == fronts[0].jump.fluid_velocity);
}

BOOST_AUTO_TEST_CASE(a_smooth_load_has_onsets) {
  const TestDirectory folder;
  const auto path = folder / "smooth.toml";
  write_text(path, problem_text("length = 0.1\nnear = \"sealed_traction\"\n"
                                "far = \"rigid_drained\"\n",
                                "shape = \"smooth_ramp\"\nmagnitude = 1.0\nduration = 1e-5\n"));
  const CsvText csv = read_csv(run_porowave({"waves", path.string(), "--t", "5e-5"}).output);
  BOOST_REQUIRE(csv.rows.size() > 2u);
  for (const auto& row : csv.rows) {
    BOOST_TEST(row[10] == "onset");
    BOOST_TEST(std::stod(row[5]) == 0.0);
  }
}

BOOST_AUTO_TEST_CASE(a_file_gets_what_standard_output_would) {
  const TestDirectory folder;
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{}, {"--frequency", "10,1e5"}, {"--t", "1e-5"}}) {
    std::vector<std::string> arguments = {"waves", paper_problem};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto printed = run_porowave(arguments, folder.path());
    arguments.insert(arguments.end(), {"--output", "table"});
    const auto written = run_porowave(arguments, folder.path());
    BOOST_TEST(written.exit_code == 0);
    BOOST_TEST(written.output == "wrote table\n");
    BOOST_TEST(text_of(folder / "table") == printed.output);
  }
}

BOOST_AUTO_TEST_CASE(wrong_input_is_explained_in_one_line) {
  check_failure(waves({"--frequency", "1e3", "--t", "1e-5"}), 2, {"--frequency or --t, not both"});
  check_failure(waves({"--frequency", "0:1e3:5"}), 2,
                {"--frequency 0:1e3:5: expected numbers > 0"});
  check_failure(waves({"--frequency", "many"}), 2, {"--frequency many: expected numbers"});
  check_failure(waves({"--t", "1e-5,,"}), 2, {"--t 1e-5,,: expected numbers"});
  check_failure(waves({"--t", "1e3"}), 2, {"fronts", "200000"});
  check_failure(waves({"--output", "nowhere/table.csv"}), 5, {"nowhere"});
  check_failure(run_porowave({"waves", "missing.toml"}), 2, {"missing.toml"});
}

BOOST_AUTO_TEST_SUITE_END()
