#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <ctime>
#include <memory>

#include "reports/commands/commands.hpp"
#include "verification/cluster/slurm.hpp"
#include "verification/cluster/status.hpp"

namespace porowave::reports {

namespace {

struct StatusOptions {
  std::string study;
  std::string store;
};

constexpr std::int64_t recently = 60;  // s

/// Shards that were written to a short while ago: where nobody knows of a queue, work in progress.
std::size_t shards_at_work(const std::vector<std::string>& shards) {
  std::size_t count = 0;
  const auto now = std::filesystem::file_time_type::clock::now();
  for (const std::string& shard : shards) {
    std::error_code gone;
    const auto written = std::filesystem::last_write_time(shard, gone);
    if (!gone && now - written < std::chrono::seconds(recently)) ++count;
  }
  return count;
}

std::string time_left(const verification::StudyStatus& status) {
  const std::size_t left = status.unfinished.entries.size();
  if (left == 0) return "nothing is left to run";
  const double seconds = status.seconds_left();
  if (!std::isfinite(seconds)) {
    return fmt::format("time left: unknown, as no case has ended in the last 10 minutes");
  }
  return fmt::format("time left: {:.0f} s at the rate of the last 10 minutes", seconds);
}

int run_status(const StatusOptions& options) {
  const verification::ClusterFiles files(options.store);
  const auto cases = verification::case_list(options.study, files.folder + "/cases");
  const auto shards = files.shards();
  const auto status = verification::study_status(cases, files.store, shards, std::time(nullptr));
  using verification::CaseStatus;
  const auto count = [&](CaseStatus s) { return status.by_status[static_cast<std::size_t>(s)]; };
  fmt::print("{} cases: {} done, {} broke down, {} refused, {} failed, {} missing\n",
             cases.entries.size(), count(CaseStatus::done), count(CaseStatus::broke_down),
             count(CaseStatus::refused), count(CaseStatus::failed), status.missing);
  if (const auto queue = verification::slurm_queue(files)) {
    fmt::print("Slurm: {} running, {} waiting\n", queue->running, queue->waiting);
  } else {
    fmt::print("no queue to ask: {} of {} shards written in the last minute\n",
               shards_at_work(shards), shards.size());
  }
  fmt::print("{}\n", time_left(status));
  return 0;
}

}  // namespace

void add_status_command(CLI::App& program, Command& run) {
  auto options = std::make_shared<StatusOptions>();
  CLI::App* command = program.add_subcommand("status", "How far a sweep is");
  command->add_option("study", options->study, "Study file (TOML)")->required();
  command->add_option("--store", options->store, "Store of results (SQLite file)")->required();
  command->footer(
      "Reads the store and the shards in STORE.shards, and Slurm's queue if there is one; writes\n"
      "nothing. Ends with 0 however far the sweep is.\n"
      "Example: porowave status verification/studies/smoke.toml --store results");
  command->callback([options, &run] { run = [options] { return run_status(*options); }; });
}

}  // namespace porowave::reports
