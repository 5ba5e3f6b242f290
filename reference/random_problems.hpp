#pragma once

#include <cmath>
#include <random>

#include "reference/problem/problem.hpp"

/// Random problems for tests: the ranges of real soils and rocks.
namespace porowave::fixtures {

class RandomProblems {
 public:
  explicit RandomProblems(unsigned seed) : generator_(seed) {}

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }
  double log_uniform(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }
  int index(int count) { return std::uniform_int_distribution<int>(0, count - 1)(generator_); }

  /// The permeability is chosen for relaxation_rate * length/P1 speed = stiffness.
  Problem next(double stiffness, const Load& load, NearEnd near, FarEnd far) {
    Material m{uniform(0.15, 0.6),
               uniform(2000, 3200),
               uniform(800, 1300),
               log_uniform(1e7, 2e10),
               log_uniform(3e8, 3e9),
               1.0,
               1e-3};
    const double length = log_uniform(0.05, 10.0);
    m.intrinsic_permeability = m.relaxation_rate() * length / wave_speeds(m).p1 / stiffness;
    Column column{length, near, far};
    if (far == FarEnd::half_space) column.length.reset();
    return {m, column, load};
  }

 private:
  std::mt19937 generator_;
};

}  // namespace porowave::fixtures
