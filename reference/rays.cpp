#include "reference/rays.hpp"

#include <algorithm>

namespace porowave::reference {

std::vector<Ray> rays_until(const Problem& problem, const WaveModes& modes, double x,
                            double until) {
  std::vector<Ray> rays;
  const bool conversion = converts(problem.column.near) || converts(problem.column.far);
  const bool ends = problem.column.length.has_value();
  const double length = problem.column.length.value_or(0.0);
  for (int crossings = 0; (crossings == 0 || ends) && rays.size() <= most_rays; ++crossings) {
    const double last_leg = crossings % 2 == 0 ? x : length - x;
    bool any = false;
    // Without conversion a wave stays what it was.
    const int step = conversion ? 1 : std::max(1, crossings);
    for (int slow = 0; slow <= crossings; slow += step) {
      for (int mode = 0; mode < 2; ++mode) {
        if (!conversion && slow != (mode == 0 ? 0 : crossings)) continue;
        Ray ray{crossings, slow, mode, 0.0, {(crossings - slow) * length, slow * length}};
        ray.path[static_cast<std::size_t>(mode)] += last_leg;
        ray.arrival = ray.path[0] / modes.speed(0) + ray.path[1] / modes.speed(1);
        if (ray.arrival > until) continue;
        rays.push_back(ray);
        any = true;
      }
    }
    // The fastest ray of a generation is later than that of the one before: none is to come.
    if (!any && crossings * length > until * modes.speed(0)) break;
  }
  return rays;
}

WaveState wave_state(const Problem& problem, const WaveModes& modes, const ModeState& state) {
  return {state, end_response(problem, modes, state), mode_fields(problem.material, modes, state)};
}

RaySum::RaySum(const Problem& problem, std::span<const Ray> rays)
    : converts_(converts(problem.column.near) || converts(problem.column.far)), rays_(rays) {}

Complex RaySum::amplitude(const EndResponse& ends, const Ray& ray) {
  const auto mode = static_cast<std::size_t>(ray.mode);
  if (!converts_) {
    // Both reflections are +-1 times the identity.
    const bool far = (ray.crossings + 1) / 2 % 2 == 1;
    const bool near = ray.crossings / 2 % 2 == 1;
    return ends.source[mode] *
           ((far ? ends.at_far[0][0].real() : 1.0) * (near ? ends.at_near[0][0].real() : 1.0));
  }
  for (; generation_ < ray.crossings; ++generation_) {
    advance(generation_ % 2 == 0 ? ends.at_far : ends.at_near);
  }
  return amplitudes_[static_cast<std::size_t>(ray.slow_crossings)][mode];
}

void RaySum::advance(const Reflection& reflection) {
  std::vector<Amplitudes> next(amplitudes_.size() + 1, Amplitudes{});
  for (std::size_t slow = 0; slow < amplitudes_.size(); ++slow) {
    for (std::size_t mode = 0; mode < 2; ++mode) {
      // Crossing as P2 counts one slow crossing more; then the end reflects.
      const Complex arriving = amplitudes_[slow][mode];
      next[slow + mode][0] += reflection[0][mode] * arriving;
      next[slow + mode][1] += reflection[1][mode] * arriving;
    }
  }
  amplitudes_.swap(next);
}

}  // namespace porowave::reference
