#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace porowave::verification {

/// Random choices that a seed repeats on every machine.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : generator_(seed) {}

  /// Even in [low, high); from the upper bits, the same everywhere.
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(generator_() >> 11) * 0x1p-53;
  }
  /// Its logarithm is even; 0 < low < high.
  double log_between(double low, double high) {
    return std::exp(between(std::log(low), std::log(high)));
  }
  /// Both ends included.
  int integer(int first, int last) {
    return first + static_cast<int>(between(0.0, last - first + 1.0));
  }
  bool chance(double share) { return between(0.0, 1.0) < share; }

 private:
  std::mt19937_64 generator_;
};

}  // namespace porowave::verification
