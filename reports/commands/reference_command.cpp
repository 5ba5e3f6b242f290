#include <fmt/format.h>
#include <fmt/ostream.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <memory>

#include "reference/column_solution.hpp"
#include "reports/commands/commands.hpp"
#include "reports/commands/number_list.hpp"
#include "reports/output_file.hpp"

namespace porowave::reports {

namespace {

struct Options {
  std::string problem;
  std::string x;
  std::string t;
  std::string output;
};

struct Row {
  double x;
  double t;
  reference::BoundedFields fields;
};

void write_csv(const std::vector<Row>& rows, std::ostream& out) {
  out << "x,t,effective_stress,pore_pressure,solid_velocity,fluid_velocity,effective_stress_error,"
         "pore_pressure_error,solid_velocity_error,fluid_velocity_error\n";
  for (const Row& row : rows) {
    const Fields& v = row.fields.value;
    const Fields& e = row.fields.error;
    fmt::print(out, "{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.3g},{:.3g},{:.3g},{:.3g}\n",
               row.x, row.t, v.effective_stress, v.pore_pressure, v.solid_velocity,
               v.fluid_velocity, e.effective_stress, e.pore_pressure, e.solid_velocity,
               e.fluid_velocity);
  }
}

int run_reference(const Options& options) {
  const Problem problem = load_problem(options.problem);
  const auto xs = parse_number_list(options.x, "--x");
  const auto ts = parse_number_list(options.t, "--t");
  if (!options.output.empty()) require_writable(options.output);
  const reference::ColumnSolution solution(problem);
  std::vector<Row> rows;
  std::size_t unresolved = 0;
  for (const double t : ts) {
    for (const double x : xs) {
      rows.push_back({x, t, solution.at(x, t)});
      if (!std::isfinite(rows.back().fields.error.effective_stress)) ++unresolved;
    }
  }
  if (options.output.empty()) {
    write_csv(rows, std::cout);
  } else {
    write_file(options.output, [&](std::ostream& out) { write_csv(rows, out); });
    fmt::print("wrote {}\n", options.output);
  }
  if (unresolved > 0) {
    fmt::print(stderr,
               "porowave: {} of {} values could not be resolved (nan, bound inf): the drag is too "
               "stiff for this version\n",
               unresolved, rows.size());
  }
  return 0;
}

}  // namespace

void add_reference_command(CLI::App& program, Command& run) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "reference", "Exact fields of a saturated column at points and times, with error bounds");
  command->add_option("problem", options->problem, "Problem file (TOML); a case file will do too")
      ->required();
  command->add_option("--x", options->x, "Points: FIRST:LAST:COUNT or a comma list, m")->required();
  command->add_option("--t", options->t, "Times: a comma list (or FIRST:LAST:COUNT), s")
      ->required();
  command->add_option("--output", options->output, "CSV file (standard output if absent)");
  command->footer(
      "Columns: x,t, the four fields, and a bound for the error of each (same unit).\n"
      "Example: porowave reference verification/studies/paper_problem.toml --x 0:0.1:101 --t 4e-5");
  command->callback([options, &run] { run = [options] { return run_reference(*options); }; });
}

}  // namespace porowave::reports
