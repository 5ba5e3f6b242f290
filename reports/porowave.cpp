// The program: parses the command line, runs one command, turns failures into exit codes.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>

#include "reference/problem/errors.hpp"
#include "reports/commands/commands.hpp"

namespace {

std::string not_empty(const std::string& text) {
  return text.empty() ? "expected a value that is not empty" : "";
}

enum ExitCode { done = 0, wrong_input = 2, broke_down = 4, environment = 5 };

int fail(ExitCode code, const char* message) {
  fmt::print(stderr, "porowave: {}\n", message);
  return code;
}

/// One line that says what was wrong and where help is.
std::string wrong_usage(const CLI::App& program, const CLI::ParseError& error) {
  const auto chosen = program.get_subcommands();
  if (!chosen.empty()) {
    return fmt::format("{}; porowave {} --help shows an example", error.what(),
                       chosen.front()->get_name());
  }
  std::vector<std::string> commands;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    commands.push_back(command->get_name());
  }
  const auto words = program.remaining();
  return fmt::format("{}: expected one of the commands {}; porowave --help explains them",
                     words.empty() ? "no command" : words.front(), fmt::join(commands, ", "));
}

/// What was printed counts only when it has arrived (the disk may be full).
void flush_standard_output() {
  errno = 0;
  std::cout.flush();
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  throw porowave::EnvironmentError(
      fmt::format("standard output: cannot be written: {}; expected a disk with space",
                  errno != 0 ? std::strerror(errno) : "writing failed"));
}

int run(int argc, char** argv) {
  CLI::App program("Verification and convergence harness for coupled material point methods");
  program.name("porowave");
  program.set_version_flag("--version", "porowave " POROWAVE_VERSION);
  program.require_subcommand(1);
  program.fallthrough(false);
  program.footer(
      "porowave COMMAND --help shows an example.\n"
      "Exit codes: 0 done, 1 verdict fail, 2 wrong usage or input, 3 verdict inconclusive,\n"
      "4 the run broke down, 5 environment.");
  porowave::reports::Command command;
  porowave::reports::add_reference_command(program, command);
  porowave::reports::add_explain_command(program, command);
  porowave::reports::add_waves_command(program, command);
  porowave::reports::add_solve_command(program, command);
  porowave::reports::add_sweep_command(program, command);
  porowave::reports::add_status_command(program, command);
  porowave::reports::add_merge_command(program, command);
  porowave::reports::add_gate_command(program, command);
  porowave::reports::add_report_command(program, command);
  porowave::reports::add_grade_command(program, command);
  porowave::reports::add_stability_command(program, command);
  porowave::reports::add_demo_command(program, command);
  for (CLI::App* sub : program.get_subcommands({})) {
    sub->set_version_flag("--version", "porowave " POROWAVE_VERSION);
    // What a script's unset variable gives must not pass for an option that is absent.
    for (CLI::Option* option : sub->get_options()) {
      if (option->get_items_expected_max() > 0) option->check(not_empty);
    }
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) return fail(wrong_input, wrong_usage(program, error).c_str());
    program.exit(error);  // --help and --version
    flush_standard_output();
    return done;
  }
  const int code = command();
  flush_standard_output();
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const porowave::InputError& error) {
    return fail(wrong_input, error.what());
  } catch (const porowave::BreakdownError& error) {
    return fail(broke_down, error.what());
  } catch (const porowave::EnvironmentError& error) {
    return fail(environment, error.what());
  } catch (const std::bad_alloc&) {
    return fail(environment, "out of memory; expected a smaller scene or a larger machine");
  } catch (const std::exception& error) {
    return fail(environment, error.what());
  }
}
