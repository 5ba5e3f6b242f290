#include "reference/modal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "reference/constants.hpp"
#include "reference/modal_modes.hpp"
#include "reference/problem/errors.hpp"
#include "reference/sine_transform.hpp"

namespace porowave::reference {

namespace {

using Four = std::array<double, 4>;

constexpr std::size_t fewest_modes = 64;
constexpr std::size_t most_modes = 131'072;
/// Modes are added until the slowest of them turns by this angle within the load at least: before,
/// small amplitudes do not mean that later ones are small.
constexpr double least_angle = 40.0;

Fields as_fields(const Four& f) {
  return {f[0], f[1], f[2], f[3]};
}

}  // namespace

struct ModalSolution::State {
  double length;
  quarter_wave::Frame frame;
  std::array<std::vector<double>, 4> modes;       ///< amplitudes of the fields, layers removed
  std::optional<quarter_wave::EndLayers> layers;  ///< none before the load begins
  Four error{};

  explicit State(const Problem& problem) : length(*problem.column.length), frame(problem) {}

  double wave_number(std::size_t n) const {
    return (static_cast<double>(n) + 0.5) * std::numbers::pi / length;
  }
  void add_modes(const quarter_wave::SmoothLoad& load, double t, std::size_t until);
  void sum_modes(const Problem& problem, double t, double tolerance);
  Four layer_fields(double x) const { return frame.fields(layers->at(x)); }
};

void ModalSolution::State::add_modes(const quarter_wave::SmoothLoad& load, double t,
                                     std::size_t until) {
  for (std::size_t n = modes[0].size(); n < until; ++n) {
    const double k = wave_number(n);
    const double share = 2.0 / (length * k);
    const auto whole = quarter_wave::mode_amplitudes(frame, load, t, k, share);
    const auto removed = layers->coefficients(k, share);
    quarter_wave::Amplitudes rest;
    quarter_wave::Amplitudes size;
    for (std::size_t f = 0; f < 4; ++f) {
      rest[f] = whole[f] - removed[f];
      size[f] = std::abs(whole[f]) + std::abs(removed[f]);
    }
    const Four fields = frame.fields(rest);
    // Phases have the rounding of k c t.
    const double rounding = epsilon * (8.0 + k * frame.speed()[0] * t);
    const double stress = rounding * std::hypot(size[0], size[1]);
    const double velocity = rounding * std::hypot(size[2], size[3]);
    const Four a = frame.fields({stress, 0.0, velocity, 0.0});
    const Four b = frame.fields({0.0, stress, 0.0, velocity});
    for (std::size_t f = 0; f < 4; ++f) {
      modes[f].push_back(fields[f]);
      error[f] += std::abs(a[f]) + std::abs(b[f]);
    }
  }
}

void ModalSolution::State::sum_modes(const Problem& problem, double t, double tolerance) {
  const quarter_wave::SmoothLoad load(problem.load, t);
  layers.emplace(frame, load, length, problem.load.peak());
  const double stress = problem.stress_scale();
  const double velocity = problem.velocity_scale();
  const Four unit = {stress, stress, velocity, velocity};
  const double shortest = std::min(t, problem.load.duration());
  Four tail{};
  for (std::size_t count = fewest_modes; count <= most_modes; count *= 2) {
    add_modes(load, t, count);
    // Amplitudes fall off like n^-4 or faster, so the sum of those to come is below a third of
    // count times the last one; the largest of the last half stands for it, since phases vary.
    double worst = 0.0;
    for (std::size_t f = 0; f < 4; ++f) {
      tail[f] = 0.0;
      for (std::size_t n = count / 2; n < count; ++n) {
        const double scaled = std::pow(static_cast<double>(n) / static_cast<double>(count), 4);
        tail[f] = std::max(tail[f], std::abs(modes[f][n]) * scaled);
      }
      tail[f] *= static_cast<double>(count) / 2.0;
      worst = std::max(worst, tail[f] / unit[f]);
    }
    const bool resolved = wave_number(count) * frame.speed()[1] * shortest > least_angle &&
                          wave_number(count) > 2.0 * layers->steepest();
    if (resolved && worst < tolerance) break;
  }
  const double rounding = 16.0 * epsilon * layers->size();
  const Four a = frame.fields({rounding, 0.0, rounding, 0.0});
  const Four b = frame.fields({0.0, rounding, 0.0, rounding});
  for (std::size_t f = 0; f < 4; ++f) error[f] += tail[f] + std::abs(a[f]) + std::abs(b[f]);
}

std::string ModalSolution::obstacle(const Problem& problem) {
  const Column& column = problem.column;
  if ((column.near != NearEnd::drained_traction && column.near != NearEnd::fluid_pressure) ||
      column.far != FarEnd::rigid_sealed || !column.length) {
    return fmt::format(
        "modal: near = \"{}\", far = \"{}\": expected near = \"drained_traction\" or "
        "\"fluid_pressure\" and far = \"rigid_sealed\"",
        name(column.near), name(column.far));
  }
  if (!quarter_wave::is_smooth(problem.load)) {
    return fmt::format("modal: load shape = \"{}\": expected smooth_ramp, sin4_pulse or ricker",
                       name(problem.load.shape()));
  }
  return "";
}

ModalSolution::ModalSolution(const Problem& problem, double t, double tolerance) {
  if (const std::string reason = obstacle(problem); !reason.empty()) throw InputError(reason);
  if (!std::isfinite(t) || !(tolerance > 0.0 && tolerance < 1.0)) {
    throw InputError(
        fmt::format("modal: t = {}, tolerance = {}: expected a finite time and a "
                    "tolerance > 0 and < 1",
                    t, tolerance));
  }
  auto state = std::make_unique<State>(problem);
  if (t > 0.0) state->sum_modes(problem, t, tolerance);
  state_ = std::move(state);
}

ModalSolution::~ModalSolution() = default;
ModalSolution::ModalSolution(ModalSolution&&) noexcept = default;
ModalSolution& ModalSolution::operator=(ModalSolution&&) noexcept = default;

std::size_t ModalSolution::modes() const {
  return state_->modes[0].size();
}

BoundedFields ModalSolution::at(double x) const {
  if (!(x >= 0.0 && x <= state_->length)) {
    throw InputError(
        fmt::format("modal: x = {}: expected a number from 0 to {}", x, state_->length));
  }
  if (!state_->layers) return {};
  Four sum{};
  const auto& modes = state_->modes;
  // Small ones first: thousands of them, each below the rounding of the whole, count together.
  for (std::size_t n = modes[0].size(); n-- > 0;) {
    const double phase = state_->wave_number(n) * x;
    const double sine = std::sin(phase);
    // The last node of the cosines is exact.
    const double cosine = x == state_->length ? 0.0 : std::cos(phase);
    sum[0] += modes[0][n] * sine;
    sum[1] += modes[1][n] * sine;
    sum[2] += modes[2][n] * cosine;
    sum[3] += modes[3][n] * cosine;
  }
  const Four layers = state_->layer_fields(x);
  for (std::size_t f = 0; f < 4; ++f) sum[f] += layers[f];
  return {as_fields(sum), as_fields(state_->error)};
}

std::vector<BoundedFields> ModalSolution::on_grid(int intervals) const {
  if (intervals < 1) {
    throw InputError(fmt::format("modal: {} intervals: expected at least 1", intervals));
  }
  const auto count = static_cast<std::size_t>(intervals);
  std::vector<BoundedFields> grid(count + 1);
  if (!state_->layers) return grid;
  std::array<std::vector<double>, 4> sums;
  for (std::size_t f = 0; f < 4; ++f) {
    sums[f] = f < 2 ? quarter_wave_sines(state_->modes[f], count)
                    : quarter_wave_cosines(state_->modes[f], count);
  }
  for (std::size_t j = 0; j <= count; ++j) {
    const double x = state_->length * static_cast<double>(j) / static_cast<double>(count);
    Four fields = state_->layer_fields(x);
    for (std::size_t f = 0; f < 4; ++f) fields[f] += sums[f][j];
    grid[j] = {as_fields(fields), as_fields(state_->error)};
  }
  return grid;
}

}  // namespace porowave::reference
