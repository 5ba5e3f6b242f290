#include "reports/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace porowave::reports {

Progress::Progress(std::string what, int total)
    : what_(std::move(what)),
      total_(total),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()) {
  show();
}

Progress::~Progress() {
  end();
}

void Progress::set(int done, int total) {
  done_ = done;
  total_ = total;
  show();
}

void Progress::end() {
  if (terminal_) fmt::print(stderr, "\r\033[K");
  terminal_ = false;
}

void Progress::done_one() {
  ++done_;
  show();
}

void Progress::show() const {
  if (!terminal_) return;
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  std::string rate;
  if (done_ > 0) {
    rate = fmt::format(", {:.3g} a second, {:.0f} s left", done_ / seconds,
                       seconds / done_ * (total_ - done_));
  }
  fmt::print(stderr, "\r\033[K{}: {} of {}{}", what_, done_, total_, rate);
  std::fflush(stderr);
}

}  // namespace porowave::reports
