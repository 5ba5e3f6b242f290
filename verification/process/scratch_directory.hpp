#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include "reference/problem/errors.hpp"

namespace porowave::verification {

/// A new, empty directory, removed with all that is in it. Throws EnvironmentError if there is none
/// to be had.
class ScratchDirectory {
 public:
  ScratchDirectory() {
    std::string name = (std::filesystem::temp_directory_path() / "porowave-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
      throw EnvironmentError(name + ": cannot be made: expected a directory for temporary files");
    }
    path_ = name;
  }
  ~ScratchDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;

  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

}  // namespace porowave::verification
