#include <fmt/format.h>
#include <fmt/ostream.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

#include "reference/cross_check.hpp"
#include "reference/problem/errors.hpp"
#include "reference/route.hpp"
#include "reference/time_slice.hpp"
#include "reports/commands/commands.hpp"
#include "reports/commands/number_list.hpp"
#include "reports/commands/reference_output.hpp"
#include "reports/output_file.hpp"

namespace porowave::reports {

namespace {

struct ReferenceOptions {
  std::string problem;
  std::string x;
  std::string t;
  std::string output;
  bool derived = false;
  bool energy = false;
  std::string method = std::string(name(reference::Method::contour));
  bool cross_check = false;
};

constexpr int exit_disagreement = 1;
constexpr int exit_inconclusive = 3;

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

reference::Route chosen_route(const ReferenceOptions& options, const Problem& problem) {
  const auto& names = reference::method_names;
  const auto index = std::find(names.begin(), names.end(), options.method) - names.begin();
  const auto route = reference::route(static_cast<reference::Method>(index), problem);
  if (!route.obstacle.empty()) {
    throw InputError(fmt::format("{}: {}", options.problem, route.obstacle));
  }
  return route;
}

void print_check(const reference::RouteCheck& check) {
  if (!check.obstacle.empty()) {
    fmt::print("{:<10} not compared: {}\n", check.route, check.obstacle);
    return;
  }
  fmt::print("{:<10} {:>8} {:>14}", check.route, check.compared, check.too_inaccurate);
  if (check.compared > 0) {
    const auto& worst = check.worst;
    fmt::print(" {:>10.2e} {:>10.2e}  {} at x = {:.17g}, t = {:.17g}: {:.17g}, contour {:.17g}",
               worst.difference, worst.allowed, worst.field, worst.x, worst.t, worst.other,
               worst.main);
  }
  fmt::print("\n");
}

/// Compares the routes and prints one line for each; the exit code says whether they agree.
int run_cross_check(const Problem& problem, const std::vector<double>& xs,
                    const std::vector<double>& ts) {
  const auto check = reference::compare_routes(problem, xs, ts);
  fmt::print("{:<10} {:>8} {:>14} {:>10} {:>10}  {}\n", "route", "compared", "too_inaccurate",
             "difference", "allowed", "where (differences are relative to the load)");
  for (const auto& route : check.routes) print_check(route);
  if (!check.agree()) {
    fmt::print("the routes disagree by more than their stated errors\n");
    return exit_disagreement;
  }
  if (check.compared() == 0) {
    fmt::print("no value could be compared\n");
    return exit_inconclusive;
  }
  fmt::print("the routes agree within their stated errors\n");
  return 0;
}

int run_reference(const ReferenceOptions& options) {
  const Problem problem = load_problem(options.problem);
  if (options.energy) {
    return run_energy(problem, parse_number_list(options.t, "--t"), options.output);
  }
  const auto xs = parse_number_list(options.x, "--x");
  const auto ts = parse_number_list(options.t, "--t");
  if (options.cross_check) return run_cross_check(problem, xs, ts);
  const reference::Route route = chosen_route(options, problem);
  if (!options.output.empty()) require_writable(options.output);
  std::vector<Row> rows;
  std::size_t unresolved = 0;
  const reference::ColumnSolution solution(problem);
  for (const double t : ts) {
    const auto fields = route.fields(xs, t);
    reference::TimeSlice integrals(solution, t, reference::TimeIntegral::once);
    for (std::size_t i = 0; i < xs.size(); ++i) {
      rows.push_back({xs[i], t, fields[i], ""});
      if (options.derived) {
        rows.back().more = derived_cells(
            reference::derived_fields(problem.material, fields[i], integrals.at(xs[i])));
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
    fmt::print(
        stderr,
        "porowave: {} of {} values could not be resolved (nan, bound inf): porowave reference "
        "--help names other routes; README.md of reference the limits\n",
        unresolved, rows.size());
  }
  return 0;
}

}  // namespace

void add_reference_command(CLI::App& program, Command& run) {
  auto options = std::make_shared<ReferenceOptions>();
  CLI::App* command = program.add_subcommand(
      "reference", "Exact fields of a saturated column at points and times, with error bounds");
  command->add_option("problem", options->problem, "Problem file (TOML); a case file will do too")
      ->required();
  auto* x = command->add_option("--x", options->x, "Points: FIRST:LAST:COUNT or a comma list, m");
  command->add_option("--t", options->t, "Times: a comma list (or FIRST:LAST:COUNT), s")
      ->required();
  auto* output =
      command->add_option("--output", options->output, "CSV file (standard output if absent)");
  auto* derived = command->add_flag("--derived", options->derived,
                                    "Add total stress, seepage velocity and displacements");
  auto* energy = command->add_flag("--energy", options->energy,
                                   "Settlement and energies per unit area at the times, no points");
  const std::vector<std::string> methods(reference::method_names.begin(),
                                         reference::method_names.end());
  auto* method = command
                     ->add_option("--method", options->method,
                                  "Route to the solution: contour (default; all problems), "
                                  "bromwich (GSL), modal (FFTW; smooth loads)")
                     ->check(CLI::IsMember(methods));
  auto* cross_check = command->add_flag(
      "--cross-check", options->cross_check,
      "Print how far the routes differ; exit code 1 if by more than their errors");
  // Displacements and energies are those of the contour route.
  derived->excludes(method);
  energy->excludes(x)->excludes(derived)->excludes(method);
  cross_check->excludes(method)->excludes(output)->excludes(derived)->excludes(energy);
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
