#pragma once

#include <complex>
#include <span>
#include <utility>
#include <vector>

#include "reference/problem/load.hpp"

namespace porowave::reference {

/// value * e^exponent, and the size of the largest terms that value is the difference of. Both
/// factors may be too large or too small to be multiplied before other exponents are added.
struct ScaledTransform {
  std::complex<double> value;
  double size;
  std::complex<double> exponent;
};

/// A simple pole of an event's transform on the imaginary axis, and its conjugate.
struct ImaginaryPole {
  double frequency;              ///< the pole is at i * frequency, 1/s
  std::complex<double> residue;  ///< at this pole; at the other one its conjugate
};

/// Whether the fields are wanted or their integrals over time, from 0 on.
enum class TimeIntegral { none, once };

/// The load in the Laplace domain, split so that every part decays to the left as fast as it can.
///
/// q(t) is a sum of events: event e starts at time t_e and is analytic from there on, with a
/// transform Q_e(s) that has poles at 0 or on the imaginary axis only. For a wave that has
/// travelled for `since` after an event's arrival, the inversion needs e^(s since) Q_e(s). Once all
/// events have arrived, their sum, `settled`, is needed instead: the transform of the whole load,
/// in which large terms of opposite sign have cancelled.
///
/// The ricker wavelet is analytic throughout, and its transform decays in all directions within 45
/// degrees of the imaginary axis: it is always taken as a whole.
///
/// With TimeIntegral::once it stands for the integral of q from 0 on: all transforms are divided by
/// s. Fields under that load are the integrals of those under q.
class LoadTransform {
 public:
  /// Change of the slope of a table at one of its times, and the size of the slopes it comes from.
  struct SlopeChange {
    double value = 0.0;
    double size = 0.0;
  };

  /// `t` is the time at which integrals are wanted, s; it sets their scale, `peak`.
  explicit LoadTransform(const Load& load, TimeIntegral integral = TimeIntegral::none,
                         double t = 0.0);

  const std::vector<double>& event_times() const { return event_times_; }
  /// Time of the last event; from then on the load is constant.
  double end() const { return end_; }
  /// True if the whole load may be used before it has settled.
  bool always_whole() const { return load_.shape() == LoadShape::ricker; }
  /// The shortest time in which a load that is always whole varies.
  double shortest_scale() const;
  /// Angle from the imaginary axis within which all parts decay.
  double widest_angle() const { return always_whole() ? 0.6 : 1.2; }

  /// e^(s since) Q_e(s)
  ScaledTransform event(std::size_t e, std::complex<double> s, double since) const;
  std::vector<ImaginaryPole> event_poles(std::size_t e) const;
  /// e^(s end()) times the transform of the whole load. A wave that has travelled for tau >= end()
  /// needs it times e^(s (tau - end())).
  ScaledTransform settled(std::complex<double> s) const;

  /// Times and sizes of the jumps of q (including the one at t = 0); its integral has none.
  std::span<const std::pair<double, double>> jumps() const {
    if (integral_ == TimeIntegral::once) return {};
    return jumps_;
  }
  double value(double tau) const {
    return integral_ == TimeIntegral::once ? load_.impulse(tau) : load_.value(tau);
  }
  /// Largest |q|; for the integral a bound of what it reaches until t.
  double peak() const { return peak_; }

 private:
  ScaledTransform event_of_load(std::size_t e, std::complex<double> s, double since) const;
  ScaledTransform settled_load(std::complex<double> s) const;
  ScaledTransform sum_of_events(std::complex<double> s) const;

  Load load_;
  TimeIntegral integral_;
  double shortest_piece_ = 0.0;  ///< between two events, where `settled` cancels
  double peak_;
  double end_;
  std::vector<double> event_times_;
  std::vector<std::pair<double, double>> jumps_;
  std::vector<SlopeChange> slope_changes_;  ///< of a table, at its times
};

}  // namespace porowave::reference
