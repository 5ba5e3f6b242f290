#include "verification/gate/baseline.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>

#include "reference/problem/errors.hpp"
#include "verification/process/scratch_directory.hpp"

BOOST_AUTO_TEST_SUITE(baseline)

using namespace porowave;
using namespace porowave::verification;

namespace {

Baseline sample() {
  Baseline baseline;
  baseline.history = {"2026-01-01: first", "2026-02-01: it's \"better\", by 3 %"};
  baseline.expected[{"kernel = \"a\", n = 3", "effective_stress_field_l2"}] = {
      "1 2", {0.1, 0.05}, {-3.25, -4.5}, {0.125, 0.0625}, 2, 1.75, 0.0312};
  baseline.expected[{"all cases", "pore_pressure_field_l2"}] = {
      "", {0.1, 0.05}, {-3.25, -4.5}, {0.0, 0.0}, 1, std::nan(""), std::nan("")};
  return baseline;
}

Baseline written_and_read(const std::string& text) {
  const ScratchDirectory directory;
  std::ofstream(directory.file("b.csv")) << text;
  return read_baseline(directory.file("b.csv"));
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_is_written_is_read) {
  const Baseline again = written_and_read(baseline_text(sample()));
  BOOST_TEST(again.history == sample().history, boost::test_tools::per_element());
  BOOST_REQUIRE(again.expected.size() == 2U);
  for (const auto& [key, expected] : sample().expected) {
    const Expected& found = again.expected.at(key);
    BOOST_TEST(found.seeds == expected.seeds);
    BOOST_TEST(found.spacing == expected.spacing, boost::test_tools::per_element());
    BOOST_TEST(found.mean_log == expected.mean_log, boost::test_tools::per_element());
    BOOST_TEST(found.sd_log == expected.sd_log, boost::test_tools::per_element());
    BOOST_TEST(found.replicates == expected.replicates);
    BOOST_TEST((found.order == expected.order || std::isnan(expected.order)));
    BOOST_TEST(std::isnan(found.order_half) == std::isnan(expected.order_half));
  }
}

BOOST_AUTO_TEST_CASE(names_may_hold_what_separates_them) {
  Baseline baseline;
  for (const std::string name : {"a,b", "say \"it\"", "\"", ",", "plain"}) {
    baseline.expected[{name, name}] = {name, {0.1}, {-3.25}, {0.125}, 2, 1.75, 0.5};
  }
  const Baseline again = written_and_read(baseline_text(baseline));
  BOOST_REQUIRE(again.expected.size() == baseline.expected.size());
  for (const auto& [key, expected] : baseline.expected) {
    BOOST_TEST(again.expected.at(key).seeds == expected.seeds);
  }
}

BOOST_AUTO_TEST_CASE(files_that_are_no_baseline_are_refused) {
  const std::string good = baseline_text(sample());
  BOOST_CHECK_THROW(written_and_read(""), InputError);
  BOOST_CHECK_THROW(written_and_read("x,y\n"), InputError);
  BOOST_CHECK_THROW(written_and_read(good + "one,two\n"), InputError);
  BOOST_CHECK_EXCEPTION(written_and_read(good + "g,m,1,1,2,0,0.1,abc,0\n"), InputError,
                        [](const InputError& e) {
                          return std::string(e.what()).ends_with("abc: expected a number");
                        });
  for (const std::string replicates : {"6.7e57", "nan", "99999999999", "2.5", "0", "-1", ""}) {
    BOOST_TEST_CONTEXT("replicates " << replicates) {
      BOOST_CHECK_EXCEPTION(
          written_and_read(good + "g,m,1," + replicates + ",2,0,0.1,0.5,0\n"), InputError,
          [&](const InputError& e) {
            return std::string(e.what()).find(replicates + ": expected a whole number") !=
                   std::string::npos;
          });
    }
  }
  BOOST_CHECK_THROW(read_baseline("/nonexistent/b.csv"), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
