#include "verification/wave_measures/gap_amplitudes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "verification/not_a_number.hpp"
#include "verification/wave_measures/arrival_delay.hpp"

namespace porowave::verification {

namespace {

/// Sums of a least-squares fit of `values` by a multiple of `shape`.
struct Fit {
  double product = 0.0;
  double square = 0.0;
  void add(double value, double shape) {
    product += value * shape;
    square += shape * shape;
  }
  double factor() const {
    return square > 0.0 ? product / square : std::numeric_limits<double>::quiet_NaN();
  }
};

std::size_t element_of(double x, double spacing, std::size_t elements) {
  const double last = static_cast<double>(elements) - 1.0;
  return static_cast<std::size_t>(std::clamp(std::floor(x / spacing), 0.0, last));
}

}  // namespace

GapAmplitudes gap_amplitudes(const solver::Case& scene, const solver::Snapshot& snapshot,
                             const ReferenceValues& reference) {
  const auto& empty = scene.discretization.empty_elements;
  if (empty.empty()) return {nan, nan};
  const double h = spacing(snapshot);
  const std::size_t cells = snapshot.cell_x.size();
  const auto [least, most] = std::minmax_element(empty.begin(), empty.end());
  const std::size_t first = element_of(*least, h, cells);
  const std::size_t behind = element_of(*most, h, cells) + 1;
  const double load_side = h * static_cast<double>(first);
  const double far_side = h * static_cast<double>(behind);

  const ModeAmplitudes amplitudes(scene.problem.material);
  const double c = amplitudes.speed(0);
  const double front = c * snapshot.time;
  const bool passed = front - c * rise_time(scene.problem.load) >= far_side;
  const bool from_near_end = front > 3.0 * load_side;
  const bool from_far_end = scene.problem.column.far != FarEnd::half_space &&
                            front > 2.0 * snapshot.node_x.back() - far_side;
  if (!passed || from_near_end || from_far_end) return {nan, nan};

  const auto found = amplitudes.of(0, grid_fields(snapshot));
  const auto exact = amplitudes.of(0, grid_fields(reference));
  Fit reflected;
  for (std::size_t i = 0; i < first && first + i < cells; ++i) {
    const std::size_t before = first - 1 - i;
    reflected.add(found.down[before] - exact.down[before], exact.up[first + i]);
  }
  Fit transmitted;
  for (std::size_t i = behind; i < cells; ++i) transmitted.add(found.up[i], exact.up[i]);
  return {reflected.factor(), transmitted.factor()};
}

}  // namespace porowave::verification
