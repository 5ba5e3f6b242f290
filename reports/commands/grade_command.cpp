#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "reference/problem/errors.hpp"
#include "reports/commands/commands.hpp"
#include "reports/output_file.hpp"
#include "verification/grade/grade.hpp"

namespace porowave::reports {

namespace {

struct GradeOptions {
  std::string profile;
  std::string problem;
  std::string json;
  std::vector<std::string> columns;
  std::optional<double> time;
};

/// Out of "quantity=name" each.
verification::ColumnNames column_names(const std::vector<std::string>& words) {
  const std::vector<std::string> known(verification::point_quantities.begin(),
                                       verification::point_quantities.end());
  verification::ColumnNames names;
  for (const std::string& word : words) {
    const auto equals = word.find('=');
    const std::string quantity = word.substr(0, equals);
    if (equals == std::string::npos || equals + 1 == word.size()) {
      throw InputError(fmt::format("--column {}: expected QUANTITY=NAME", word));
    }
    if (std::find(known.begin(), known.end(), quantity) == known.end()) {
      throw InputError(fmt::format("--column {}: unknown quantity {}; {}", word, quantity,
                                   suggestion(quantity, known)));
    }
    if (!names.emplace(quantity, word.substr(equals + 1)).second) {
      throw InputError(fmt::format("--column {}: expected {} only once", word, quantity));
    }
  }
  return names;
}

int run_grade(const GradeOptions& options) {
  const Range times{0.0};
  if (options.time && !times.contains(*options.time)) {
    throw InputError(fmt::format("--time {:g}: expected {}", *options.time, times.text()));
  }
  const verification::ColumnNames names = column_names(options.columns);
  const Problem problem = load_problem(options.problem);
  if (!options.json.empty()) require_writable(options.json);
  auto reader = CsvReader::open(options.profile);
  const auto table =
      verification::read_points(reader, {names, options.time, problem.column.length});
  const auto grades = verification::grade(problem, table);
  if (!options.json.empty()) {
    write_file(options.json, verification::grade_json(grades, table.has_volume));
  }
  fmt::print("{}", verification::grade_summary(grades, table));
  if (!options.json.empty()) fmt::print("wrote {}\n", options.json);
  return 0;
}

}  // namespace

void add_grade_command(CLI::App& program, Command& run) {
  auto options = std::make_shared<GradeOptions>();
  CLI::App* command =
      program.add_subcommand("grade", "Errors of another code's output against the reference");
  command->add_option("profile", options->profile, "CSV file of points with a header")->required();
  command->add_option("--problem", options->problem, "Problem file (TOML); a case file will do too")
      ->required();
  command->add_option("--json", options->json, "JSON file for the errors");
  command
      ->add_option("--column", options->columns,
                   "QUANTITY=NAME: the column NAME holds that quantity; may be repeated")
      ->allow_extra_args(false);
  command->add_option("--time", options->time, "Time of all rows, s, if there is no column t");
  command->footer(
      "Columns: x (m from the loaded end), t (s; several times are judged each by itself), and "
      "any\n"
      "of effective_stress, pore_pressure, solid_velocity, fluid_velocity (Pa, m/s; stress "
      "positive\n"
      "in tension, pressure in compression). Norms weight the rows by a column volume (or weight)\n"
      "if there is one, else equally. The points.csv of porowave solve can be read too. Errors "
      "are\n"
      "relative: each norm is divided by the same norm of the exact field.\n"
      "Example: porowave grade verification/studies/peer_profile.csv --problem "
      "verification/studies/peer_problem.toml");
  command->callback([options, &run] { run = [options] { return run_grade(*options); }; });
}

}  // namespace porowave::reports
