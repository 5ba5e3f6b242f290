#include "verification/cluster/slurm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "reference/problem/errors.hpp"
#include "verification/process/process.hpp"
#include "verification/study/case_identity.hpp"

namespace porowave::verification {

namespace {

namespace fs = std::filesystem;

constexpr double slurm_seconds = 0.8;      // a task and slot
constexpr double seconds_per_case = 4e-5;  // to make a case from its study
constexpr double worth_a_node = 4.0;       // times the overhead
constexpr double worth = 40.0;             // the same, of more tasks than nodes
constexpr double longest_seconds = 3600.0;
constexpr double tasks_per_node = 8.0;
constexpr double most_tasks = 1000.0;
constexpr double queue_patience = 20.0;  // s

constexpr auto sweep_script = R"(#!/bin/sh
# Arguments: program, study, store of the task up to its number, number of tasks, cases, CPUs.
exec "$1" sweep "$2" --store "$3$SLURM_ARRAY_TASK_ID" --shard "$SLURM_ARRAY_TASK_ID/$4" \
  --cases "$5" --jobs "$6"
)";

constexpr auto merge_script = R"(#!/bin/sh
# Arguments: program, store, folder of the tasks' stores.
program=$1 store=$2 folder=$3
set --
for shard in "$folder"/*-*[0-9]; do
  if [ -s "$shard" ]; then set -- "$@" "$shard"; fi
done
if [ $# -eq 0 ]; then
  echo "$folder: no task has left a store" >&2
  exit 5
fi
exec "$program" merge "$store" "$@"
)";

/// sbatch replaces %a and the like in the name of its output.
std::string without_patterns(const std::string& path) {
  std::string text;
  for (const char c : path) text.append(c == '%' ? 2 : 1, c);
  return text;
}

std::vector<std::string> sbatch(const std::string& name, const SlurmOptions& options) {
  std::vector<std::string> command = {"sbatch", "--parsable", "--job-name=" + name, "--nodes=1",
                                      "--ntasks=1"};
  if (!options.partition.empty()) command.push_back("--partition=" + options.partition);
  if (!options.time.empty()) command.push_back("--time=" + options.time);
  return command;
}

void append(std::vector<std::string>& command, const std::vector<std::string>& more) {
  command.insert(command.end(), more.begin(), more.end());
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

}  // namespace

int task_count(double cpu_seconds, std::size_t study_cases, std::size_t cases,
               const SlurmOptions& options) {
  if (cases == 0) return 0;
  const auto most = static_cast<double>(cases);
  if (options.tasks > 0) return static_cast<int>(std::min<double>(options.tasks, most));
  const double wall_seconds = cpu_seconds / options.cpus;
  const double overhead = slurm_seconds + seconds_per_case * static_cast<double>(study_cases);
  const double worthwhile =
      std::max(wall_seconds / (worth * overhead),
               std::min<double>(options.nodes, wall_seconds / (worth_a_node * overhead)));
  const double wanted = std::max(tasks_per_node * options.nodes, wall_seconds / longest_seconds);
  auto count = static_cast<int>(std::clamp(std::min(worthwhile, wanted), 1.0, most_tasks));
  if (count > options.nodes) count -= count % options.nodes;
  return static_cast<int>(std::min<double>(count, most));
}

ClusterFiles::ClusterFiles(const std::string& store_path)
    : store(fs::absolute(store_path).lexically_normal().string()),
      shard_folder(store + ".shards"),
      folder(store + ".slurm"),
      job_name("porowave-" + text_hash(store).substr(0, 12)) {}

std::vector<std::string> ClusterFiles::shards() const {
  std::vector<std::string> paths;
  if (!fs::is_directory(shard_folder)) return paths;
  for (const auto& entry : fs::directory_iterator(shard_folder)) {
    const std::string name = entry.path().filename().string();
    // Journals lie beside the stores; a store whose making has just begun is empty.
    const bool is_shard = name.find_first_not_of("0123456789-") == std::string::npos;
    if (is_shard && entry.file_size() > 0) paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

int ClusterFiles::next_submission() const {
  int number = 1;
  while (fs::exists(submission_folder(number))) ++number;
  return number;
}

std::string ClusterFiles::submission_folder(int number) const {
  return fmt::format("{}/{}", folder, number);
}

SlurmJob sweep_job(const ClusterFiles& files, int submission, int tasks, const std::string& program,
                   const std::string& study, const SlurmOptions& options) {
  const std::string folder = files.submission_folder(submission);
  SlurmJob job{folder + "/sweep.sh", sweep_script, sbatch(files.job_name, options)};
  append(job.command,
         {fmt::format("--array=1-{}%{}", tasks, options.nodes),
          fmt::format("--cpus-per-task={}", options.cpus), "--requeue", "--open-mode=append",
          "--output=" + without_patterns(folder) + "/task-%a.out", job.script_path, program, study,
          fmt::format("{}/{}-", files.shard_folder, submission), std::to_string(tasks),
          folder + "/cases", std::to_string(options.cpus)});
  return job;
}

SlurmJob merge_job(const ClusterFiles& files, int submission, const std::string& program,
                   const SlurmOptions& options, const std::string& after) {
  const std::string folder = files.submission_folder(submission);
  SlurmJob job{folder + "/merge.sh", merge_script, sbatch(files.job_name, options)};
  if (!after.empty()) append(job.command, {"--dependency=afterany:" + after});
  append(job.command,
         {"--requeue", "--open-mode=append", "--output=" + without_patterns(folder) + "/merge.out",
          job.script_path, program, files.store, files.shard_folder});
  return job;
}

std::string submit(const SlurmJob& job) {
  const ProcessResult result = run_process(job.command, ".");
  if (result.exit_code != 0) {
    throw EnvironmentError(fmt::format("sbatch: {}; expected it to take the job {}",
                                       first_line(result.errors), job.script_path));
  }
  const std::string id = first_line(result.output);
  return id.substr(0, id.find(';'));  // the name of the cluster may follow
}

std::optional<SlurmQueue> slurm_queue(const ClusterFiles& files) {
  ProcessResult result;
  try {
    result =
        run_process({"squeue", "--noheader", "--array", "--format=%T", "--name=" + files.job_name},
                    ".", {.seconds = queue_patience});
  } catch (const EnvironmentError&) {
    return std::nullopt;
  }
  if (result.exit_code != 0 || result.timed_out) return std::nullopt;
  SlurmQueue queue;
  std::istringstream lines(result.output);
  for (std::string state; lines >> state;) {
    ++(state == "RUNNING" || state == "COMPLETING" ? queue.running : queue.waiting);
  }
  return queue;
}

std::string shell_line(const std::vector<std::string>& command) {
  constexpr auto plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./%@";
  std::string line;
  for (const std::string& word : command) {
    if (!line.empty()) line += ' ';
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += '\'';
  }
  return line;
}

}  // namespace porowave::verification
