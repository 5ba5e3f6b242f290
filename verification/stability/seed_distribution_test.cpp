#include "verification/stability/seed_distribution.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "reference/problem/toml_document.hpp"
#include "verification/stability/text_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(seed_distribution)

using namespace porowave;
using namespace porowave::verification;

namespace {

/// Seeds 1 to 10 of two numbers of points; the seeds in the middle of the axes.
Study trial(const std::string& seeds) {
  return read_study(TomlDocument::parse(fixtures::column_text("1e-11") + R"([discretization]
elements = 12
placement = "stratified"
[time]
end = 1e-5
[study]
name = "seeds"
[axes]
"discretization.points_per_element" = [2, 4]
)" + seeds + "\"discretization.kernel\" = [\"bspline2\"]\n",
                                        "study.toml"));
}

Study ten_seeds() {
  return trial("\"discretization.seed\" = { first = 1, count = 10 }\n");
}

/// Limits of 0.1, 0.2, ... 1.0 of the first ten cases in another order (the tenth unlimited), and
/// of the others: one refused, three without a stable step, the rest 0.5.
std::vector<MappedStability> made_up() {
  std::vector<MappedStability> map(20);
  for (std::size_t i = 0; i < 10; ++i) {
    map[i].critical.courant = 0.1 * static_cast<double>((7 * i) % 10 + 1);
    map[i].critical.unstable = map[i].critical.courant == 1.0 ? 0.0 : 1.01;
    map[i + 10].critical.courant = 0.5;
    map[i + 10].critical.unstable = 0.501;
  }
  map[12].refused = "no point";
  for (const std::size_t i : {13U, 15U, 18U}) {
    map[i].critical = {0.0, 0.05, {{0.05, i == 15U ? 1.3 : 1.1, false}}};
  }
  return map;
}

}  // namespace

BOOST_AUTO_TEST_CASE(limits_are_gathered_by_all_axes_but_the_seeds) {
  const auto found = seed_distributions(ten_seeds(), made_up());
  BOOST_TEST_REQUIRE(found.size() == 2U);
  BOOST_TEST(found[0].coordinates[0].text() == "2");
  BOOST_TEST(found[0].courant.size() == 10U);
  BOOST_TEST(found[0].unlimited == 1);
  BOOST_TEST(found[0].worst_seed == "1");
  BOOST_TEST(found[1].courant.size() == 9U);
  BOOST_TEST(found[1].refused == 1);
  BOOST_TEST(found[1].unlimited == 0);
  BOOST_TEST(found[1].worst_seed == "6");  // of three unstable ones noise grows most
}

// Of k/10, k = 1 ... 10, share s does not exceed the smallest k/10 >= s.
BOOST_AUTO_TEST_CASE(quantiles_are_those_of_the_definition) {
  const auto one = seed_distributions(ten_seeds(), made_up())[0];
  BOOST_TEST(one.quantile(0.0) == 0.1, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(one.quantile(0.05) == 0.1, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(one.quantile(0.11) == 0.2, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(one.quantile(0.5) == 0.5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(one.quantile(0.95) == 1.0, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(one.quantile(1.0) == 1.0, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(std::isnan(SeedDistribution{}.quantile(0.5)));
}

BOOST_AUTO_TEST_CASE(the_table_has_a_row_a_combination) {
  std::ostringstream out;
  const Study study = ten_seeds();
  write_seed_csv(study, seed_distributions(study, made_up()), out);
  const auto lines = fixtures::lines_of(out.str());
  BOOST_TEST_REQUIRE(lines.size() == 3U);
  BOOST_TEST(
      lines[0].starts_with("discretization.points_per_element,discretization.kernel,seeds,"));
  BOOST_TEST(lines[1] == "2,bspline2,10,0,0,1,0.1,0.1,0.3,0.5,0.8,1,1");
  BOOST_TEST(lines[2] == "4,bspline2,10,1,3,0,0,0,0,0.5,0.5,0.5,6");
}

BOOST_AUTO_TEST_CASE(a_study_without_seeds_has_no_distribution) {
  BOOST_CHECK_THROW(seed_distributions(trial(""), {}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
