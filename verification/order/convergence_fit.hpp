#pragma once

#include <vector>

#include "verification/order/error_table.hpp"

namespace porowave::verification {

/// Observed orders between neighbouring levels, log(e_i/e_{i+1})/log(h_i/h_{i+1}), with their sign:
/// an error that grows has a negative order. NaN where an error is.
std::vector<double> pairwise_orders(const LogMeans& levels);

/// The model e = C h^order + floor, fitted to the logarithms of the errors.
struct ConvergenceFit {
  double order = 0.0;
  double log_constant = 0.0;
  double floor = 0.0;     ///< 0 if the model without a floor is used
  double residual = 0.0;  ///< weighted sum of squared residuals of log e

  double log_error(double log_spacing) const;
  /// Observed order that the model has between two levels.
  double local_order(double coarse_log_spacing, double fine_log_spacing) const;
};

/// Weighted linear regression of log e on log h; levels weigh by the variances of their means (all
/// the same if these are zero). At least two levels, all finite; std::invalid_argument otherwise.
ConvergenceFit fit_power(const LogMeans& levels);

/// Order and floor in one fit (Levenberg-Marquardt). At least four levels, all finite;
/// std::invalid_argument otherwise. The floor is 0 if none lowers the residual.
ConvergenceFit fit_with_floor(const LogMeans& levels);

/// The floor model if the data ask for it: the residual falls by more than chance lets it (F-test,
/// 1 %), and the floor is at least a tenth of the finest error. Otherwise the power.
ConvergenceFit fit_convergence(const LogMeans& levels);

}  // namespace porowave::verification
