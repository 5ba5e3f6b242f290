#pragma once

#include <chrono>
#include <string>

namespace porowave::reports {

/// Progress of long work on standard error: one line that is rewritten on a terminal (done, rate,
/// time left), nothing in a pipe.
class Progress {
 public:
  Progress(std::string what, int total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void done_one();
  void set(int done, int total);
  void end();  ///< clears the line; nothing is shown any more

 private:
  void show() const;

  std::string what_;
  int total_;
  int done_ = 0;
  bool terminal_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace porowave::reports
