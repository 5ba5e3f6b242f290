#include "verification/process/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include "reference/problem/errors.hpp"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to us

namespace porowave::verification {

namespace {

class Pipe {
 public:
  Pipe() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) throw EnvironmentError("no pipe for a child process");
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  int read_end() const { return ends_[0]; }
  int write_end() const { return ends_[1]; }
  void close_write_end() { close_end(1); }

 private:
  void close_end(std::size_t i) {
    if (ends_[i] >= 0) close(ends_[i]);
    ends_[i] = -1;
  }
  std::array<int, 2> ends_{-1, -1};
};

using Clock = std::chrono::steady_clock;

double seconds_of(Clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

/// The child and what it may use.
class Child {
 public:
  Child(pid_t id, const ProcessLimits& limits) : id_(id), limits_(limits) {}
  bool limited() const { return limits_.seconds.has_value(); }
  bool over_time() const {
    return limited() && seconds_of(Clock::now() - begin_) >= *limits_.seconds;
  }
  /// It stays in the table of processes, so that its number is not given to another.
  bool has_ended() const {
    siginfo_t info{};
    return waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           info.si_pid == id_;
  }
  /// Waits without reaping; false if the time was over before.
  bool ends_in_time() const {
    while (limited() && !has_ended()) {
      if (over_time()) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
  }
  void end_group() const { kill(-id_, SIGKILL); }

  void reap(ProcessResult& result) const {
    int status = 0;
    rusage usage{};
    while (wait4(id_, &status, 0, &usage) < 0 && errno == EINTR) {
    }
    const auto seconds = [](const timeval& time) {
      return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    result.wall_seconds = seconds_of(Clock::now() - begin_);
    result.cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    result.peak_rss_bytes = std::int64_t{usage.ru_maxrss} * 1024;  // Linux counts in KiB
  }

 private:
  pid_t id_;
  const ProcessLimits& limits_;
  Clock::time_point begin_ = Clock::now();
};

/// How often an end is looked for while nothing is written.
constexpr int patience_ms = 20;

void append(std::string& text, const char* more, std::size_t count, std::size_t kept) {
  text.append(more, count);
  if (text.size() > kept && text.size() - kept > kept) text.erase(0, text.size() - kept);
}

/// Reads both pipes at once, so that neither can fill up and block the child. False if the time was
/// over before; a child with a limit that has ended need not have closed them (others hold them).
bool read_all(const Pipe& output, const Pipe& errors, const Child& child, std::size_t kept,
              ProcessResult& result) {
  std::array<pollfd, 2> ends = {pollfd{output.read_end(), POLLIN, 0},
                                pollfd{errors.read_end(), POLLIN, 0}};
  std::array<std::string*, 2> texts = {&result.output, &result.errors};
  for (int open = 2; open > 0;) {
    if (child.over_time()) return false;
    const int ready = poll(ends.data(), ends.size(), child.limited() ? patience_ms : -1);
    if (ready == 0 && child.has_ended()) return true;
    if (ready < 0 && errno != EINTR) return true;
    if (ready <= 0) continue;
    for (std::size_t i = 0; i < 2; ++i) {
      if (ends[i].fd < 0 || ends[i].revents == 0) continue;
      std::array<char, 4096> buffer;
      const ssize_t count = read(ends[i].fd, buffer.data(), buffer.size());
      if (count > 0) {
        append(*texts[i], buffer.data(), static_cast<std::size_t>(count), kept);
      } else if (count == 0 || errno != EINTR) {
        ends[i].fd = -1;
        --open;
      }
    }
  }
  return true;
}

pid_t start(const std::vector<std::string>& command, const std::filesystem::path& directory,
            const Pipe& output, const Pipe& errors, bool own_group) {
  std::vector<std::string> owned(command);
  std::vector<char*> arguments;
  for (std::string& argument : owned) arguments.push_back(argument.data());
  arguments.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output.write_end(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, errors.write_end(), STDERR_FILENO);
  posix_spawn_file_actions_addchdir_np(&actions, directory.c_str());
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  if (own_group) posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t child = 0;
  const int failed =
      posix_spawnp(&child, arguments[0], &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (failed == 0) return child;
  throw EnvironmentError(fmt::format("{}: cannot be started: {}; expected it installed and in PATH",
                                     command[0], std::strerror(failed)));
}

std::string last_bytes(std::string text, std::size_t kept) {
  return text.size() > kept ? text.substr(text.size() - kept) : text;
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& command,
                          const std::filesystem::path& directory, const ProcessLimits& limits) {
  Pipe output;
  Pipe errors;
  const Child child(start(command, directory, output, errors, limits.seconds.has_value()), limits);
  output.close_write_end();
  errors.close_write_end();

  ProcessResult result;
  result.timed_out = !read_all(output, errors, child, limits.kept, result) || !child.ends_in_time();
  if (child.limited()) child.end_group();
  child.reap(result);
  result.output = last_bytes(std::move(result.output), limits.kept);
  result.errors = last_bytes(std::move(result.errors), limits.kept);
  return result;
}

}  // namespace porowave::verification
