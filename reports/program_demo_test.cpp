#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <sstream>

#include "reports/test_csv.hpp"
#include "reports/test_pictures.hpp"
#include "reports/test_program.hpp"

BOOST_AUTO_TEST_SUITE(program_demo)

using namespace porowave::tests;

BOOST_AUTO_TEST_CASE(the_example_writes_all_it_lists) {
  const TestDirectory folder;
  const std::string output = (folder / "new/demo").string();
  const auto result = run_example("demo", output);
  BOOST_TEST(result.exit_code == 0);
  BOOST_TEST(result.errors == "");  // progress is for terminals only
  std::istringstream lines(result.output);
  std::string line;
  std::getline(lines, line);
  BOOST_TEST(line.rfind("wrote in ", 0) == 0u);
  std::vector<std::string> listed;
  while (std::getline(lines, line)) {
    BOOST_TEST(line.rfind("  " + output + "/", 0) == 0u, line);
    listed.push_back(line.substr(2));
    BOOST_TEST(std::filesystem::file_size(listed.back()) > 100u);
  }
  BOOST_TEST(listed.size() == 17u);
  std::sort(listed.begin(), listed.end());
  BOOST_TEST((std::unique(listed.begin(), listed.end()) == listed.end()));
  const auto files = std::distance(std::filesystem::directory_iterator(output), {});
  BOOST_TEST(files == static_cast<long>(listed.size()));
  for (const std::string name :
       {"figure3_random_points", "figure4_gap_linear", "figure5_gap_wendland", "convergence"}) {
    check_pictures(output, name);
  }
  const CsvText table = read_csv(text_of(folder / "new/demo/runs.csv"));
  BOOST_TEST(table.header.rfind("study,title,kernel,", 0) == 0u);
  BOOST_TEST(table.rows.size() == 76u);  // 12 profiles; 4 levels of one curve and of 3 with 5 seeds
}

BOOST_AUTO_TEST_CASE(without_gnuplot_nothing_is_begun) {
  const TestDirectory folder;
  const TestDirectory empty;
  const TestVariable path("PATH", empty.path().string());
  check_failure(run_porowave({"demo", "--output", "demo"}, folder.path()), 5,
                {"gnuplot: cannot be started", "apt-get install gnuplot-nox"});
  BOOST_TEST(folder.contents() == "");
}

BOOST_AUTO_TEST_SUITE_END()
