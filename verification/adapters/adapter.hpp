#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "reference/problem/toml_document.hpp"

namespace porowave::verification {

/// Another solver that runs the cases of a study, as a program of its own:
///
///   [adapter] command = ["./my_solver", "--fast"]   run as ./my_solver --fast CASE.toml OUTPUT.csv
///             time_limit = 60                       s of wall time for one case
///
/// A program with a slash in its name is found from the study's folder, any other in PATH; it runs
/// in the study's folder. No shell comes in between.
struct Adapter {
  std::vector<std::string> command;  ///< at least the program
  double time_limit = 60.0;          ///< s, > 0
  std::filesystem::path directory;   ///< where it runs
  /// Hash of the command, the time limit, and the content of the program and of every file that the
  /// command names.
  std::string identity;

  std::string toml() const;  ///< the table [adapter]
};

/// Reads [adapter]; none if there is no such table. Throws InputError, also for a program that
/// cannot be found.
std::optional<Adapter> read_adapter(const TomlDocument& document);

}  // namespace porowave::verification
