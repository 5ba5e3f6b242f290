#include <fmt/format.h>
#include <fmt/ostream.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <memory>

#include "reference/column_solution.hpp"
#include "reference/time_slice.hpp"
#include "reports/commands/commands.hpp"
#include "reports/commands/number_list.hpp"
#include "reports/commands/reference_output.hpp"
#include "reports/output_file.hpp"

namespace porowave::reports {

namespace {

struct Options {
  std::string problem;
  std::string x;
  std::string t;
  std::string output;
  bool derived = false;
  bool energy = false;
};

struct Row {
  double x;
  double t;
  reference::BoundedFields fields;
  std::string more;  ///< cells of further columns
};

void write_csv(const std::vector<Row>& rows, const std::string& more_header, std::ostream& out) {
  out << "x,t,effective_stress,pore_pressure,solid_velocity,fluid_velocity,effective_stress_error,"
         "pore_pressure_error,solid_velocity_error,fluid_velocity_error"
      << more_header << '\n';
  for (const Row& row : rows) {
    const Fields& v = row.fields.value;
    const Fields& e = row.fields.error;
    fmt::print(
        out, "{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.3g},{:.3g},{:.3g},{:.3g}{}\n",
        row.x, row.t, v.effective_stress, v.pore_pressure, v.solid_velocity, v.fluid_velocity,
        e.effective_stress, e.pore_pressure, e.solid_velocity, e.fluid_velocity, row.more);
  }
}

int run_reference(const Options& options) {
  const Problem problem = load_problem(options.problem);
  if (options.energy) {
    return run_energy(problem, parse_number_list(options.t, "--t"), options.output);
  }
  const auto xs = parse_number_list(options.x, "--x");
  const auto ts = parse_number_list(options.t, "--t");
  if (!options.output.empty()) require_writable(options.output);
  const reference::ColumnSolution solution(problem);
  std::vector<Row> rows;
  std::size_t unresolved = 0;
  for (const double t : ts) {
    reference::TimeSlice integrals(solution, t, reference::TimeIntegral::once);
    for (const double x : xs) {
      rows.push_back({x, t, solution.at(x, t), ""});
      if (options.derived) {
        rows.back().more = derived_cells(
            reference::derived_fields(problem.material, rows.back().fields, integrals.at(x)));
      }
      if (!std::isfinite(rows.back().fields.error.effective_stress)) ++unresolved;
    }
  }
  const std::string more_header = options.derived ? derived_header : "";
  if (options.output.empty()) {
    write_csv(rows, more_header, std::cout);
  } else {
    write_file(options.output, [&](std::ostream& out) { write_csv(rows, more_header, out); });
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
  auto* x = command->add_option("--x", options->x, "Points: FIRST:LAST:COUNT or a comma list, m");
  command->add_option("--t", options->t, "Times: a comma list (or FIRST:LAST:COUNT), s")
      ->required();
  command->add_option("--output", options->output, "CSV file (standard output if absent)");
  auto* derived = command->add_flag("--derived", options->derived,
                                    "Add total stress, seepage velocity and displacements");
  auto* energy = command->add_flag("--energy", options->energy,
                                   "Settlement and energies per unit area at the times, no points");
  energy->excludes(x)->excludes(derived);
  command->footer(
      "Columns: x,t, the four fields, and a bound for the error of each (same unit).\n"
      "--energy: t,settlement,work,kinetic_energy,elastic_energy,dissipated_energy (J/m^2).\n"
      "Example: porowave reference verification/studies/paper_problem.toml --x 0:0.1:101 --t 4e-5");
  command->callback([options, x, &run] {
    if (!options->energy && x->count() == 0) throw CLI::RequiredError("--x");
    run = [options] { return run_reference(*options); };
  });
}

}  // namespace porowave::reports
