#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace porowave::verification {

/// What a program may use. With a time limit it becomes the head of a process group of its own, and
/// nothing of that group outlives it (what it starts in groups or sessions of their own may).
struct ProcessLimits {
  std::optional<double> seconds = {};  ///< of wall time, > 0
  /// Bytes kept of each stream, the last ones.
  std::size_t kept = std::numeric_limits<std::size_t>::max();
};

struct ProcessResult {
  int exit_code = 0;       ///< 128 + signal if one ended it
  bool timed_out = false;  ///< it was ended for having reached its limit
  std::string output;
  std::string errors;
  double wall_seconds = 0.0;
  double cpu_seconds = 0.0;         ///< of it and of the programs it waited for
  std::int64_t peak_rss_bytes = 0;  ///< of the largest of these
};

/// Runs a program found in PATH, without a shell: arguments reach it as they are. Waits for its end
/// and returns all it wrote. `directory` is where it runs; its standard input is empty. Throws
/// EnvironmentError if it cannot be started. May be used by several threads at a time.
ProcessResult run_process(const std::vector<std::string>& command,
                          const std::filesystem::path& directory, const ProcessLimits& limits = {});

}  // namespace porowave::verification
