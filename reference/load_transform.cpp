#include "reference/load_transform.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/constants.hpp"
#include "reference/phi.hpp"

namespace porowave::reference {

namespace {

using Complex = std::complex<double>;
/// Duration of the wavelet in its own unit (problem/load.hpp).
constexpr double ricker_width = 13.0;

/// A sum, and the sum of the sizes of its terms.
struct Sum {
  Complex value = 0.0;
  double size = 0.0;

  void add(Complex term) {
    value += term;
    size += std::abs(term);
  }
};

/// integral_0^T e^(s (T - t')) dt'
Complex constant(Complex s, double T) {
  return T * phi_functions<1>(s * T)[1];
}

/// z^3 (10 - 15 z + 6 z^2), z = t/T; t^n/n! convolves to T^(n+1) phi_(n+1)(s T).
Sum ramp_part(Complex s, double T) {
  const auto phi = phi_functions<6>(s * T);
  Sum sum;
  sum.add(T * 60.0 * phi[4]);
  sum.add(T * -360.0 * phi[5]);
  sum.add(T * 720.0 * phi[6]);
  return sum;
}

/// sin^4(pi t/T) = 3/8 - cos(w t)/2 + cos(2 w t)/8, w = 2 pi/T: exponentials e^(iat), each of which
/// convolves over its period T to T phi_1((s - ia) T).
Sum sine_part(Complex s, double T) {
  Sum sum;
  sum.add(0.375 * constant(s, T));
  for (const auto& [harmonic, weight] : {std::pair(1.0, -0.25), std::pair(2.0, 0.0625)}) {
    for (const double sign : {1.0, -1.0}) {
      sum.add(weight * constant(s - Complex(0.0, sign * harmonic * 2.0 * pi / T), T));
    }
  }
  return sum;
}

/// integral_0^end q(t') e^(s (end - t')) dt' of a table: h phi_1 and h^2 phi_2 of each piece.
Sum table_part(Complex s, const Load& load) {
  const auto& t = load.times();
  const auto& v = load.values();
  Sum sum;
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    const double h = t[i + 1] - t[i];
    if (h <= 0.0) continue;
    const auto phi = phi_functions<2>(s * h);
    const Complex factor = std::exp(s * (t.back() - t[i + 1])) * h;
    sum.add(factor * v[i] * phi[1]);
    sum.add(factor * (v[i + 1] - v[i]) * phi[2]);
  }
  return sum;
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

using SlopeChange = LoadTransform::SlopeChange;

std::vector<SlopeChange> table_slope_changes(const Load& load) {
  const auto& t = load.times();
  std::vector<SlopeChange> changes(t.size());
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    if (t[i] == t[i + 1]) continue;
    const double slope =
        load.magnitude() * (load.values()[i + 1] - load.values()[i]) / (t[i + 1] - t[i]);
    changes[i].value += slope;
    changes[i + 1].value -= slope;
    changes[i].size += std::abs(slope);
    changes[i + 1].size += std::abs(slope);
  }
  return changes;
}

/// Shortest time between two different times; 0 if there are none.
double shortest_difference(const std::vector<double>& times) {
  double shortest = 0.0;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double h = times[i + 1] - times[i];
    if (h > 0.0 && (shortest == 0.0 || h < shortest)) shortest = h;
  }
  return shortest;
}

/// The transform of the integral.
ScaledTransform divided(const ScaledTransform& part, Complex s) {
  return {part.value / s, part.size / std::abs(s), part.exponent};
}

}  // namespace

LoadTransform::LoadTransform(const Load& load, TimeIntegral integral, double t)
    : load_(load),
      integral_(integral),
      peak_(load.peak()),
      end_(has_duration(load.shape()) ? load.duration() : 0.0) {
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
      shortest_piece_ = end_;
      break;
    case LoadShape::ricker:
      break;
    case LoadShape::table: {
      event_times_ = load.times();
      end_ = event_times_.back();
      slope_changes_ = table_slope_changes(load);
      shortest_piece_ = shortest_difference(event_times_);
      const auto jumps = table_jumps(load);
      for (std::size_t i = 0; i < jumps.size(); ++i) jumps_.emplace_back(event_times_[i], jumps[i]);
      break;
    }
  }
  if (integral == TimeIntegral::none) return;
  // What is zero after its end adds nothing from there on.
  peak_ *= end_ > 0.0 && load.value(end_) == 0.0 ? std::min(end_, t) : t;
}

ScaledTransform LoadTransform::event(std::size_t e, Complex s, double since) const {
  const ScaledTransform part = event_of_load(e, s, since);
  return integral_ == TimeIntegral::once ? divided(part, s) : part;
}

ScaledTransform LoadTransform::settled(Complex s) const {
  const ScaledTransform whole = settled_load(s);
  return integral_ == TimeIntegral::once ? divided(whole, s) : whole;
}

ScaledTransform LoadTransform::event_of_load(std::size_t e, Complex s, double since) const {
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
      const double size = std::abs(jump) + slope_changes_[e].size / std::abs(s);
      return {(jump + slope_changes_[e].value / s) / s, size / std::abs(s), s * since};
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
  std::vector<ImaginaryPole> poles = {{w, -0.25 * sign}, {2.0 * w, 0.0625 * sign}};
  if (integral_ == TimeIntegral::once) {
    for (ImaginaryPole& pole : poles) pole.residue /= Complex(0.0, pole.frequency);
  }
  return poles;
}

double LoadTransform::shortest_scale() const {
  return 0.25 * load_.duration();
}

ScaledTransform LoadTransform::sum_of_events(Complex s) const {
  Sum sum;
  for (std::size_t e = 0; e < event_times_.size(); ++e) {
    const ScaledTransform part = event_of_load(e, s, end_ - event_times_[e]);
    sum.add(part.value * std::exp(part.exponent));
  }
  return {sum.value, sum.size, 0.0};
}

ScaledTransform LoadTransform::settled_load(Complex s) const {
  // Far from 0 the events are small, but the parts below are not: they cancel.
  constexpr double far = 20.0;
  if (std::norm(s) * shortest_piece_ * shortest_piece_ > far * far && !always_whole()) {
    return sum_of_events(s);
  }
  const double q = load_.magnitude();
  Sum sum;
  switch (load_.shape()) {
    case LoadShape::step:
      sum.add(1.0 / s);
      break;
    case LoadShape::block:
      sum.add(constant(s, end_));
      break;
    case LoadShape::smooth_ramp:
      sum = ramp_part(s, end_);
      sum.add(1.0 / s);
      break;
    case LoadShape::sin4_pulse:
      sum = sine_part(s, end_);
      break;
    case LoadShape::ricker: {
      // (1 - 2 v^2) e^(-v^2) = -(1/2) d^2/dv^2 e^(-v^2), v = (t - T/2)/b.
      const double b = load_.duration() / ricker_width;
      const Complex sb = s * b;
      const Complex value = -0.5 * b * q * std::sqrt(pi) * sb * sb;
      return {value, std::abs(value), 0.5 * s * end_ + 0.25 * sb * sb};
    }
    case LoadShape::table:
      sum = table_part(s, load_);
      sum.add(load_.values().back() / s);
      break;
  }
  return {q * sum.value, std::abs(q) * sum.size, 0.0};
}

}  // namespace porowave::reference
