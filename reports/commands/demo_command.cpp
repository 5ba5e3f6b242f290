#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>

#include "reports/commands/commands.hpp"
#include "reports/demo.hpp"

namespace porowave::reports {

void add_demo_command(CLI::App& program, Command& run) {
  auto output = std::make_shared<std::string>("porowave-demo");
  CLI::App* command = program.add_subcommand(
      "demo", "The paper's study: its Figures 3, 4 and 5 and the convergence of the scheme");
  command->add_option("--output", *output, "Directory for pictures and tables")
      ->capture_default_str();
  command->footer("Takes some ten seconds.\nExample: porowave demo --output porowave-demo");
  command->callback([output, &run] {
    run = [output] {
      const auto start = std::chrono::steady_clock::now();
      const auto files = run_demo(*output);
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
      fmt::print("wrote in {:.1f} s:\n", seconds.count());
      for (const auto& file : files) fmt::print("  {}\n", file.string());
      return 0;
    };
  });
}

}  // namespace porowave::reports
