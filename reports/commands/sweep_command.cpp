#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <csignal>
#include <ctime>
#include <memory>
#include <regex>
#include <thread>

#include "reference/problem/errors.hpp"
#include "reports/commands/commands.hpp"
#include "reports/commands/slurm_sweep.hpp"
#include "reports/progress.hpp"
#include "verification/cluster/case_list.hpp"
#include "verification/sweep/repeat.hpp"
#include "verification/sweep/sweep.hpp"

namespace porowave::reports {

namespace {

constexpr int exit_differs = 1;
constexpr int exit_environment = 5;
constexpr int exit_stopped = 130;

struct SweepOptions {
  std::string study;
  std::string store;
  int jobs = 0;
  std::string shard;
  std::string one;
  std::string only;
  bool dry_run = false;
  bool slurm = false;
  verification::SlurmOptions cluster;
};

std::atomic<bool> stop = false;

/// The first signal ends the sweep when the cases under way are done, the second at once.
void ask_to_stop(int signal) {
  stop = true;
  std::signal(signal, SIG_DFL);
}

std::optional<verification::Shard> parse_shard(const std::string& text) {
  if (text.empty()) return std::nullopt;
  verification::Shard shard;
  int used = 0;
  const bool read = std::sscanf(text.c_str(), "%d/%d%n", &shard.index, &shard.count, &used) == 2 &&
                    static_cast<std::size_t>(used) == text.size();
  if (!read || shard.index < 1 || shard.count < shard.index) {
    throw InputError(fmt::format("--shard {}: expected i/n with 1 <= i <= n, such as 1/4", text));
  }
  return shard;
}

int repeat_one(const SweepOptions& options) {
  const auto result = verification::repeat(verification::Store::open(options.store), options.one);
  fmt::print("case {}\n{}", result.stored.id, verification::comparison(result));
  if (result.now.status == verification::CaseStatus::broke_down) {
    fmt::print(stderr, "porowave: {}\n", result.now.reason);
    return exit_broke_down;
  }
  return result.same ? 0 : exit_differs;
}

int report(const verification::SweepSummary& summary, const std::string& store, bool is_adapter,
           double seconds) {
  using verification::CaseStatus;
  const auto count = [&](CaseStatus s) { return summary.by_status[static_cast<std::size_t>(s)]; };
  fmt::print(
      "{} cases: {} were in the store; run now in {:.1f} s: {} done, {} broke down, {} refused, "
      "{} failed\nCPU time: solver {:.1f} s, reference and errors {:.1f} s, all else {:.1f} "
      "s\nwrote {}\n",
      summary.cases, summary.reused, seconds, count(CaseStatus::done),
      count(CaseStatus::broke_down), count(CaseStatus::refused), count(CaseStatus::failed),
      summary.solver_cpu_seconds,
      summary.case_cpu_seconds - (is_adapter ? 0.0 : summary.solver_cpu_seconds),
      static_cast<double>(std::clock()) / CLOCKS_PER_SEC - summary.case_cpu_seconds, store);
  if (summary.stopped) {
    fmt::print(stderr, "porowave: stopped by a signal; the same command goes on from here\n");
    return exit_stopped;
  }
  if (count(CaseStatus::failed) == 0) return 0;
  fmt::print(stderr,
             "porowave: {} cases failed for reasons outside of them; the same command tries "
             "them again\n",
             count(CaseStatus::failed));
  return exit_environment;
}

int run_sweep(const SweepOptions& options) {
  if (!options.one.empty()) return repeat_one(options);
  if (options.slurm) {
    return sweep_by_slurm(options.study, options.store, options.cluster, options.dry_run);
  }
  verification::SweepOptions how;
  how.shard = parse_shard(options.shard);
  if (!options.only.empty()) how.only = verification::read_case_ids(options.only);
  const verification::Study study = verification::load_study(options.study);
  const std::size_t cases = verification::cases_of(study, how.shard, how.only).size();
  if (options.dry_run) {
    fmt::print("{}: {} cases\n", study.name, cases);
    return 0;
  }
  // Shards are for several machines, whose common disk may be a network file system.
  auto store = verification::Store::create_or_open(
      options.store, how.shard ? verification::Store::Journal::rollback
                               : verification::Store::Journal::write_ahead);
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  Progress progress(study.name, static_cast<int>(cases));
  how.jobs = options.jobs;
  how.stop = &stop;
  how.progress = [&](std::size_t done, std::size_t to_do) {
    progress.set(static_cast<int>(done), static_cast<int>(to_do));
  };
  const auto start = std::chrono::steady_clock::now();
  const auto summary = verification::sweep(study, store, how);
  progress.end();
  return report(summary, options.store, study.adapter.has_value(),
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

/// The forms that sbatch takes, so that a slip is told before anything is written.
std::string not_a_time_limit(const std::string& text) {
  static const std::regex form("([0-9]+-)?[0-9]+(:[0-9]+){0,2}|infinite|unlimited",
                               std::regex::icase);
  constexpr std::size_t longest = 32;  // std::regex takes stack for every character
  if (text.size() <= longest && std::regex_match(text, form)) return {};
  return fmt::format(
      "{}: expected minutes, [hours:]minutes:seconds or days-hours[:minutes[:seconds]]", text);
}

void add_slurm_options(CLI::App& command, SweepOptions& options) {
  CLI::Option* slurm = command.add_flag(
      "--slurm", options.slurm,
      "Submit what the store lacks to Slurm: a job array and a job that merges its results");
  const auto add = [&](const char* name, auto& value, const char* text) {
    return command.add_option(name, value, text)->needs(slurm);
  };
  add("--partition", options.cluster.partition, "Of Slurm; its default if absent");
  add("--time", options.cluster.time, "Limit of one task, as sbatch reads it: 02:00:00")
      ->check(not_a_time_limit);
  add("--nodes", options.cluster.nodes, "Tasks at a time; 1 if absent")
      ->check(CLI::Range(1, 100'000));
  add("--cpus", options.cluster.cpus, "CPUs of a task; 1 if absent")->check(CLI::Range(1, 1024));
  add("--tasks", options.cluster.tasks, "Tasks in all; by predicted cost if absent")
      ->check(CLI::Range(1, 1000));
  for (const char* other : {"--jobs", "--shard", "--case", "--cases"}) {
    slurm->excludes(command.get_option(other));
  }
}

}  // namespace

void add_sweep_command(CLI::App& program, Command& run) {
  auto options = std::make_shared<SweepOptions>();
  CLI::App* command = program.add_subcommand("sweep", "A grid of cases; run again to resume");
  command->add_option("study", options->study, "Study file (TOML)")->required();
  command->add_option("--store", options->store, "Store of results (SQLite file)")->required();
  command->add_option("--jobs", options->jobs, "Cases at a time; one a core if absent")
      ->check(CLI::Range(1, 1024));
  command->add_option("--shard", options->shard, "i/n: only part i of n, for several machines");
  command->add_option(
      "--case", options->one,
      "Id of a row (or how it begins): repeat that case with this program, compare");
  command->add_option("--cases", options->only,
                      "Only the cases whose ids are in this file, one a line");
  command->add_flag("--dry-run", options->dry_run,
                    "Check the study and count its cases; with --slurm print scripts and commands");
  add_slurm_options(*command, *options);
  for (const char* other : {"--jobs", "--shard", "--cases", "--dry-run"}) {
    command->get_option("--case")->excludes(command->get_option(other));
  }
  command->footer(
      "Every case is a row of the store, keyed by a hash of its full specification and of the\n"
      "sources that decide numbers. Killed at any moment, the sweep goes on where it was.\n"
      "--case ends with 0 if all errors are what they were, 1 if not, 4 if the run broke down "
      "(with the likely cause):\n"
      "usable as git bisect run porowave sweep STUDY.toml --store results --case ID\n"
      "--slurm writes scripts to STORE.slurm and results of tasks to STORE.shards; run again it\n"
      "submits what is missing then. porowave status tells how far it is.\n"
      "Example: porowave sweep verification/studies/smoke.toml --store results");
  command->callback([options, &run] { run = [options] { return run_sweep(*options); }; });
}

}  // namespace porowave::reports
