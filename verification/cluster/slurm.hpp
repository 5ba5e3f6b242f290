#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace porowave::verification {

/// What one may ask of Slurm. Empty texts leave the choice to it.
struct SlurmOptions {
  std::string partition = {};
  std::string time = {};  ///< of one task, as sbatch reads it: "02:00:00"
  int nodes = 1;          ///< tasks at a time, each on a node of its own or on a part of one
  int cpus = 1;           ///< of a task, which runs as many cases at a time
  int tasks = 0;          ///< 0: by task_count
};

/// Tasks for so much work, CPU seconds. A task begins with 0.8 s of Slurm's and by making all cases
/// of the study (40 µs each). There is one task a node while each has at least 4 times that to do
/// (3 s or more), and up to eight a node, so that at the end no node waits for long, while each has
/// at least 40 times that (32 s or more: 2.5 % are lost). None above an hour, so that they fit into
/// short queues; beyond the number of nodes a multiple of it, at most 1,000 (Slurm's MaxArraySize
/// is 1,001 if nobody has changed it) and at most one a case.
int task_count(double cpu_seconds, std::size_t study_cases, std::size_t cases,
               const SlurmOptions& options);

/// Files beside a store, and the name that its jobs have. The store's path is made absolute.
struct ClusterFiles {
  explicit ClusterFiles(const std::string& store_path);
  /// The stores of tasks that are there, sorted. Empty without any.
  std::vector<std::string> shards() const;
  /// Of what was submitted so far; the first is 1.
  int next_submission() const;
  std::string submission_folder(int number) const;

  std::string store;         ///< S
  std::string shard_folder;  ///< S.shards: one store a task, NUMBER-TASK
  std::string folder;        ///< S.slurm: `cases`, and a folder for each submission
  std::string job_name;      ///< "porowave-" and a hash of the store's path
};

/// A job: the script and what it is given. Whatever a user has typed is an argument of the script
/// and no part of it, so that nothing needs quotes.
struct SlurmJob {
  std::string script_path;
  std::string script;
  std::vector<std::string> command;  ///< sbatch with all its arguments
};

/// The tasks of a submission: `program sweep` with one shard each, of the cases listed in the file
/// `cases` of its folder.
SlurmJob sweep_job(const ClusterFiles& files, int submission, int tasks, const std::string& program,
                   const std::string& study, const SlurmOptions& options);
/// `program merge` of all shards into the store, when the job `after` has ended however it did; at
/// once if that is empty.
SlurmJob merge_job(const ClusterFiles& files, int submission, const std::string& program,
                   const SlurmOptions& options, const std::string& after);

/// Hands a job, whose script is written, to sbatch and returns its id. Throws EnvironmentError.
std::string submit(const SlurmJob& job);

/// Jobs of a store in Slurm's queue, tasks of an array each by itself.
struct SlurmQueue {
  std::size_t running = 0;
  std::size_t waiting = 0;
};
/// None where there is no squeue, or no controller that answers it.
std::optional<SlurmQueue> slurm_queue(const ClusterFiles& files);

/// A command as a shell would read it back.
std::string shell_line(const std::vector<std::string>& command);

}  // namespace porowave::verification
