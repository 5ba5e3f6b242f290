#include <boost/test/unit_test.hpp>

#include "reports/test_pictures.hpp"
#include "reports/test_program.hpp"

BOOST_AUTO_TEST_SUITE(program_explain)

using namespace porowave::tests;

BOOST_AUTO_TEST_CASE(it_lists_the_groups_of_waves_and_draws_the_plane) {
  const TestDirectory directory;
  const auto result = run_porowave({"explain", paper_problem, "--x", "0.02", "--t", "4e-5",
                                    "--output", (directory.path() / "out").string()});
  BOOST_TEST(result.errors == "");
  BOOST_TEST(result.exit_code == 0);
  BOOST_TEST(result.output.find("opening") != std::string::npos);
  check_pictures(directory.path() / "out", "contour");
}

BOOST_AUTO_TEST_CASE(where_no_wave_has_arrived_it_says_so) {
  const auto result = run_porowave({"explain", paper_problem, "--x", "0.1", "--t", "1e-5"});
  BOOST_TEST(result.exit_code == 0);
  BOOST_TEST(result.output.find("exactly zero") != std::string::npos);
  const auto outside = run_porowave({"explain", paper_problem, "--x", "0.2", "--t", "1e-5"});
  BOOST_TEST(outside.exit_code == 2);
  BOOST_TEST(outside.output == "");
}

BOOST_AUTO_TEST_SUITE_END()
