#include "reports/output_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

#include "reference/problem/errors.hpp"

namespace porowave::reports {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, const char* reason) {
  throw EnvironmentError(
      fmt::format("{}: cannot be written: {}; expected a path where this user "
                  "may create files and a disk with space",
                  path.string(), reason));
}

/// A name beside the file that no other process uses.
fs::path temporary_beside(const fs::path& path) {
  fs::path name = path;
  name += fmt::format(".{}.tmp", getpid());
  return name;
}

/// A link too: its name must go on leading to the same file (/dev/stdout is a link).
bool written_directly(const fs::path& path) {
  std::error_code error;
  const auto status = fs::symlink_status(path, error);
  return fs::exists(status) && !fs::is_regular_file(status);
}

void refuse_directory(const fs::path& path) {
  std::error_code ignored;  // what else is wrong with the path shows when it is opened
  if (fs::is_directory(path, ignored)) fail(path, "it is a directory");
}

/// Removes the temporary file unless it has got its final name.
struct Cleanup {
  fs::path path;
  ~Cleanup() {
    std::error_code ignored;
    if (!path.empty()) fs::remove(path, ignored);
  }
};

/// Writes to `place`; messages name the path that the user knows.
void write_to(const fs::path& place, const fs::path& path,
              const std::function<void(std::ostream&)>& write_contents) {
  errno = 0;
  std::ofstream out(place, std::ios::binary);
  if (!out) fail(path, std::strerror(errno));
  write_contents(out);
  out.close();
  if (!out) fail(path, errno != 0 ? std::strerror(errno) : "writing failed");
}

}  // namespace

void write_file(const fs::path& path, const std::function<void(std::ostream&)>& write_contents) {
  refuse_directory(path);
  if (written_directly(path)) return write_to(path, path, write_contents);
  Cleanup temporary{temporary_beside(path)};
  write_to(temporary.path, path, write_contents);
  std::error_code error;
  fs::rename(temporary.path, path, error);
  if (error) fail(path, error.message().c_str());
  temporary.path.clear();
}

void write_file(const fs::path& path, const std::string& text) {
  write_file(path, [&](std::ostream& out) { out << text; });
}

void require_writable(const fs::path& file) {
  refuse_directory(file);
  if (written_directly(file)) return;
  const Cleanup probe{temporary_beside(file)};
  write_to(probe.path, file, [](std::ostream& out) { out << "probe"; });
}

void make_output_directory(const fs::path& directory) {
  std::error_code error;
  std::vector<fs::path> missing;  // the innermost first
  for (fs::path path = directory; !path.empty(); path = path.parent_path()) {
    if (fs::exists(fs::symlink_status(path, error))) break;
    missing.push_back(path);
  }
  try {
    fs::create_directories(directory, error);
    if (error) fail(directory, error.message().c_str());
    if (!fs::is_directory(directory)) fail(directory, "it is not a directory");
    const Cleanup probe{directory / fmt::format("probe.{}.tmp", getpid())};
    write_to(probe.path, directory, [](std::ostream& out) { out << "probe"; });
  } catch (const EnvironmentError&) {
    for (const fs::path& made : missing) fs::remove(made, error);
    throw;
  }
}

}  // namespace porowave::reports
