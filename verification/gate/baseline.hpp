#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "verification/order/order_estimate.hpp"

namespace porowave::verification {

/// What one measure of one group was when the baseline was made.
struct Expected {
  std::string seeds;             ///< "1 2 3": which replicates the means are of
  std::vector<double> spacing;   ///< of the levels
  std::vector<double> mean_log;  ///< mean of log error over the seeds
  std::vector<double> sd_log;    ///< standard deviation of log error, 0 with one seed
  int replicates = 1;
  double order = 0.0;       ///< NaN if none was observed
  double order_half = 0.0;  ///< half the width of its interval
};

/// Expected errors and orders of a study, and why they are what they are. A CSV file: lines
/// "# date: reason", then group,measure,seeds,replicates,order,order_half,spacing,mean_log,sd_log
/// with one row a level.
struct Baseline {
  std::vector<std::string> history;  ///< "2026-11-22: reason", the oldest first
  std::map<std::pair<std::string, std::string>, Expected> expected;  ///< by group and measure
};

/// Throws InputError (file, line, what was expected).
Baseline read_baseline(const std::string& path);
/// The same of text; `path` is only the name used in messages.
Baseline baseline_of_text(const std::string& text, const std::string& path);
std::string baseline_text(const Baseline& baseline);

}  // namespace porowave::verification
