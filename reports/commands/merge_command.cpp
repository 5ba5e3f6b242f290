#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "reference/problem/errors.hpp"
#include "reports/commands/commands.hpp"
#include "verification/store/store.hpp"

namespace porowave::reports {

namespace {

struct MergeOptions {
  std::string target;
  std::vector<std::string> sources;
};

int run_merge(const MergeOptions& options) {
  // What is no store is refused before anything is written.
  std::vector<std::string> sources;
  for (const std::string& source : options.sources) {
    std::error_code none;
    if (std::filesystem::equivalent(source, options.target, none)) {
      throw InputError(source + ": is the store that takes the rows: expected others");
    }
    // All that a sweep killed while it made its store has left.
    if (std::filesystem::is_regular_file(source, none) && std::filesystem::is_empty(source, none)) {
      fmt::print("{} is empty: no rows\n", source);
      continue;
    }
    verification::Store::open(source);
    sources.push_back(source);
  }
  // A new store may lie on a network file system: the merging job of a cluster makes it.
  auto store =
      verification::Store::create_or_open(options.target, verification::Store::Journal::rollback);
  const std::size_t before = store.count();
  for (const std::string& source : sources) store.merge(source);
  fmt::print("{} rows, {} of them new\nwrote {}\n", store.count(), store.count() - before,
             options.target);
  return 0;
}

}  // namespace

void add_merge_command(CLI::App& program, Command& run) {
  auto options = std::make_shared<MergeOptions>();
  CLI::App* command = program.add_subcommand("merge", "Put the rows of several stores into one");
  command->add_option("target", options->target, "Store that takes them; made if it is not there")
      ->required();
  command->add_option("sources", options->sources, "Stores of shards")->required();
  command->footer(
      "Rows are keyed by case: a row that is there already stays, so merging again changes "
      "nothing.\n"
      "Example: porowave merge results shard1 shard2");
  command->callback([options, &run] { run = [options] { return run_merge(*options); }; });
}

}  // namespace porowave::reports
