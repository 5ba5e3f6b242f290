#pragma once

#include <span>
#include <vector>

#include "reference/boundary.hpp"

namespace porowave::reference {

/// One term of the expansion of a finite column into images: a wave that has crossed the column
/// `crossings` times, `slow_crossings` of them as P2, and runs its last, unfinished leg as `mode`.
/// It contributes amplitude * e^(-lambda_1 path_1 - lambda_2 path_2), which is exactly zero before
/// `arrival`; behind it, e^(-excess . path) is analytic at s = infinity.
struct Ray {
  int crossings;
  int slow_crossings;
  int mode;
  double arrival;              ///< s
  std::array<double, 2> path;  ///< m travelled as P1, as P2
  bool upwards() const { return crossings % 2 == 0; }
};

/// More rays than this are not followed.
inline constexpr std::size_t most_rays = 200'000;

/// All rays that reach x by time `until`, in order of `crossings`; a list longer than most_rays is
/// not complete.
std::vector<Ray> rays_until(const Problem& problem, const WaveModes& modes, double x, double until);

/// What all rays share at one s.
struct WaveState {
  ModeState modes;
  EndResponse ends;
  ModeFields fields;
};
WaveState wave_state(const Problem& problem, const WaveModes& modes, const ModeState& state);

/// Contribution of each ray to the four fields at one s, without the load and without the factor
/// e^(-s arrival): amplitude * field of the mode, and the exponent -excess . path of its decay,
/// which may be large and is to be combined with that of the load before either is taken.
class RaySum {
 public:
  /// Rays in order of `crossings`; they must outlive the sum.
  RaySum(const Problem& problem, std::span<const Ray> rays);

  /// Calls use(ray index, fields, exponent) for every ray.
  template <class Use>
  void at(const WaveState& state, Use&& use);

 private:
  /// Amplitude of a ray, by recursion over the crossings where ends convert modes.
  Complex amplitude(const EndResponse& ends, const Ray& ray);
  /// Amplitudes after one more crossing, split by the number of crossings made as P2.
  void advance(const Reflection& reflection);

  bool converts_;
  std::span<const Ray> rays_;
  int generation_ = 0;
  std::vector<Amplitudes> amplitudes_;  ///< [slow crossings], of the current generation
};

template <class Use>
void RaySum::at(const WaveState& state, Use&& use) {
  amplitudes_.assign(1, state.ends.source);
  generation_ = 0;
  for (std::size_t r = 0; r < rays_.size(); ++r) {
    const Ray& ray = rays_[r];
    const auto mode = static_cast<std::size_t>(ray.mode);
    const Complex factor = amplitude(state.ends, ray);
    FieldVector contribution = ray.upwards() ? state.fields.up[mode] : state.fields.down[mode];
    for (Complex& field : contribution) field *= factor;
    use(r, contribution,
        -(state.modes.excess[0] * ray.path[0] + state.modes.excess[1] * ray.path[1]));
  }
}

}  // namespace porowave::reference
