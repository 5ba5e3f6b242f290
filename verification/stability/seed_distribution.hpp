#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "verification/stability/stability_map.hpp"

namespace porowave::verification {

/// Critical Courant numbers of the cases of a study that differ in discretization.seed alone.
struct SeedDistribution {
  std::vector<TomlValue> coordinates;  ///< on the other axes of the study, in their order
  std::vector<double> courant;         ///< ascending; 0 where no sample is stable; without refused
  int refused = 0;                     ///< seeds whose points cannot be run
  int unlimited = 0;                   ///< seeds stable up to the highest sample
  std::string worst_seed;              ///< of the least; of several that whose noise grows most

  /// Of share 0 ... 1 of the seeds that can be run: the least value that at least that share does
  /// not exceed. NaN if none can be run.
  double quantile(double share) const;
};

/// One a combination of the values of the axes other than the seeds, in the order of the first case
/// of each. Throws std::invalid_argument for a study without an axis of seeds.
std::vector<SeedDistribution> seed_distributions(const Study& study,
                                                 const std::vector<MappedStability>& map);

/// One row a distribution: the study's axes but the seeds, then seeds, refused, unstable_at_every
/// (seeds without a stable sample), stable_to_highest, critical_least, critical_05, critical_25,
/// critical_50, critical_75, critical_95 (quantiles; empty if no seed can be run), worst_seed.
void write_seed_csv(const Study& study, const std::vector<SeedDistribution>& distributions,
                    std::ostream& out);

}  // namespace porowave::verification
