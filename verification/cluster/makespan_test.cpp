#include "verification/cluster/makespan.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>
#include <random>

BOOST_AUTO_TEST_SUITE(makespan)

using namespace porowave;
using namespace porowave::verification;

namespace {

constexpr ClusterCosts nothing{0.0, 0.0, 0.0, 0.0, 0.0};
const auto near = boost::test_tools::tolerance(1e-12);

std::vector<double> some_works(std::size_t count) {
  std::mt19937 random(11);
  std::exponential_distribution<double> work(0.1);
  std::vector<double> works(count);
  for (double& w : works) w = work(random);
  return works;
}

double sum(const std::vector<double>& works) {
  return std::accumulate(works.begin(), works.end(), 0.0);
}

}  // namespace

BOOST_AUTO_TEST_CASE(one_node_takes_the_sum_of_works_and_overheads_and_merges_then) {
  const auto works = some_works(20);
  const ClusterCosts costs{0.5, 0.125, 0.0, 3.0, 0.01};
  const Makespan result = verification::makespan(works, 1, 400, costs);
  BOOST_TEST(result.tasks == sum(works) + 20 * 0.625, near);
  BOOST_TEST(result.merged == result.tasks + 3.0 + 4.0, near);
  BOOST_TEST(verification::makespan({}, 4, 100, costs).merged == 4.0, near);
}

BOOST_AUTO_TEST_CASE(equal_tasks_without_overhead_come_in_rounds) {
  for (const std::size_t tasks : {1U, 6U, 7U, 12U, 13U}) {
    for (const int nodes : {1, 2, 3, 6, 50}) {
      const std::vector<double> works(tasks, 2.5);
      const double rounds = std::ceil(static_cast<double>(tasks) / nodes);
      BOOST_TEST(verification::makespan(works, nodes, 0, nothing).merged == 2.5 * rounds, near);
    }
  }
}

BOOST_AUTO_TEST_CASE(no_cluster_beats_its_share_its_longest_task_or_its_controller) {
  const auto works = some_works(300);
  const ClusterCosts costs{0.4, 0.05, 0.0, 0.0, 0.0};
  const double longest = *std::max_element(works.begin(), works.end()) + 0.45;
  double last = sum(works) + 300 * 0.45 + 1.0;
  for (const int nodes : {1, 2, 10, 100, 1000}) {
    const double end = verification::makespan(works, nodes, 0, costs).tasks;
    const double least = std::max({(sum(works) + 300 * 0.45) / nodes, longest, 300 * 0.05 + 0.4});
    BOOST_TEST(end >= least * (1.0 - 1e-12));
    BOOST_TEST(end <= last);  // more nodes are never slower here
    last = end;
    const double without = verification::makespan(works, nodes, 0, nothing).tasks;
    const double bound =
        std::max(sum(works) / nodes, *std::max_element(works.begin(), works.end()));
    BOOST_TEST(without <= (2.0 - 1.0 / nodes) * bound * (1.0 + 1e-12));
  }
}

BOOST_AUTO_TEST_CASE(the_controller_begins_tasks_one_after_the_other) {
  // Tasks of no length: the last of 1,000 begins when the controller has begun all.
  const std::vector<double> works(1000, 0.0);
  const ClusterCosts costs{0.3, 0.01, 0.0, 0.0, 0.0};
  BOOST_TEST(verification::makespan(works, 1000, 0, costs).tasks == 10.0 + 0.3,
             boost::test_tools::tolerance(1e-9));
  // Ten nodes that are each 0.3 s busy with a task, and the controller 0.01 s: nodes decide.
  BOOST_TEST(verification::makespan(works, 10, 0, costs).tasks == 100 * 0.31 + 9 * 0.01,
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(every_cost_makes_it_later) {
  const auto works = some_works(50);
  const ClusterCosts costs{0.4, 0.05, 1e-3, 1.0, 1e-3};
  const Plan plan{
      .tasks = 9, .nodes = 4, .cpus = 2, .study_cases = 60, .speed = 1.5, .profile_seconds = 0.25};
  const double end = predicted_makespan(works, plan, costs).merged;
  for (double ClusterCosts::*cost :
       {&ClusterCosts::task, &ClusterCosts::dispatch, &ClusterCosts::case_made,
        &ClusterCosts::merge_start, &ClusterCosts::row_merged}) {
    ClusterCosts more = costs;
    more.*cost *= 2.0;
    BOOST_TEST(predicted_makespan(works, plan, more).merged > end);
  }
  for (double Plan::*part : {&Plan::speed, &Plan::profile_seconds}) {
    Plan slower = plan;
    slower.*part *= 2.0;
    BOOST_TEST(predicted_makespan(works, slower, costs).merged > end);
  }
}

BOOST_AUTO_TEST_CASE(a_task_is_its_share_of_cases_at_its_speed) {
  const auto works = some_works(40);
  const Plan plan{.tasks = 5, .study_cases = 1000, .speed = 2.0, .profile_seconds = 0.25};
  ClusterCosts costs = nothing;
  costs.case_made = 1e-3;
  const auto tasks = task_seconds(works, plan, costs);
  BOOST_TEST(tasks.size() == 5U);
  BOOST_TEST(sum(tasks) == 2.0 * (sum(works) + 5 * (1.0 + 0.25)), near);
  // Two CPUs halve equal cases; an odd one is for one of them alone.
  Plan two = plan;
  two.tasks = 1;
  two.cpus = 2;
  const std::vector<double> five(5, 3.0);
  BOOST_TEST(task_seconds(five, two, nothing).front() == 2.0 * (9.0 + 0.25), near);
}

BOOST_AUTO_TEST_SUITE_END()
