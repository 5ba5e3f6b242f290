#include "verification/order/error_table.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace porowave::verification {

void require_well_formed(const ErrorTable& table) {
  if (table.errors.size() != table.levels()) {
    throw std::invalid_argument("error table: expected one row of errors a level");
  }
  for (std::size_t i = 0; i < table.levels(); ++i) {
    if (!(table.spacing[i] > 0.0) || (i > 0 && !(table.spacing[i] < table.spacing[i - 1]))) {
      throw std::invalid_argument(
          "error table: expected positive spacings, falling level by level");
    }
    if (table.errors[i].empty() || table.errors[i].size() != table.replicates()) {
      throw std::invalid_argument("error table: expected the same replicates in every level");
    }
  }
}

LogMeans log_means(const ErrorTable& table) {
  require_well_formed(table);
  LogMeans result;
  const auto n = static_cast<double>(table.replicates());
  for (std::size_t i = 0; i < table.levels(); ++i) {
    double sum = 0.0;
    for (const double e : table.errors[i]) {
      sum += e > 0.0 && std::isfinite(e) ? std::log(e) : std::numeric_limits<double>::quiet_NaN();
    }
    const double mean = sum / n;
    double squares = 0.0;
    for (const double e : table.errors[i]) squares += std::pow(std::log(e) - mean, 2);
    result.log_spacing.push_back(std::log(table.spacing[i]));
    result.mean.push_back(mean);
    result.variance.push_back(n > 1.0 ? squares / (n - 1.0) / n : 0.0);
  }
  return result;
}

ErrorTable resampled(const ErrorTable& table, std::size_t first,
                     const std::vector<std::size_t>& columns) {
  ErrorTable result;
  for (std::size_t i = first; i < table.levels(); ++i) {
    result.spacing.push_back(table.spacing[i]);
    std::vector<double>& row = result.errors.emplace_back();
    for (const std::size_t column : columns) row.push_back(table.errors[i].at(column));
  }
  return result;
}

}  // namespace porowave::verification
