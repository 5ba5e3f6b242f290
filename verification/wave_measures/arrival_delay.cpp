#include "verification/wave_measures/arrival_delay.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "reference/waves.hpp"
#include "verification/not_a_number.hpp"

namespace porowave::verification {

namespace {

/// A front is one if its rise is at least this share of the largest amplitude anywhere.
constexpr double least_share = 0.05;
/// Levels are looked up within this share of the rise, off its ends.
constexpr double level_margin = 0.1;
/// Keeps the two nodes of a mean to one side of a jump.
constexpr double half = 0.5 * (1.0 + 1e-9);

/// The part of a column in which a wave rises.
struct Rise {
  double behind;  ///< m
  double ahead;   ///< m
  double speed;   ///< m/s
};

Rise rise_of(const Problem& problem, int mode, double t) {
  const reference::WaveModes modes(problem.material);
  const double c = modes.speed(mode);
  const double since = t - rise_time(problem.load);
  const double halved = std::numbers::ln2;
  const double excess = modes.frozen().excess[static_cast<std::size_t>(mode)].real();
  if (mode != 0 || excess * c * t < halved || reference::undrained_mode(modes) != 0) {
    return {c * since, c * t, c};
  }
  // Drag spreads the wave like diffusion over sqrt((c_1^2 - c_u^2) t/relaxation_rate) (Whitham,
  // Linear and Nonlinear Waves (1974), section 10.1).
  const double undrained = modes.undrained_speed();
  const double width = std::sqrt((c - undrained) * (c + undrained) * t / modes.relaxation_rate());
  return {undrained * since - 3.0 * width, std::min(c * t, undrained * t + 3.0 * width), undrained};
}

/// The reference's amplitude of one wave over its rise, with the means that the samples have.
class Front {
 public:
  Front(const ModeAmplitudes& amplitudes, int mode, const reference::Profile& profile,
        const Rise& rise, double spacing)
      : amplitudes_(amplitudes),
        mode_(mode),
        profile_(profile),
        spacing_(spacing),
        begin_(rise.behind - half * spacing),
        end_(rise.ahead + half * spacing),
        ahead_(at(end_)),
        jump_(at(begin_) - ahead_) {}

  double jump() const { return jump_; }
  double middle() const { return ahead_ + 0.5 * jump_; }
  /// True where the wave has arrived.
  bool reached(double amplitude) const { return (amplitude - middle()) * jump_ >= 0.0; }

  /// Where the amplitude has a value.
  double place_of(double amplitude) const {
    const double share = std::clamp((amplitude - ahead_) / jump_, level_margin, 1 - level_margin);
    const auto excess = [&](double x) { return (at(x) - ahead_) / jump_ - share; };
    std::uintmax_t evaluations = 100;
    const double resolution = 1e-9 * spacing_;
    const auto [low, high] = boost::math::tools::toms748_solve(
        excess, begin_, end_, 1.0 - share, -share,
        [&](double a, double b) { return std::abs(b - a) <= resolution; }, evaluations);
    return 0.5 * (low + high);
  }

 private:
  double at(double x) const {
    Fields fields = profile_.at(x);
    const Fields left = profile_.at(x - 0.5 * spacing_);
    const Fields right = profile_.at(x + 0.5 * spacing_);
    fields.solid_velocity = 0.5 * (left.solid_velocity + right.solid_velocity);
    fields.fluid_velocity = 0.5 * (left.fluid_velocity + right.fluid_velocity);
    return amplitudes_.at(mode_, fields).up;
  }

  const ModeAmplitudes& amplitudes_;
  int mode_;
  const reference::Profile& profile_;
  double spacing_;
  double begin_;
  double end_;
  double ahead_;
  double jump_;
};

/// How far the solution is ahead of the reference's front, m; none where it does not pass it.
std::optional<double> advance(const Front& front, const std::vector<double>& x,
                              const std::vector<double>& amplitude, double from, double to) {
  const auto begin = std::lower_bound(x.begin(), x.end(), from) - x.begin();
  auto c = std::upper_bound(x.begin(), x.end(), to) - x.begin() - 1;
  const auto value = [&](std::ptrdiff_t i) { return amplitude[static_cast<std::size_t>(i)]; };
  for (auto i = begin; i <= c; ++i) {
    if (!std::isfinite(value(i))) return std::nullopt;
  }
  if (c < begin || front.reached(value(c))) return std::nullopt;
  while (--c >= begin && !front.reached(value(c))) {
  }
  if (c < begin) return std::nullopt;
  const auto distance = [&](std::ptrdiff_t i) {
    return x[static_cast<std::size_t>(i)] - front.place_of(value(i));
  };
  return std::lerp(distance(c), distance(c + 1),
                   (value(c) - front.middle()) / (value(c) - value(c + 1)));
}

double largest(const std::vector<double>& values) {
  double size = 0.0;
  for (const double v : values) size = std::max(size, std::abs(v));
  return size;
}

}  // namespace

double rise_time(const Load& load) {
  switch (load.shape()) {
    case LoadShape::step:
    case LoadShape::block:
      return 0.0;
    case LoadShape::smooth_ramp:
      return load.duration();
    case LoadShape::sin4_pulse:
    case LoadShape::ricker:
      return 0.5 * load.duration();
    case LoadShape::table:
      break;
  }
  const auto& values = load.values();
  const auto peak = std::max_element(values.begin(), values.end(),
                                     [](double a, double b) { return std::abs(a) < std::abs(b); });
  return load.times()[static_cast<std::size_t>(peak - values.begin())];
}

std::array<double, 2> arrival_delays(const Problem& problem, const reference::Profile& profile,
                                     const solver::Snapshot& snapshot,
                                     const ReferenceValues& reference) {
  const ModeAmplitudes amplitudes(problem.material);
  const double h = spacing(snapshot);
  const double most = std::max(largest(amplitudes.of(0, grid_fields(reference)).up),
                               largest(amplitudes.of(1, grid_fields(reference)).up));
  std::array<double, 2> delays = {nan, nan};
  for (const int mode : {0, 1}) {
    const Rise rise = rise_of(problem, mode, snapshot.time);
    if (!(rise.behind >= 2.0 * h && rise.ahead + h <= snapshot.node_x.back())) continue;
    const Front front(amplitudes, mode, profile, rise, h);
    if (!(std::abs(front.jump()) >= least_share * most)) continue;
    const double margin = std::max(8.0 * h, 4.0 * std::cbrt(rise.ahead * h * h));
    const auto found =
        advance(front, snapshot.cell_x, amplitudes.of(mode, grid_fields(snapshot)).up,
                rise.behind - margin, rise.ahead + margin);
    if (found) delays[static_cast<std::size_t>(mode)] = -*found / rise.speed;
  }
  return delays;
}

}  // namespace porowave::verification
