#pragma once

// Tables of errors whose order is known, for tests of the estimators.

#include <cmath>
#include <functional>
#include <random>

#include "verification/order/error_table.hpp"

namespace porowave::verification::manufactured {

inline const std::vector<double> halved = {0.1, 0.05, 0.025, 0.0125, 0.00625};
inline const std::vector<double> unequal = {0.1, 0.07, 0.03, 0.025, 0.008};

/// e(h) with one replicate.
inline ErrorTable table_of(const std::vector<double>& spacing,
                           const std::function<double(double)>& error) {
  ErrorTable table{spacing, {}};
  for (const double h : spacing) table.errors.push_back({error(h)});
  return table;
}

/// e(h) times e^(sigma N(0,1)) in `replicates` replicates.
inline ErrorTable noisy_table(const std::vector<double>& spacing,
                              const std::function<double(double)>& error, double sigma,
                              int replicates, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0.0, sigma);
  ErrorTable table{spacing, {}};
  for (const double h : spacing) {
    std::vector<double>& row = table.errors.emplace_back();
    for (int r = 0; r < replicates; ++r) row.push_back(error(h) * std::exp(normal(random)));
  }
  return table;
}

}  // namespace porowave::verification::manufactured
