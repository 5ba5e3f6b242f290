#include "verification/order/order_estimate.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_rng.h>
#include <gsl/gsl_statistics.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "verification/not_a_number.hpp"

namespace porowave::verification {

namespace {

constexpr std::size_t fewest_levels = 3;
/// Noise explains a pairwise order that is off by this many standard errors.
constexpr double noise_factor = 3.0;
/// Beyond this share of the finest error the floor hides the order.
constexpr double hiding_floor = 0.8;

LogMeans from(const LogMeans& levels, std::size_t first) {
  const auto begin = static_cast<std::ptrdiff_t>(first);
  return {{levels.log_spacing.begin() + begin, levels.log_spacing.end()},
          {levels.mean.begin() + begin, levels.mean.end()},
          {levels.variance.begin() + begin, levels.variance.end()}};
}

/// What the pairwise orders of the data have beyond those of the fit.
std::vector<double> deviations(const LogMeans& levels, const ConvergenceFit& fit) {
  std::vector<double> result = pairwise_orders(levels);
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] -= fit.local_order(levels.log_spacing[i], levels.log_spacing[i + 1]);
  }
  return result;
}

bool explained(const LogMeans& levels, const ConvergenceFit& fit, double spread) {
  const auto off = deviations(levels, fit);
  for (std::size_t i = 0; i < off.size(); ++i) {
    const double noise = std::sqrt(levels.variance[i] + levels.variance[i + 1]) /
                         (levels.log_spacing[i] - levels.log_spacing[i + 1]);
    if (std::abs(off[i]) > spread + noise_factor * noise) return false;
  }
  return true;
}

/// Standard error of the order, from resampled replicates.
double bootstrap_error(const ErrorTable& table, std::size_t first, bool with_floor,
                       const OrderOptions& options) {
  const std::size_t n = table.replicates();
  const std::unique_ptr<gsl_rng, decltype(&gsl_rng_free)> random(gsl_rng_alloc(gsl_rng_mt19937),
                                                                 gsl_rng_free);
  gsl_rng_set(random.get(), static_cast<unsigned long>(options.seed));
  // Weights stay those of all replicates: a sample of equal columns has none.
  const std::vector<double> variance = from(log_means(table), first).variance;
  std::vector<double> orders;
  std::vector<std::size_t> columns(n);
  for (int sample = 0; sample < options.resamples; ++sample) {
    for (std::size_t& column : columns) column = gsl_rng_uniform_int(random.get(), n);
    LogMeans levels = log_means(resampled(table, first, columns));
    levels.variance = variance;
    orders.push_back((with_floor ? fit_with_floor(levels) : fit_power(levels)).order);
  }
  // The bootstrap's variance is that of n replicates about their own mean.
  const auto count = static_cast<double>(n);
  return gsl_stats_sd(orders.data(), 1, orders.size()) * std::sqrt(count / (count - 1.0));
}

void set_interval(const ErrorTable& table, const LogMeans& levels, const ConvergenceFit& fit,
                  const OrderOptions& options, OrderEstimate& result) {
  if (table.replicates() > 1) {
    const double tail = 0.5 * (1.0 - options.confidence);
    const auto freedom = static_cast<double>(table.replicates() - 1);
    const double reach = gsl_cdf_tdist_Qinv(tail, freedom) *
                         bootstrap_error(table, result.first_level, fit.floor > 0.0, options);
    result.low = fit.order - reach;
    result.high = fit.order + reach;
    return;
  }
  const auto off = deviations(levels, fit);
  result.low = fit.order + std::min(0.0, *std::min_element(off.begin(), off.end()));
  result.high = fit.order + std::max(0.0, *std::max_element(off.begin(), off.end()));
}

}  // namespace

OrderEstimate estimate_order(const ErrorTable& table, const OrderOptions& options) {
  const LogMeans levels = log_means(table);
  OrderEstimate result;
  result.order = result.low = result.high = nan;
  result.pairwise = pairwise_orders(levels);
  if (std::any_of(levels.mean.begin(), levels.mean.end(),
                  [](double m) { return !std::isfinite(m); })) {
    result.status = OrderStatus::not_finite;
    return result;
  }
  if (table.levels() < fewest_levels) {
    result.status = OrderStatus::too_few_levels;
    return result;
  }
  for (std::size_t first = 0; first + fewest_levels <= table.levels(); ++first) {
    const LogMeans range = from(levels, first);
    const ConvergenceFit fit = fit_convergence(range);
    if (!explained(range, fit, options.spread)) continue;
    result.first_level = first;
    result.order = fit.order;
    result.floor = fit.floor;
    set_interval(table, range, fit, options, result);
    const bool hidden = fit.floor > hiding_floor * std::exp(range.mean.back());
    result.status = hidden ? OrderStatus::at_floor : OrderStatus::observed;
    return result;
  }
  result.status = OrderStatus::not_asymptotic;
  return result;
}

}  // namespace porowave::verification
