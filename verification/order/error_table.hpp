#pragma once

#include <vector>

namespace porowave::verification {

/// Errors of one quantity over refinement levels (coarse to fine) and replicates (seeds), the same
/// seeds in every level: errors[level][replicate]. A case that is missing or has broken down is
/// NaN.
struct ErrorTable {
  std::vector<double> spacing;              ///< h of every level, strictly falling, > 0
  std::vector<std::vector<double>> errors;  ///< > 0, all levels with the same number of replicates

  std::size_t levels() const { return spacing.size(); }
  std::size_t replicates() const { return errors.empty() ? 0 : errors.front().size(); }
};

/// Throws std::invalid_argument unless the table is as described above (values may be anything).
void require_well_formed(const ErrorTable& table);

/// Mean of the logarithms of the errors of every level, and the variance of that mean (0 with one
/// replicate). NaN where an error is not positive and finite.
struct LogMeans {
  std::vector<double> log_spacing;
  std::vector<double> mean;
  std::vector<double> variance;
};
LogMeans log_means(const ErrorTable& table);

/// The same levels [first, table.levels()) of the replicates named by `columns` (repeats allowed).
ErrorTable resampled(const ErrorTable& table, std::size_t first,
                     const std::vector<std::size_t>& columns);

}  // namespace porowave::verification
