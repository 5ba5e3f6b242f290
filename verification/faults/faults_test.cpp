// Every planted fault is caught, by what and with the words that are claimed for it. With
// --log_level=message the table of README.md is printed.

#include <fmt/format.h>

#include <boost/test/unit_test.hpp>
#include <fstream>
#include <iterator>
#include <set>

#include "reference/column_solution.hpp"
#include "reference/tables/truth.hpp"
#include "verification/faults/gate_check.hpp"
#include "verification/faults/kernel_check.hpp"
#include "verification/faults/norm_check.hpp"
#include "verification/faults/open_reference.hpp"
#include "verification/faults/order_check.hpp"
#include "verification/faults/plain_column.hpp"
#include "verification/faults/point_check.hpp"
#include "verification/faults/study_slice.hpp"
#include "verification/faults/truth_check.hpp"

BOOST_AUTO_TEST_SUITE(faults)

using namespace porowave;
using namespace porowave::verification;
using namespace porowave::verification::faults;

namespace {

std::vector<Fault> all_faults() {
  std::vector<Fault> all;
  for (const auto& some : {solver_faults(), point_faults(), kernel_faults(), reference_faults(),
                           norm_faults(), order_faults(), gate_faults()}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

std::string readme() {
  std::ifstream file(std::string(POROWAVE_SOURCE_DIR) + "/verification/README.md");
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Lists of cases are long.
std::string beginning_of(const std::string& text) {
  constexpr std::size_t shown = 120;
  return text.size() <= shown ? text : text.substr(0, text.rfind(' ', shown)) + " ...";
}

/// What README.md says of a fault, up to the words of the verdict, which hold numbers.
std::string beginning_of_row(const Fault& fault, const Catch& caught) {
  return fmt::format("\n| {} | {} | {} | ", fault.where, fault.what, caught.by);
}

}  // namespace

BOOST_AUTO_TEST_CASE(nothing_is_caught_where_nothing_is_wrong) {
  const auto plain = [](const solver::Case& scene, const reference::Profile& exact) {
    return run_plain(scene, exact);
  };
  BOOST_TEST(caught_by_study(run_case).how == "");
  BOOST_TEST(caught_by_study(plain).how == "");
  BOOST_TEST(caught_by_study(plain, Until::return_of_the_wave).how == "");
  BOOST_TEST(caught_by_point_facts(solver::place_points).how == "");
  BOOST_TEST(caught_by_kernel_facts<solver::BSpline1>().how == "");
  BOOST_TEST(caught_by_kernel_facts<solver::BSpline2>().how == "");
  BOOST_TEST(caught_by_kernel_facts<solver::BSpline3>().how == "");
  BOOST_TEST(caught_by_kernel_facts<solver::WendlandC2>().how == "");
  BOOST_TEST(caught_by_kernel_facts<solver::WendlandC4>().how == "");
  BOOST_TEST(caught_by_kernel_facts<solver::WendlandC6>().how == "");
  const auto main_route = [](const Problem& problem, double x, double t) {
    return reference::ColumnSolution(problem).at(x, t).value;
  };
  const auto open = [](const Problem& problem, double x, double t) {
    return open_reference(problem, x, t);
  };
  BOOST_TEST(truth_rows_compared() >= 10);
  BOOST_TEST(caught_by_truth(main_route).how == "");
  BOOST_TEST(caught_by_truth(open).how == "");
  BOOST_TEST(caught_by_norm_facts(relative_norms).how == "");
  BOOST_TEST(caught_by_order_facts([](const ErrorTable& table) {
               return estimate_order(table);
             }).how == "");
  const auto right_judge = [](const auto& groups, const auto& rules, const auto& baseline) {
    return judge(groups, rules, baseline);
  };
  BOOST_TEST(caught_by_gate_facts(right_judge).how == "");
}

BOOST_AUTO_TEST_CASE(every_planted_fault_is_caught_as_claimed_and_listed) {
  const std::string listed = readme();
  std::set<std::string> names;
  std::string table = "| in | fault | caught by | verdict or message |\n|---|---|---|---|";
  const std::vector<Fault> all = all_faults();
  for (const Fault& fault : all) {
    BOOST_TEST_CONTEXT(fault.where << ": " << fault.what) {
      BOOST_TEST(names.insert(fault.what).second);
      const Catch caught = fault.plant();
      BOOST_TEST(caught.how != "");
      BOOST_TEST(caught.how.find(fault.named) != std::string::npos,
                 "\"" << caught.how << "\" lacks \"" << fault.named << "\"");
      const std::string row = beginning_of_row(fault, caught);
      BOOST_TEST((listed.find(row) != std::string::npos), "README.md lacks" << row);
      table += row + beginning_of(caught.how) + " |";
    }
  }
  BOOST_TEST(all.size() >= 40U);
  BOOST_TEST_MESSAGE(all.size() << " planted faults\n" << table);
}

BOOST_AUTO_TEST_SUITE_END()
