#include "reference/load_transform.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/phi.hpp"

namespace porowave::reference {

namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;

/// integral_0^T e^(s (T - t')) dt'
Complex constant(Complex s, double T) {
  return T * phi_functions<1>(s * T)[1];
}

/// z^3 (10 - 15 z + 6 z^2), z = t/T; t^n/n! convolves to T^(n+1) phi_(n+1)(s T).
Complex ramp_part(Complex s, double T) {
  const auto phi = phi_functions<6>(s * T);
  return T * (60.0 * phi[4] - 360.0 * phi[5] + 720.0 * phi[6]);
}

/// sin^4(pi t/T) = 3/8 - cos(w t)/2 + cos(2 w t)/8, w = 2 pi/T: exponentials e^(iat), each of which
/// convolves over its period T to T phi_1((s - ia) T).
Complex sine_part(Complex s, double T) {
  Complex sum = 0.375 * constant(s, T);
  for (const auto& [harmonic, weight] : {std::pair(1.0, -0.25), std::pair(2.0, 0.0625)}) {
    for (const double sign : {1.0, -1.0}) {
      sum += weight * constant(s - Complex(0.0, sign * harmonic * 2.0 * pi / T), T);
    }
  }
  return sum;
}

constexpr double most_panels = 200.0;

/// integral_0^min(tau,T) q(t') e^(s (tau - t')) dt' by Gauss-Legendre panels within which wavelet
/// and exponential vary little.
Complex ricker_part(Complex s, double tau, const Load& load) {
  using Rule = boost::math::quadrature::gauss<double, 30>;
  const double end = std::min(tau, load.duration());
  // Far from s = 0 (but not to the right) the transform of the whole wavelet is below its rounding.
  const double T = load.duration();
  if (tau >= T && std::abs(s) * T > 600.0 && s.real() * T < 200.0) return 0.0;
  const double wanted = 8.0 + std::abs(s) * end / 8.0;
  if (!(wanted < most_panels)) return std::numeric_limits<double>::quiet_NaN();
  const auto panels = static_cast<int>(wanted);
  const double width = end / panels;
  Complex sum = 0.0;
  for (int panel = 0; panel < panels; ++panel) {
    const double middle = (panel + 0.5) * width;
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      for (const double sign : {1.0, -1.0}) {
        const double t = middle + sign * 0.5 * width * Rule::abscissa()[i];
        sum += 0.5 * width * Rule::weights()[i] * load.value(t) * std::exp(s * (tau - t));
      }
    }
  }
  return sum;
}

/// integral_0^end q(t') e^(s (end - t')) dt' of a table: h phi_1 and h^2 phi_2 of each piece.
Complex table_part(Complex s, const Load& load) {
  const auto& t = load.times();
  const auto& v = load.values();
  Complex sum = 0.0;
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    const double h = t[i + 1] - t[i];
    if (h <= 0.0) continue;
    const auto phi = phi_functions<2>(s * h);
    sum += std::exp(s * (t.back() - t[i + 1])) * h * (v[i] * phi[1] + (v[i + 1] - v[i]) * phi[2]);
  }
  return load.magnitude() * sum;
}

/// Jumps of a table at its times, after the magnitude; equal times make one jump together.
std::vector<double> table_jumps(const Load& load) {
  std::vector<double> jumps(load.times().size(), 0.0);
  jumps[0] = load.magnitude() * load.values()[0];
  for (std::size_t i = 0; i + 1 < jumps.size(); ++i) {
    if (load.times()[i] < load.times()[i + 1]) continue;
    jumps[i + 1] = load.magnitude() * (load.values()[i + 1] - load.values()[i]);
  }
  return jumps;
}

/// Changes of the slope of a table at its times.
std::vector<double> table_slope_changes(const Load& load) {
  const auto& t = load.times();
  std::vector<double> changes(t.size(), 0.0);
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    if (t[i] == t[i + 1]) continue;
    const double slope =
        load.magnitude() * (load.values()[i + 1] - load.values()[i]) / (t[i + 1] - t[i]);
    changes[i] += slope;
    changes[i + 1] -= slope;
  }
  return changes;
}

}  // namespace

LoadTransform::LoadTransform(const Load& load)
    : load_(load), peak_(load.peak()), end_(has_duration(load.shape()) ? load.duration() : 0.0) {
  const double size = load.magnitude();
  switch (load.shape()) {
    case LoadShape::step:
      event_times_ = {0.0};
      jumps_ = {{0.0, size}};
      break;
    case LoadShape::block:
      event_times_ = {0.0, end_};
      jumps_ = {{0.0, size}, {end_, -size}};
      break;
    case LoadShape::smooth_ramp:
    case LoadShape::sin4_pulse:
      event_times_ = {0.0, end_};
      break;
    case LoadShape::ricker:
      break;
    case LoadShape::table: {
      event_times_ = load.times();
      end_ = event_times_.back();
      slope_changes_ = table_slope_changes(load);
      const auto jumps = table_jumps(load);
      for (std::size_t i = 0; i < jumps.size(); ++i) jumps_.emplace_back(event_times_[i], jumps[i]);
      break;
    }
  }
}

ScaledTransform LoadTransform::event(std::size_t e, Complex s, double since) const {
  const double q = load_.magnitude();
  const double T = load_.duration();
  switch (load_.shape()) {
    case LoadShape::step:
    case LoadShape::block: {
      const Complex value = (e == 0 ? q : -q) / s;
      return {value, std::abs(value), s * since};
    }
    case LoadShape::smooth_ramp: {
      // The end is minus the polynomial 10 w^3 + 15 w^4 + 6 w^5, w = (t - T)/T.
      const Complex u = 1.0 / (s * T);
      const Complex factor = q * u * u * u / s;
      const Complex value = e == 0 ? factor * (60.0 - u * (360.0 - 720.0 * u))
                                   : -factor * (60.0 + u * (360.0 + 720.0 * u));
      const double a = std::abs(u);
      return {value, std::abs(factor) * (60.0 + a * (360.0 + 720.0 * a)), s * since};
    }
    case LoadShape::sin4_pulse: {
      // 24 a^4/(s (s^2 + 4 a^2)(s^2 + 16 a^2)), a = pi/T; its end is minus the same.
      const double a = pi / T;
      const Complex s2 = s * s;
      const Complex value =
          q * (24.0 * a * a * a * a) / (s * (s2 + 4.0 * a * a) * (s2 + 16.0 * a * a));
      return {e == 0 ? value : -value, std::abs(value), s * since};
    }
    case LoadShape::table: {
      const double jump = jumps_[e].second;
      const double size = std::abs(jump) + std::abs(slope_changes_[e]) / std::abs(s);
      return {(jump + slope_changes_[e] / s) / s, size / std::abs(s), s * since};
    }
    case LoadShape::ricker:
      break;
  }
  return {0.0, 0.0, 0.0};
}

std::vector<ImaginaryPole> LoadTransform::event_poles(std::size_t e) const {
  if (load_.shape() != LoadShape::sin4_pulse) return {};
  // The transform of cos(w t) has residue 1/2 at both of its poles.
  const double sign = e == 0 ? load_.magnitude() : -load_.magnitude();
  const double w = 2.0 * pi / load_.duration();
  return {{w, -0.25 * sign}, {2.0 * w, 0.0625 * sign}};
}

Complex LoadTransform::whole(Complex s) const {
  const double size = load_.magnitude();
  switch (load_.shape()) {
    case LoadShape::step:
      return size / s;
    case LoadShape::block:
      return size * constant(s, end_);
    case LoadShape::smooth_ramp:
      return size * (ramp_part(s, end_) + 1.0 / s);
    case LoadShape::sin4_pulse:
      return size * sine_part(s, end_);
    case LoadShape::ricker:
      return ricker_part(s, end_, load_);
    case LoadShape::table:
      return table_part(s, load_) + size * load_.values().back() / s;
  }
  return 0.0;
}

ScaledTransform LoadTransform::settled(Complex s) const {
  // Parts of size end_ and 1/s, growing like e^(s end_) at most, may have cancelled.
  const double largest =
      peak_ * (end_ * std::max(1.0, std::exp(s.real() * end_)) + 1.0 / std::abs(s));
  return {whole(s), largest, 0.0};
}

ScaledTransform LoadTransform::passing_part(Complex s, double tau) const {
  const double largest = peak_ * tau * std::max(1.0, std::exp(s.real() * tau));
  return {ricker_part(s, tau, load_), largest, 0.0};
}

}  // namespace porowave::reference
