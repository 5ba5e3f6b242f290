#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace porowave::verification {

/// What a cluster takes beside the cases, s. The values are those of a controller and nodes on one
/// machine (ci/cluster-scaling.sh prints them anew).
struct ClusterCosts {
  double task = 0.75;        ///< of a node for a task: prolog, program, epilog
  double dispatch = 0.01;    ///< of the controller for a task; it begins one after the other
  double case_made = 4e-5;   ///< of a task for every case of the study, whoever runs it
  double merge_start = 1.0;  ///< from the end of the last task to the beginning of the merging
  double row_merged = 4.25e-5;
};

/// When everything has ended, s after submission.
struct Makespan {
  double tasks = 0.0;   ///< the last task
  double merged = 0.0;  ///< the merging job
};

/// Simulates a job array event by event: `tasks` are the seconds that each is at work (>= 0), begun
/// in their order; a task waits for a node to be free and for the controller, keeps its node for
/// its work and `costs.task`, and the merging of `rows` begins when all have ended. `nodes` >= 1
/// work at a time and equally fast.
Makespan makespan(std::span<const double> tasks, int nodes, std::size_t rows,
                  const ClusterCosts& costs);

/// A study in tasks: what `sweep --shard` will do with cases of these CPU seconds.
struct Plan {
  int tasks = 1;
  int nodes = 1;
  int cpus = 1;                  ///< of a task
  std::size_t study_cases = 0;   ///< with those that are done
  double speed = 1.0;            ///< seconds of this machine a second predicted
  double profile_seconds = 0.0;  ///< of a task for profiles of references
};

/// Seconds at work of each task: cases longest first to the task with the least so far, and in a
/// task to the CPU that is free first. In the order of the tasks' numbers.
std::vector<double> task_seconds(std::span<const double> case_seconds, const Plan& plan,
                                 const ClusterCosts& costs);

/// Of cases that are each predicted to take so long.
Makespan predicted_makespan(std::span<const double> case_seconds, const Plan& plan,
                            const ClusterCosts& costs);

}  // namespace porowave::verification
