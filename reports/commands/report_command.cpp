#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "reports/commands/commands.hpp"
#include "reports/report/report.hpp"

namespace porowave::reports {

namespace {

int run_report(const ReportOptions& options) {
  for (const auto& file : write_report(options)) fmt::print("wrote {}\n", file.string());
  return 0;
}

}  // namespace

void add_report_command(CLI::App& program, Command& run) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* command = program.add_subcommand("report", "A store as figures, tables and a page");
  command->add_option("store", options->store, "Store of results")->required();
  command->add_option("--output", options->output, "Directory for all files; made if missing")
      ->required();
  command->add_option("--study", options->study,
                      "Study file (TOML) of cases in the store: verdicts come first");
  command->add_option("--baseline", options->baseline,
                      "Expected errors and orders (CSV) for the verdicts");
  command->add_option("--compare", options->compare,
                      "Store of the same cases after a change: what got better or worse");
  command->add_option("--measure", options->measure,
                      "Error in the figures, effective_stress_field_l2 if absent");
  command->add_option("--junit", options->junit, "File for the verdicts as JUnit XML");
  command
      ->add_option("--floor-seconds", options->floor_seconds,
                   "CPU time to find out what makes floors, s, by a guess from the store (20)")
      ->check(CLI::Range(0.0, 1e6));
  command
      ->add_option("--runs", options->runs,
                   "Cases run again for pictures of their fields, at most (8; 0: none)")
      ->check(CLI::Range(0, 1000));
  command
      ->add_option("--run-seconds", options->run_seconds,
                   "CPU time for that, s, by a guess from the store (20)")
      ->check(CLI::Range(0.0, 1e6));
  command
      ->add_option("--map-seconds", options->map_seconds,
                   "CPU time for maps of critical time steps, s, by a guess (5; 0: none)")
      ->check(CLI::Range(0.0, 1e6));
  command->footer(
      "Writes index.html (verdicts, figures, tables; needs no server and no network), summary.md\n"
      "for a pull request, every figure as SVG, PDF and PNG with its script and data, and every\n"
      "table as CSV and LaTeX. Some cases are run again for pictures of their fields. Verdicts "
      "are\n"
      "those of porowave gate; the exit code is 0 whatever they are: porowave gate judges.\n"
      "Example: porowave report results --output report");
  command->callback([options, &run] { run = [options] { return run_report(*options); }; });
}

}  // namespace porowave::reports
