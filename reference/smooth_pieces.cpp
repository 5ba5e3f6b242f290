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

  /// Widths on either side within which what has been smeared lies.
  static constexpr double widths = 7.0;

  /// Standard deviation, in time, after a path.
  double smeared(double path) const { return std::sqrt(2.0 * spreading * path); }
  /// A front that has not been used up by drag is the sharper feature.
  bool felt(double path) const { return solution.modes().frozen().excess[0].real() * path >= 3.0; }

  void add_to(std::vector<double>& places, double t) const {
    const double c = solution.modes().undrained_speed();
    const double path = c * t;
    if (!felt(path)) return;
    const double width = c * smeared(path);
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

  /// Times at which they come back to x = 0.
  void add_returns_to(std::vector<double>& times, double end) const {
    const auto length = solution.problem().column.length;
    if (!length) return;
    const double c = solution.modes().undrained_speed();
    for (double path = 2.0 * *length; path < c * end; path += 2.0 * *length) {
      if (!felt(path)) continue;
      for (const double w : {-widths, 0.0, widths}) times.push_back(path / c + w * smeared(path));
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

/// Drops what lies outside of 0 .. end; places closer than rounding are one.
std::vector<double> sorted_ends(std::vector<double> ends, double end) {
  ends.erase(
      std::remove_if(ends.begin(), ends.end(), [end](double x) { return !(x >= 0.0 && x <= end); }),
      ends.end());
  std::sort(ends.begin(), ends.end());
  const auto same = [end](double a, double b) { return b - a <= 1e-13 * end; };
  ends.erase(std::unique(ends.begin(), ends.end(), same), ends.end());
  ends.back() = end;
  return ends;
}

/// Fronts below e^-45 of what they were do not count.
constexpr double used_up = 45.0;

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
  return sorted_ends(std::move(ends), end);
}

std::vector<double> smooth_times(const ColumnSolution& solution, double end) {
  const Problem& problem = solution.problem();
  const ModeState frozen = solution.modes().frozen();
  std::vector<double> arrivals;
  for (const Ray& ray : rays_until(problem, solution.modes(), 0.0, end)) {
    const double decay =
        frozen.excess[0].real() * ray.path[0] + frozen.excess[1].real() * ray.path[1];
    if (decay < used_up) arrivals.push_back(ray.arrival);
  }
  UndrainedWaves(solution).add_returns_to(arrivals, end);
  std::vector<double> ends = {0.0, end};
  for (const double time : load_breaks(problem.load)) {
    for (const double arrival : arrivals) ends.push_back(arrival + time);
  }
  return sorted_ends(std::move(ends), end);
}

}  // namespace porowave::reference
