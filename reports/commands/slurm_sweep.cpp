#include "reports/commands/slurm_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <filesystem>

#include "reference/problem/errors.hpp"
#include "reports/output_file.hpp"
#include "verification/cluster/case_list.hpp"
#include "verification/cluster/machine_speed.hpp"
#include "verification/cluster/makespan.hpp"
#include "verification/cluster/status.hpp"
#include "verification/process/process.hpp"
#include "verification/sweep/case_runner.hpp"

namespace porowave::reports {

namespace {

namespace fs = std::filesystem;
using verification::ClusterFiles;
using verification::SlurmJob;

std::string this_program() {
  return fs::read_symlink("/proc/self/exe").string();
}

void make_folder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error)
    throw EnvironmentError(path + ": " + error.message() + ": expected a folder to write in");
}

void require_sbatch() {
  try {
    if (verification::run_process({"sbatch", "--version"}, ".").exit_code == 0) return;
  } catch (const EnvironmentError&) {
  }
  throw EnvironmentError(
      "sbatch: cannot be started: expected Slurm installed and in PATH; without it sweep --shard "
      "i/n "
      "and merge do the same by hand, and --dry-run shows what would be submitted");
}

void print(const SlurmJob& job) {
  fmt::print("\n# {}\n{}# {}\n", job.script_path, job.script,
             verification::shell_line(job.command));
}

void submit_merge(const SlurmJob& merge, const std::string& store) {
  write_file(merge.script_path, merge.script);
  fmt::print("submitted job {}: merges the shards into {}\n", verification::submit(merge), store);
}

/// Writes what the tasks read, then submits both jobs.
void submit_all(const ClusterFiles& files, int submission, const SlurmJob& sweep,
                const verification::CaseList& cases, const std::string& program,
                const verification::SlurmOptions& options) {
  make_folder(files.shard_folder);
  verification::write_case_list(files.submission_folder(submission) + "/cases", cases, "missing");
  write_file(sweep.script_path, sweep.script);
  const std::string array = verification::submit(sweep);
  fmt::print("submitted job {}: the tasks\n", array);
  submit_merge(verification::merge_job(files, submission, program, options, array), files.store);
}

/// All cases have a row; a merging job that was lost may have left some of them in shards.
void submit_what_is_left(const ClusterFiles& files, int submission,
                         const verification::CaseList& all,
                         const verification::SlurmOptions& options, bool dry_run) {
  const auto merged = verification::study_status(all, files.store, {}, std::time(nullptr));
  const std::size_t in_shards = merged.unfinished.entries.size();
  if (in_shards == 0) {
    fmt::print("nothing to run, and all rows are in {}\n", files.store);
    return;
  }
  fmt::print("nothing to run; rows of {} cases are in shards only\n", in_shards);
  const SlurmJob merge = verification::merge_job(files, submission, this_program(), options, "");
  if (dry_run) return print(merge);
  make_folder(files.submission_folder(submission));
  submit_merge(merge, files.store);
}

/// From the rows that are there, which were made where the tasks will run; else by a trial here.
verification::MachineSpeed machine_speed(const verification::Study& study,
                                         const verification::CaseList& all,
                                         const verification::CaseList& missing,
                                         const ClusterFiles& files) {
  constexpr double trial_seconds = 2.0;
  std::vector<std::string> stores = files.shards();
  stores.push_back(files.store);
  const auto stored = verification::speed_of_rows(study, all, stores);
  return stored ? *stored : verification::speed_of_trial(study, missing, trial_seconds);
}

verification::Plan plan_of(const verification::Study& study, const verification::CaseList& missing,
                           int tasks, double speed, const verification::SlurmOptions& options) {
  const std::size_t cases_of_a_task = missing.entries.size() / static_cast<std::size_t>(tasks) + 1;
  const std::size_t profiles = std::min(cases_of_a_task, verification::profile_count(study));
  return {.tasks = tasks,
          .nodes = options.nodes,
          .cpus = options.cpus,
          .study_cases = study.cases.size(),
          .speed = speed,
          .profile_seconds = verification::seconds_per_profile * static_cast<double>(profiles)};
}

void print_prediction(const verification::CaseList& missing, const verification::Plan& plan,
                      const verification::MachineSpeed& speed) {
  std::vector<double> seconds;
  for (const auto& entry : missing.entries) seconds.push_back(static_cast<double>(entry.seconds));
  const verification::ClusterCosts costs;
  const auto end = verification::predicted_makespan(seconds, plan, costs);
  fmt::print("a case takes {:.2f} times as long as the cost model says: {}\n", speed.factor,
             speed.cases == 0 ? "not measured"
                              : fmt::format("{} of {} cases",
                                            speed.stored ? "rows" : "a trial here", speed.cases));
  fmt::print(
      "predicted makespan on {} nodes of {} CPUs: {:.1f} s; tasks end after {:.1f} s, merging "
      "takes {:.1f} s\n",
      plan.nodes, plan.cpus, end.merged, end.tasks, end.merged - end.tasks);
}

}  // namespace

int sweep_by_slurm(const std::string& study_path, const std::string& store,
                   const verification::SlurmOptions& options, bool dry_run) {
  if (!dry_run) require_sbatch();
  const ClusterFiles files(store);
  const verification::Study study = verification::load_study(study_path);
  const verification::CaseList all = verification::case_list(study);
  const auto status =
      verification::study_status(all, files.store, files.shards(), std::time(nullptr));
  const verification::CaseList& missing = status.unfinished;
  const auto speed = machine_speed(study, all, missing, files);
  const double seconds = speed.factor * missing.seconds();
  const int tasks =
      verification::task_count(seconds, all.entries.size(), missing.entries.size(), options);
  fmt::print("{}: {} of {} cases are missing, predicted to take {:.0f} s of CPU: {} tasks\n",
             study.name, missing.entries.size(), all.entries.size(), seconds, tasks);
  const auto queue = verification::slurm_queue(files);
  if (queue && queue->running + queue->waiting > 0 && !dry_run) {
    fmt::print(
        "{} jobs of this store are in the queue: nothing submitted; run again when they have "
        "ended\n",
        queue->running + queue->waiting);
    return 0;
  }
  const std::string program = this_program();
  const int submission = files.next_submission();
  if (missing.entries.empty()) {
    submit_what_is_left(files, submission, all, options, dry_run);
    return 0;
  }
  print_prediction(missing, plan_of(study, missing, tasks, speed.factor, options), speed);
  const SlurmJob sweep = verification::sweep_job(files, submission, tasks, program,
                                                 fs::absolute(study_path).string(), options);
  if (dry_run) {
    print(sweep);
    print(verification::merge_job(files, submission, program, options, "JOB"));
    return 0;
  }
  make_folder(files.submission_folder(submission));
  if (verification::stands_alone(study)) {
    verification::write_case_list(files.folder + "/cases", all,
                                  verification::study_key(study_path));
  }
  submit_all(files, submission, sweep, missing, program, options);
  return 0;
}

}  // namespace porowave::reports
