#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "reference/explanation.hpp"
#include "reference/problem/errors.hpp"
#include "reports/commands/commands.hpp"
#include "reports/contour_figure.hpp"

namespace porowave::reports {

namespace {

struct ExplainOptions {
  std::string problem;
  double x = 0.0;
  double t = 0.0;
  std::string output;
};

void print_groups(const reference::ColumnSolution& solution, const ExplainOptions& options) {
  const auto groups = reference::explain(solution, options.x, options.t);
  if (groups.empty()) {
    fmt::print("no wave has arrived at x = {} m by t = {} s: all fields are exactly zero\n",
               options.x, options.t);
    return;
  }
  fmt::print("drag rate × time {:.3g}\n", solution.modes().relaxation_rate() * options.t);
  fmt::print("waves  oldest (s)   opening  right end × t  height    bound\n");
  for (const auto& group : groups) {
    fmt::print("{:5}  {:<11.4g}  {:4.0f}°    {:<13.4g}  {:<8.2g}  {:.1g}\n", group.waves,
               group.oldest, group.choice.contour.angle * 57.29577951308232,
               group.choice.contour.rightmost() * options.t, group.choice.height, group.bound);
  }
}

int run_explain(const ExplainOptions& options) {
  const Problem problem = load_problem(options.problem);
  if (!options.output.empty()) require_gnuplot();
  const reference::ColumnSolution solution(problem);
  print_groups(solution, options);
  if (options.output.empty()) return 0;
  const std::string title = fmt::format("x = {:g} m, t = {:g} s", options.x, options.t);
  const Figure figure = contour_figure("contour", "How the reference inverts this value",
                                       {{title, problem, options.x, options.t}});
  std::filesystem::create_directories(options.output);
  for (const auto& path : draw(figure, options.output)) fmt::print("wrote {}\n", path.string());
  return 0;
}

}  // namespace

void add_explain_command(CLI::App& program, Command& run) {
  auto options = std::make_shared<ExplainOptions>();
  CLI::App* command = program.add_subcommand(
      "explain", "How a value of the reference was found: waves, contours, bounds, and a picture");
  command->add_option("problem", options->problem, "Problem file (TOML); a case file will do too")
      ->required();
  command->add_option("--x", options->x, "Place, m")->required();
  command->add_option("--t", options->t, "Time, s")->required();
  command->add_option("--output", options->output, "Directory for the picture of the s plane");
  command->footer(
      "Example: porowave explain verification/studies/paper_problem.toml --x 0.05 --t 4e-5 "
      "--output explained");
  command->callback([options, &run] { run = [options] { return run_explain(*options); }; });
}

}  // namespace porowave::reports
