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

/// Contribution of each ray to the four fields at one s, without the load and without the factor
/// e^(-s arrival): amplitude * field of the mode, and the exponent -excess . path of its decay,
/// which may be large and is to be combined with that of the load before either is taken.
class RaySum {
 public:
  RaySum(const Problem& problem, const WaveModes& modes, std::span<const Ray> rays);

  /// Calls use(ray index, fields, exponent) for every ray.
  template <class Use>
  void at(const ModeState& state, Use&& use);

 private:
  /// Amplitudes after one more crossing, split by the number of crossings made as P2.
  void advance(const Reflection& reflection);

  const Problem& problem_;
  const WaveModes& modes_;
  std::span<const Ray> rays_;
  std::vector<Amplitudes> amplitudes_;  ///< [slow crossings], of the current generation
};

template <class Use>
void RaySum::at(const ModeState& state, Use&& use) {
  const EndResponse ends = end_response(problem_, modes_, state);
  const ModeFields fields = mode_fields(problem_.material, modes_, state);
  amplitudes_.assign(1, ends.source);
  int generation = 0;
  for (std::size_t r = 0; r < rays_.size(); ++r) {
    const Ray& ray = rays_[r];
    for (; generation < ray.crossings; ++generation) {
      advance(generation % 2 == 0 ? ends.at_far : ends.at_near);
    }
    const auto mode = static_cast<std::size_t>(ray.mode);
    const Complex amplitude = amplitudes_[static_cast<std::size_t>(ray.slow_crossings)][mode];
    FieldVector contribution = ray.upwards() ? fields.up[mode] : fields.down[mode];
    for (Complex& field : contribution) field *= amplitude;
    use(r, contribution, -(state.excess[0] * ray.path[0] + state.excess[1] * ray.path[1]));
  }
}

}  // namespace porowave::reference
