#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>

namespace porowave::reports {

/// Writes a file whole or not at all: the text goes to a new file beside it, which takes the name
/// only when everything is on disk. What is not a regular file (a pipe, a link, /dev/stdout) is
/// written directly. Throws EnvironmentError when it cannot be written.
void write_file(const std::filesystem::path& path,
                const std::function<void(std::ostream&)>& write_contents);
void write_file(const std::filesystem::path& path, const std::string& text);

/// Checks before long work that a file can be written later; leaves nothing behind.
/// Throws EnvironmentError if it cannot.
void require_writable(const std::filesystem::path& file);

/// Makes a directory (and those above it) if it is not there, and checks that files can be written.
/// Throws EnvironmentError if that fails; directories made for nothing are removed again.
void make_output_directory(const std::filesystem::path& directory);

}  // namespace porowave::reports
