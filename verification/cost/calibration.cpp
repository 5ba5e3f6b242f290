#include "verification/cost/calibration.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <limits>

namespace porowave::verification {

namespace {

constexpr std::size_t points = 1024;
constexpr int sweeps = 100;
using Field = std::array<double, points>;

double thread_nanoseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

void smooth(const Field& from, Field& to) {
  for (std::size_t i = 2; i + 2 < points; ++i) {
    to[i] = 0.4 * from[i] + 0.2 * (from[i - 1] + from[i + 1]) + 0.1 * (from[i - 2] + from[i + 2]);
  }
}

double one_measurement(Field& a, Field& b) {
  const double start = thread_nanoseconds();
  for (int k = 0; k < sweeps; k += 2) {
    smooth(a, b);
    smooth(b, a);
  }
  return (thread_nanoseconds() - start) / (sweeps * static_cast<double>(points));
}

}  // namespace

double calibration_nanoseconds() {
  Field a;
  Field b;
  for (std::size_t i = 0; i < points; ++i) a[i] = b[i] = static_cast<double>(i % 7);
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) best = std::min(best, one_measurement(a, b));
  // A sum that nobody can leave out: what is never negative is added once more if it were.
  const volatile double sum = a[points / 2];
  return sum < 0.0 ? 2.0 * best : best;
}

double recent_calibration_nanoseconds() {
  using Clock = std::chrono::steady_clock;
  thread_local double value = 0.0;
  thread_local Clock::time_point measured;
  const Clock::time_point now = Clock::now();
  if (value == 0.0 || now - measured > std::chrono::milliseconds(500)) {
    value = calibration_nanoseconds();
    measured = now;
  }
  return value;
}

}  // namespace porowave::verification
