#include "reference/modal_load.hpp"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "reference/constants.hpp"

namespace porowave::reference::quarter_wave {

namespace {

using Complex = std::complex<double>;
using Gauss = boost::math::quadrature::gauss<double, 30>;
/// |s| h of a panel of length h up to which 30 nodes are exact.
constexpr double panel_reach = 20.0;
/// Panels of the coarsest rule (what the load itself needs) and how often they are doubled.
constexpr int ramp_panels = 1;
constexpr int sine_panels = 3;
constexpr int wavelet_panels = 8;
constexpr int wavelet_levels = 3;
constexpr int ramp_degree = 5;

/// d^n/dz^n of z^3 (10 - 15 z + 6 z^2)
double ramp_derivative(int order, double z) {
  std::array<double, ramp_degree + 1> c = {0, 0, 0, 10, -15, 6};
  for (int n = 0; n < order; ++n) {
    for (std::size_t i = 0; i + 1 < c.size(); ++i) c[i] = static_cast<double>(i + 1) * c[i + 1];
    c.back() = 0.0;
  }
  double sum = 0.0;
  for (std::size_t i = c.size(); i-- > 0;) sum = sum * z + c[i];
  return sum;
}

/// d^n/dz^n of sin^4(pi z) = 3/8 - cos(2 pi z)/2 + cos(4 pi z)/8
double sine_derivative(int order, double z) {
  const double w = 2.0 * pi;
  const double shift = 0.5 * pi * order;
  return (order == 0 ? 0.375 : 0.0) - 0.5 * std::pow(w, order) * std::cos(w * z + shift) +
         0.125 * std::pow(2.0 * w, order) * std::cos(2.0 * w * z + shift);
}

/// d^n/dz^n of the wavelet, minus half the second derivative of e^(-u^2), u = 13 (z - 1/2)
double wavelet_derivative(int order, double z) {
  const double u = 13.0 * (z - 0.5);
  // Hermite polynomials by their recurrence: the n-th derivative of e^(-u^2) is (-1)^n H_n
  // e^(-u^2).
  double previous = 1.0;
  double hermite = 2.0 * u;
  for (int n = 1; n < order + 2; ++n) {
    const double next = 2.0 * u * hermite - 2.0 * n * previous;
    previous = hermite;
    hermite = next;
  }
  return (order % 2 == 0 ? -0.5 : 0.5) * std::pow(13.0, order) * hermite * std::exp(-u * u);
}

}  // namespace

bool is_smooth(const Load& load) {
  return load.shape() == LoadShape::smooth_ramp || load.shape() == LoadShape::sin4_pulse ||
         load.shape() == LoadShape::ricker;
}

SmoothLoad::SmoothLoad(const Load& load, double t)
    : load_(load), t_(t), end_(std::min(t, load.duration())) {
  switch (load.shape()) {
    case LoadShape::smooth_ramp:
      rules_ = {rule(ramp_panels)};
      break;
    case LoadShape::sin4_pulse:
      rules_ = {rule(sine_panels)};
      break;
    default:
      for (int level = 0; level < wavelet_levels; ++level) {
        rules_.push_back(rule(wavelet_panels << level));
      }
      break;
  }
}

double SmoothLoad::derivative_at(int order, double time) const {
  const double z = time / load_.duration();
  const double scale = load_.magnitude() / std::pow(load_.duration(), order);
  switch (load_.shape()) {
    case LoadShape::smooth_ramp:
      return scale * ramp_derivative(order, z);
    case LoadShape::sin4_pulse:
      return scale * sine_derivative(order, z);
    default:
      return scale * wavelet_derivative(order, z);
  }
}

double SmoothLoad::derivative(int order) const {
  if (t_ <= load_.duration()) return derivative_at(order, t_);
  return order == 0 ? load_.value(t_) : 0.0;
}

SmoothLoad::Rule SmoothLoad::rule(int panels) const {
  Rule result{panel_reach * panels, {}, {}};
  const double half = 0.5 * end_ / panels;
  for (int panel = 0; panel < panels; ++panel) {
    for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i) {
      for (const double sign : {-1.0, 1.0}) {
        const double time = (2 * panel + 1) * half + sign * half * Gauss::abscissa()[i];
        result.before_end.push_back(end_ - time);
        result.weight.push_back(half * Gauss::weights()[i] * derivative_at(1, time));
      }
    }
  }
  return result;
}

Complex SmoothLoad::response(Complex s) const {
  const double size = std::abs(s) * end_;
  for (const Rule& candidate : rules_) {
    if (size < candidate.reach) return by_rule(candidate, s);
  }
  return load_.shape() == LoadShape::sin4_pulse ? sines(s) : by_parts(s);
}

Complex SmoothLoad::by_rule(const Rule& rule, Complex s) const {
  Complex sum = 0.0;
  for (std::size_t i = 0; i < rule.weight.size(); ++i) {
    sum += rule.weight[i] * std::exp(s * rule.before_end[i]);
  }
  return sum * std::exp(s * (t_ - end_));
}

Complex SmoothLoad::by_parts(Complex s) const {
  // The sum ends for a polynomial. A wavelet is over at both of its ends; while it passes, its
  // derivatives grow slower than the powers of s here.
  const bool ramp = load_.shape() == LoadShape::smooth_ramp;
  const Complex from_start = ramp ? std::exp(s * t_) : 0.0;
  const Complex from_end = std::exp(s * (t_ - end_));
  const int orders = ramp ? ramp_degree : most_derivatives;
  Complex sum = 0.0;
  Complex power = 1.0;
  for (int order = 1; order <= orders; ++order) {
    power /= s;
    const double start = ramp ? derivative_at(order, 0.0) : 0.0;
    sum += power * (start * from_start - derivative_at(order, end_) * from_end);
  }
  return sum;
}

Complex SmoothLoad::sines(Complex s) const {
  // q' = (w/2) sin(w t) - (w/4) sin(2 w t)
  const double w = 2.0 * pi / load_.duration();
  const Complex from_start = std::exp(s * t_);
  const Complex from_end = std::exp(s * (t_ - end_));
  Complex sum = 0.0;
  for (const auto& [a, weight] : {std::pair(w, 0.5 * w), std::pair(2.0 * w, -0.25 * w)}) {
    const Complex grown = a * std::cos(a * end_) + s * std::sin(a * end_);
    sum += weight * (a * from_start - grown * from_end) / (s * s + a * a);
  }
  return load_.magnitude() * sum;
}

}  // namespace porowave::reference::quarter_wave
