#include "verification/cluster/makespan.hpp"

#include <algorithm>
#include <functional>
#include <queue>

#include "verification/sweep/shares.hpp"

namespace porowave::verification {

Makespan makespan(std::span<const double> tasks, int nodes, std::size_t rows,
                  const ClusterCosts& costs) {
  std::priority_queue<double, std::vector<double>, std::greater<>> free_at;
  for (int i = 0; i < nodes; ++i) free_at.push(0.0);
  double controller_free_at = 0.0;
  Makespan result;
  for (const double work : tasks) {
    const double begun = std::max(free_at.top(), controller_free_at) + costs.dispatch;
    controller_free_at = begun;
    const double ended = begun + costs.task + work;
    free_at.pop();
    free_at.push(ended);
    result.tasks = std::max(result.tasks, ended);
  }
  result.merged = result.tasks + costs.merge_start + costs.row_merged * static_cast<double>(rows);
  return result;
}

std::vector<double> task_seconds(std::span<const double> case_seconds, const Plan& plan,
                                 const ClusterCosts& costs) {
  std::vector<double> works(case_seconds.begin(), case_seconds.end());
  std::sort(works.begin(), works.end(), std::greater<>());
  const std::vector<int> task_of = shared_out(works, plan.tasks);
  std::vector<std::vector<double>> of_task(static_cast<std::size_t>(plan.tasks));
  for (std::size_t i = 0; i < works.size(); ++i) {
    of_task[static_cast<std::size_t>(task_of[i])].push_back(works[i]);
  }
  const double before = costs.case_made * static_cast<double>(plan.study_cases);
  std::vector<double> seconds;
  for (const std::vector<double>& cases : of_task) {
    const auto at_cpus = share_sums(cases, shared_out(cases, plan.cpus), plan.cpus);
    const double cpu = *std::max_element(at_cpus.begin(), at_cpus.end());
    seconds.push_back(plan.speed * (before + plan.profile_seconds + cpu));
  }
  return seconds;
}

Makespan predicted_makespan(std::span<const double> case_seconds, const Plan& plan,
                            const ClusterCosts& costs) {
  return makespan(task_seconds(case_seconds, plan, costs), plan.nodes, case_seconds.size(), costs);
}

}  // namespace porowave::verification
