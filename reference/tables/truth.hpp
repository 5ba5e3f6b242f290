#pragma once

#include <string>
#include <vector>

#include "reference/problem/problem.hpp"

/// The truth tables beside this file, for tests.
namespace porowave::fixtures {

struct TruthRow {
  std::string id;
  Problem problem;
  double x;
  double t;
  Fields value;        ///< for a load of 1 Pa
  double uncertainty;  ///< of the row itself, relative to the load: 10^-digits
};

/// All rows of truth_step.csv or truth_smooth.csv. Throws InputError if a row cannot be read.
std::vector<TruthRow> read_truth(const std::string& path);

}  // namespace porowave::fixtures
