#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "reports/commands/commands.hpp"
#include "reports/output_file.hpp"
#include "verification/run.hpp"
#include "verification/run_output.hpp"

namespace porowave::reports {

namespace {

struct SolveOptions {
  std::string scene;
  std::string output;
  std::string json;
};

int run_solve(const SolveOptions& options) {
  const solver::Case scene = solver::load_case(options.scene);
  if (!options.output.empty()) require_writable(options.output);
  if (!options.json.empty()) require_writable(options.json);
  const auto profile = verification::reference_profile(scene);
  const auto result = verification::run_and_explain(scene, *profile);
  if (!options.output.empty()) {
    write_file(options.output,
               [&](std::ostream& out) { verification::write_points_csv(result.snapshot, out); });
  }
  if (!options.json.empty()) write_file(options.json, verification::run_json(result));
  fmt::print("{}", verification::run_summary(result));
  for (const auto& file : {options.output, options.json}) {
    if (file.empty()) continue;
    fmt::print("wrote {}{}\n", file, result.breakdown ? ", of a run that broke down" : "");
  }
  if (!result.breakdown) return 0;
  fmt::print(stderr, "porowave: {}: the run broke down: {}\n", options.scene,
             result.breakdown->reason);
  return exit_broke_down;
}

}  // namespace

void add_solve_command(CLI::App& program, Command& run) {
  auto options = std::make_shared<SolveOptions>();
  CLI::App* command =
      program.add_subcommand("solve", "One run of the material point solver, and its errors");
  command->add_option("case", options->scene, "Case file (TOML)")->required();
  command->add_option("--output", options->output, "CSV file for the material points");
  command->add_option("--json", options->json, "JSON file for errors and cost");
  command->footer(
      "All fields stand for time.end. Errors are relative to the reference, at the points and of\n"
      "the reconstructed fields (stresses at cell middles, velocities at nodes).\n"
      "Example: porowave solve verification/studies/paper_case.toml --output points.csv");
  command->callback([options, &run] { run = [options] { return run_solve(*options); }; });
}

}  // namespace porowave::reports
