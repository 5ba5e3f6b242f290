#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace porowave {

class TomlDocument;

enum class LoadShape { step, smooth_ramp, sin4_pulse, block, ricker, table };
inline constexpr std::array<std::string_view, 6> load_shape_names = {
    "step", "smooth_ramp", "sin4_pulse", "block", "ricker", "table"};

constexpr std::string_view name(LoadShape shape) {
  return load_shape_names[static_cast<std::size_t>(shape)];
}

/// The load q(t) = magnitude * shape(t), zero for t < 0, in Pa (m/s for near = "velocity").
///
///   step         1
///   smooth_ramp  z^3 (10 - 15 z + 6 z^2), z = t/T; 1 after T
///   sin4_pulse   sin^4(pi t/T) on [0, T]; 0 after
///   block        1 on [0, T); 0 after
///   ricker       (1 - 2a) e^-a on [0, T], a = (13 (t/T - 1/2))^2; 0 before and after, where the
///                wavelet is below 1e-16 of its peak; its peak frequency is 13/(pi T)
///   table        piecewise linear through the points of a table; constant after its last one;
///                a first value other than 0 at t = 0, or a time given twice, is a jump
class Load {
 public:
  Load() = default;
  /// Throws InputError for a duration that is not positive where the shape has one.
  Load(LoadShape shape, double magnitude, double duration = 0.0);
  /// A table; times from >= 0 on, not descending. Throws InputError otherwise.
  Load(double magnitude, std::vector<double> times, std::vector<double> values);

  LoadShape shape() const { return shape_; }
  double magnitude() const { return magnitude_; }
  double duration() const { return duration_; }
  const std::vector<double>& times() const { return times_; }
  const std::vector<double>& values() const { return values_; }

  /// q(t); at a jump the value after it.
  double value(double t) const;
  /// Impulse, the integral of q from 0 to t, in closed form.
  double impulse(double t) const;
  /// Mean of q over [t0, t1]: what a time step feels, jumps included.
  double mean(double t0, double t1) const { return (impulse(t1) - impulse(t0)) / (t1 - t0); }
  /// Largest |q| at any time.
  double peak() const;

 private:
  double unit_value(double t) const;
  double unit_impulse(double t) const;

  LoadShape shape_ = LoadShape::step;
  double magnitude_ = 1.0;
  double duration_ = 0.0;
  std::vector<double> times_;
  std::vector<double> values_;
};

/// True for the shapes that have a duration.
bool has_duration(LoadShape shape);

/// Reads [load]; a table's file (CSV, columns t,value) is found relative to the TOML file.
Load read_load(const TomlDocument& document);

}  // namespace porowave
