#include "verification/order/convergence_fit.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <stdexcept>

namespace porowave::verification {

namespace {

constexpr std::size_t most_iterations = 200;
constexpr double significance = 0.01;
constexpr double least_floor_share = 0.1;
/// Means are known no better than this: a level whose replicates agree by chance must not decide.
constexpr double least_deviation = 0.01;

void require(const LogMeans& levels, std::size_t least) {
  if (levels.mean.size() < least) throw std::invalid_argument("order: too few levels for this fit");
  for (const double m : levels.mean) {
    if (!std::isfinite(m)) throw std::invalid_argument("order: an error is not finite");
  }
}

/// Variances of few replicates are themselves uncertain: each is drawn towards the mean of all.
std::vector<double> weights_of(const LogMeans& levels) {
  const auto n = static_cast<double>(levels.variance.size());
  const double mean = std::accumulate(levels.variance.begin(), levels.variance.end(), 0.0) / n;
  std::vector<double> weights;
  for (const double v : levels.variance) {
    weights.push_back(mean > 0.0 ? 1.0 / (0.5 * (v + mean) + least_deviation * least_deviation)
                                 : 1.0);
  }
  return weights;
}

double residual_of(const ConvergenceFit& fit, const LogMeans& levels) {
  const auto weights = weights_of(levels);
  double sum = 0.0;
  for (std::size_t i = 0; i < levels.mean.size(); ++i) {
    sum += weights[i] * std::pow(levels.mean[i] - fit.log_error(levels.log_spacing[i]), 2);
  }
  return sum;
}

// Parameters of the floor model: log C, order, log floor.
ConvergenceFit model(const gsl_vector* x) {
  return {gsl_vector_get(x, 1), gsl_vector_get(x, 0), std::exp(gsl_vector_get(x, 2)), 0.0};
}

int residuals(const gsl_vector* x, void* data, gsl_vector* out) {
  const auto& levels = *static_cast<const LogMeans*>(data);
  const ConvergenceFit fit = model(x);
  for (std::size_t i = 0; i < levels.mean.size(); ++i) {
    gsl_vector_set(out, i, fit.log_error(levels.log_spacing[i]) - levels.mean[i]);
  }
  return GSL_SUCCESS;
}

int jacobian(const gsl_vector* x, void* data, gsl_matrix* out) {
  const auto& levels = *static_cast<const LogMeans*>(data);
  const ConvergenceFit fit = model(x);
  for (std::size_t i = 0; i < levels.mean.size(); ++i) {
    const double log_h = levels.log_spacing[i];
    const double share = 1.0 - fit.floor / std::exp(fit.log_error(log_h));
    gsl_matrix_set(out, i, 0, share);
    gsl_matrix_set(out, i, 1, share * log_h);
    gsl_matrix_set(out, i, 2, 1.0 - share);
  }
  return GSL_SUCCESS;
}

/// The order of the two coarsest levels, where a floor shows least, and half of the finest error.
std::array<double, 3> start(const LogMeans& levels) {
  const double order = pairwise_orders(levels).front();
  return {levels.mean[0] - order * levels.log_spacing[0], order,
          levels.mean.back() + std::log(0.5)};
}

}  // namespace

double ConvergenceFit::log_error(double log_spacing) const {
  const double power = log_constant + order * log_spacing;
  return floor > 0.0 ? power + std::log1p(floor * std::exp(-power)) : power;
}

double ConvergenceFit::local_order(double coarse, double fine) const {
  return (log_error(coarse) - log_error(fine)) / (coarse - fine);
}

std::vector<double> pairwise_orders(const LogMeans& levels) {
  std::vector<double> orders;
  for (std::size_t i = 0; i + 1 < levels.mean.size(); ++i) {
    orders.push_back((levels.mean[i] - levels.mean[i + 1]) /
                     (levels.log_spacing[i] - levels.log_spacing[i + 1]));
  }
  return orders;
}

ConvergenceFit fit_power(const LogMeans& levels) {
  require(levels, 2);
  const auto weights = weights_of(levels);
  ConvergenceFit fit;
  double c00 = 0.0;
  double c01 = 0.0;
  double c11 = 0.0;
  gsl_fit_wlinear(levels.log_spacing.data(), 1, weights.data(), 1, levels.mean.data(), 1,
                  levels.mean.size(), &fit.log_constant, &fit.order, &c00, &c01, &c11,
                  &fit.residual);
  return fit;
}

ConvergenceFit fit_with_floor(const LogMeans& levels) {
  require(levels, 4);
  const ConvergenceFit power = fit_power(levels);
  auto weights = weights_of(levels);
  auto guess = start(levels);
  LogMeans copy = levels;
  gsl_multifit_nlinear_fdf problem{};
  problem.f = residuals;
  problem.df = jacobian;
  problem.n = levels.mean.size();
  problem.p = guess.size();
  problem.params = &copy;
  const auto parameters = gsl_multifit_nlinear_default_parameters();
  const std::unique_ptr<gsl_multifit_nlinear_workspace, decltype(&gsl_multifit_nlinear_free)> work(
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, problem.n, problem.p),
      gsl_multifit_nlinear_free);
  if (!work) throw std::bad_alloc();
  const auto first = gsl_vector_view_array(guess.data(), guess.size());
  const auto weight = gsl_vector_view_array(weights.data(), weights.size());
  gsl_multifit_nlinear_winit(&first.vector, &weight.vector, &problem, work.get());
  int info = 0;
  // Whether it has converged shows in the residual, which is compared below.
  gsl_multifit_nlinear_driver(most_iterations, 1e-12, 1e-12, 0.0, nullptr, nullptr, &info,
                              work.get());
  ConvergenceFit fit = model(gsl_multifit_nlinear_position(work.get()));
  fit.residual = residual_of(fit, levels);
  return fit.residual < power.residual ? fit : power;
}

ConvergenceFit fit_convergence(const LogMeans& levels) {
  const ConvergenceFit power = fit_power(levels);
  if (levels.mean.size() < 4) return power;
  const ConvergenceFit with_floor = fit_with_floor(levels);
  const double finest = std::exp(with_floor.log_error(levels.log_spacing.back()));
  if (with_floor.floor < least_floor_share * finest) return power;
  const auto spare = static_cast<double>(levels.mean.size() - 3);
  const double ratio = (power.residual - with_floor.residual) / (with_floor.residual / spare);
  const bool asked_for = gsl_cdf_fdist_Q(ratio, 1.0, spare) < significance;
  return asked_for ? with_floor : power;
}

}  // namespace porowave::verification
