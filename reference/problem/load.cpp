#include "reference/problem/load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/problem/errors.hpp"

namespace porowave {

namespace {

constexpr double pi = std::numbers::pi;
/// Half-width of the Ricker wavelet in its own unit: e^(-6.5^2) = 4.5e-19.
constexpr double ricker_width = 13.0;

/// Index of the last table time <= t; the times are not descending.
std::size_t last_at_or_before(const std::vector<double>& times, double t) {
  return static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), t) - times.begin()) -
         1;
}

double table_value(const std::vector<double>& times, const std::vector<double>& values, double t) {
  if (t < times.front()) return 0.0;
  const std::size_t i = last_at_or_before(times, t);
  if (i + 1 == times.size()) return values.back();
  const double share = (t - times[i]) / (times[i + 1] - times[i]);
  return std::lerp(values[i], values[i + 1], share);
}

double table_impulse(const std::vector<double>& times, const std::vector<double>& values,
                     double t) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < times.size() && times[i] < t; ++i) {
    const double end = std::min(times[i + 1], t);
    const double slope =
        times[i + 1] > times[i] ? (values[i + 1] - values[i]) / (times[i + 1] - times[i]) : 0.0;
    const double width = end - times[i];
    sum += width * (values[i] + 0.5 * slope * width);
  }
  return sum + values.back() * std::max(0.0, t - times.back());
}

}  // namespace

bool has_duration(LoadShape shape) {
  return shape != LoadShape::step && shape != LoadShape::table;
}

Load::Load(LoadShape shape, double magnitude, double duration)
    : shape_(shape), magnitude_(magnitude), duration_(duration) {
  if (has_duration(shape) && !(duration > 0.0 && std::isfinite(duration))) {
    throw InputError(
        fmt::format("load {}: duration = {}: expected a number > 0", name(shape), duration));
  }
}

Load::Load(double magnitude, std::vector<double> times, std::vector<double> values)
    : shape_(LoadShape::table),
      magnitude_(magnitude),
      times_(std::move(times)),
      values_(std::move(values)) {
  const auto finite = [](double v) { return std::isfinite(v); };
  if (times_.empty() || times_.size() != values_.size() || times_.front() < 0.0 ||
      !std::is_sorted(times_.begin(), times_.end()) ||
      !std::all_of(times_.begin(), times_.end(), finite) ||
      !std::all_of(values_.begin(), values_.end(), finite)) {
    throw InputError(
        "load table: expected as many finite values as times, and times >= 0 in "
        "ascending order");
  }
}

double Load::unit_value(double t) const {
  const double z = t / duration_;
  switch (shape_) {
    case LoadShape::step:
      return 1.0;
    case LoadShape::smooth_ramp:
      return z >= 1.0 ? 1.0 : z * z * z * (10.0 - 15.0 * z + 6.0 * z * z);
    case LoadShape::sin4_pulse: {
      const double sine = std::sin(pi * z);
      return z >= 1.0 ? 0.0 : sine * sine * sine * sine;
    }
    case LoadShape::block:
      return z >= 1.0 ? 0.0 : 1.0;
    case LoadShape::ricker: {
      const double u = ricker_width * (z - 0.5);
      return z >= 1.0 ? 0.0 : (1.0 - 2.0 * u * u) * std::exp(-u * u);
    }
    case LoadShape::table:
      return table_value(times_, values_, t);
  }
  return 0.0;
}

double Load::unit_impulse(double t) const {
  const double z = std::min(t / duration_, 1.0);
  const double after = std::max(0.0, t - duration_);
  switch (shape_) {
    case LoadShape::step:
      return t;
    case LoadShape::smooth_ramp:
      return duration_ * z * z * z * z * (2.5 - 3.0 * z + z * z) + after;
    case LoadShape::sin4_pulse:
      return duration_ * (3.0 * z / 8.0 - std::sin(2.0 * pi * z) / (4.0 * pi) +
                          std::sin(4.0 * pi * z) / (32.0 * pi));
    case LoadShape::block:
      return duration_ * z;
    case LoadShape::ricker: {
      const double u = ricker_width * (z - 0.5);
      const double start = 0.5 * ricker_width;
      return duration_ / ricker_width * (u * std::exp(-u * u) + start * std::exp(-start * start));
    }
    case LoadShape::table:
      return table_impulse(times_, values_, t);
  }
  return 0.0;
}

double Load::value(double t) const {
  return t < 0.0 ? 0.0 : magnitude_ * unit_value(t);
}

double Load::impulse(double t) const {
  return t <= 0.0 ? 0.0 : magnitude_ * unit_impulse(t);
}

double Load::peak() const {
  double peak = 1.0;
  if (shape_ == LoadShape::table) {
    peak = 0.0;
    for (const double value : values_) peak = std::max(peak, std::abs(value));
  }
  return std::abs(magnitude_) * peak;
}

}  // namespace porowave
