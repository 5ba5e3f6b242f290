#include "verification/adapters/adapter_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "reference/problem/errors.hpp"
#include "verification/process/process.hpp"
#include "verification/process/scratch_directory.hpp"

namespace porowave::verification {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kept_bytes = 65536;
constexpr std::size_t shown_lines = 5;
constexpr std::size_t shown_bytes = 500;
/// Share of time.end by which a time may differ: rounded in writing, or summed up.
constexpr double time_tolerance = 1e-6;

/// The last lines as one, with | between; bytes that may not be text become ?.
std::string last_lines(const std::string& text) {
  const auto end = text.find_last_not_of(" \t\r\n") + 1;  // 0 if there is nothing
  std::size_t begin = end;
  for (std::size_t lines = 0; begin > 0 && end - begin < shown_bytes; --begin) {
    if (text[begin - 1] == '\n' && ++lines == shown_lines) break;
  }
  std::string line;
  for (const char c : text.substr(begin, end - begin)) {
    if (c == '\n') {
      line += " | ";
    } else if (c != '\r') {
      line += c == '\t' ? ' ' : c < ' ' || c > '~' ? '?' : c;
    }
  }
  return line;
}

void write_text(const fs::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw EnvironmentError(fmt::format("{}: cannot be written", path.string()));
}

/// The case, and beside it the table of its load.
void write_case(const fs::path& directory, const std::string& specification, const Load& load) {
  if (load.shape() != LoadShape::table) {
    write_text(directory / "case.toml", specification);
    return;
  }
  std::string table = "t,value\n";
  for (std::size_t i = 0; i < load.times().size(); ++i) {
    table += fmt::format("{},{}\n", load.times()[i], load.values()[i]);
  }
  write_text(directory / "load.csv", table);
  const auto document = TomlDocument::parse(specification, "case.toml")
                            .with("load", "file", TomlValue{std::string("load.csv")});
  write_text(directory / "case.toml",
             document.canonical({"material", "column", "load", "discretization", "time"}));
}

std::optional<std::string> failure_of(const ProcessResult& process, double time_limit) {
  if (!process.timed_out && process.exit_code == 0) return std::nullopt;
  const std::string reason = process.timed_out ? fmt::format("no end within {:g} s", time_limit)
                                               : fmt::format("exit code {}", process.exit_code);
  // Many programs complain on standard output.
  std::string said = last_lines(process.errors);
  if (said.empty()) said = last_lines(process.output);
  return said.empty() ? reason : reason + ": " + said;
}

void require_time(const PointTable& table, double end) {
  for (const PointProfile& points : table.profiles) {
    if (std::abs(points.time - end) <= time_tolerance * end) continue;
    throw InputError(
        fmt::format("output.csv: t {}: expected {}, time.end of the case", points.time, end));
  }
  if (table.profiles.size() > 1) {
    throw InputError("output.csv: several times: expected the same t in every row");
  }
}

PointProfile read_output(const fs::path& path, const solver::Case& scene) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) {
    throw InputError("output.csv was not written: expected a table of points");
  }
  CsvReader reader = CsvReader::open(path.string(), "output.csv");
  PointReading reading;
  reading.length = solver::ColumnSolver::grid_length(scene);
  if (!reader.find("t")) reading.time = scene.time.end;
  PointTable table = read_points(reader, reading);
  require_time(table, scene.time.end);
  return std::move(table.profiles.front());
}

}  // namespace

AdapterRun run_adapter(const Adapter& adapter, const std::string& specification,
                       const solver::Case& scene, const reference::Profile& reference) {
  const ScratchDirectory scratch;
  const fs::path directory = fs::absolute(scratch.path());
  const fs::path output = directory / "output.csv";
  write_case(directory, specification, scene.problem.load);
  std::vector<std::string> command = adapter.command;
  command.insert(command.end(), {(directory / "case.toml").string(), output.string()});
  const ProcessResult process =
      run_process(command, adapter.directory, {adapter.time_limit, kept_bytes});

  AdapterRun run;
  run.reference_error = reference.error();
  run.cost.cpu_seconds = process.cpu_seconds;
  run.cost.wall_seconds = process.wall_seconds;
  run.cost.peak_rss_bytes = process.peak_rss_bytes;
  run.failure = failure_of(process, adapter.time_limit);
  if (run.failure) return run;
  try {
    const PointProfile points = read_output(output, scene);
    run.points = points.x.size();
    run.errors = point_errors(points, reference);
  } catch (const InputError& error) {
    run.failure = error.what();
  }
  return run;
}

}  // namespace porowave::verification
