#include "reference/smooth_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "reference/rays.hpp"

namespace porowave::reference {

namespace {

/// Times at which the load or its derivatives break; each travels with every ray.
std::vector<double> load_breaks(const Load& load) {
  if (load.shape() == LoadShape::table) return load.times();
  if (has_duration(load.shape())) return {0.0, load.duration()};
  return {0.0};
}

/// Where waves that started at an end at time 0 and have kept to the fast mode are at time t, and
/// how far they have smeared: the undrained wave behind a front that drag has used up.
struct UndrainedWaves {
  const ColumnSolution& solution;
  double spreading;  ///< a in lambda_1 = s/c - a s^2 for small s

  explicit UndrainedWaves(const ColumnSolution& column) : solution(column) {
    const WaveModes& modes = solution.modes();
    const double s = 1e-3 * modes.relaxation_rate();
    const double lambda = (s * modes.at(s, WaveModes::Cut::outwards).slowness[0]).real();
    spreading = std::max(0.0, (s / modes.undrained_speed() - lambda) / (s * s));
  }

  void add_to(std::vector<double>& places, double t) const {
    constexpr double widths = 7.0;
    const WaveModes& modes = solution.modes();
    const double c = modes.undrained_speed();
    const double path = c * t;
    // A front that has not been used up by drag is the sharper feature.
    if (modes.frozen().excess[0].real() * path < 3.0) return;
    const double width = c * std::sqrt(2.0 * spreading * path);
    const auto length = solution.problem().column.length;
    const double crossings = length ? std::floor(path / *length) : 0.0;
    const double along = length ? path - crossings * *length : path;
    const bool up = !length || std::fmod(crossings, 2.0) == 0.0;
    const double place = up ? along : *length - along;
    for (const double w : {-widths, 0.0, widths}) places.push_back(place + w * width);
    // Part of the smeared wave may be on its way back already.
    if (length) {
      for (const double end : {0.0, *length}) places.push_back(2.0 * end - place + widths * width);
      for (const double end : {0.0, *length}) places.push_back(2.0 * end - place - widths * width);
    }
  }
};

/// Depth of a consolidation layer after time t: the second mode diffuses, lambda_2^2 = s/c_v.
double layer_depth(const WaveModes& modes, double t) {
  constexpr double widths = 6.0;
  const double s = 1e-6 * modes.relaxation_rate();
  const double slowness = modes.at(s, WaveModes::Cut::outwards).slowness[1].real();
  return widths * 2.0 * std::sqrt(t / s) / slowness;
}

}  // namespace

std::vector<double> smooth_pieces(const ColumnSolution& solution, double t, double end) {
  std::vector<double> ends = {0.0, end};
  const UndrainedWaves undrained(solution);
  const double length = solution.problem().column.length.value_or(end);
  for (const double time : load_breaks(solution.problem().load)) {
    if (t <= time) continue;
    for (const double x : solution.fronts(t - time)) ends.push_back(x);
    undrained.add_to(ends, t - time);
    const double depth = layer_depth(solution.modes(), t - time);
    if (depth > length) continue;
    for (const double share : {1.0, 0.1}) {
      ends.push_back(share * depth);
      ends.push_back(length - share * depth);
    }
  }
  ends.erase(
      std::remove_if(ends.begin(), ends.end(), [end](double x) { return !(x >= 0.0 && x <= end); }),
      ends.end());
  std::sort(ends.begin(), ends.end());
  // Places closer than rounding are one.
  const auto same = [end](double a, double b) { return b - a <= 1e-13 * end; };
  ends.erase(std::unique(ends.begin(), ends.end(), same), ends.end());
  ends.back() = end;
  return ends;
}

}  // namespace porowave::reference
