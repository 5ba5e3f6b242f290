#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace porowave::reports {

struct ProcessResult {
  int exit_code = 0;  ///< 128 + signal if one ended it
  std::string output;
  std::string errors;
};

/// Runs a program found in PATH, without a shell: arguments reach it as they are. Waits for its end
/// and returns all it wrote. `directory` is where it runs. Throws EnvironmentError if it cannot be
/// started.
ProcessResult run_process(const std::vector<std::string>& command,
                          const std::filesystem::path& directory);

}  // namespace porowave::reports
