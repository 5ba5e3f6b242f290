#include "reference/arrivals.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace porowave::reference {

namespace {

/// Parts whose ages differ by more than this factor want contours of different size.
constexpr double similar_age = 16.0;
constexpr double negligible_exponent = -45.0;

/// Bounds for single arrivals from the size of the Bromwich integrand on the positive real axis.
class Chernoff {
 public:
  Chernoff(const WaveModes& modes, const LoadTransform& load, double t) : load_(load) {
    const double largest = 8.0 * std::max(modes.relaxation_rate(), std::abs(modes.branch_point()));
    for (double s = 0.5 / t; s < std::max(largest, 8.0 / t); s *= 3.0) {
      Line line{s, modes.at(s, WaveModes::Cut::outwards).excess, 0.0};
      const ScaledTransform settled = load.settled(s);
      line.settled = std::log(settled.size * s / load.peak()) + settled.exponent.real();
      if (!std::isnan(line.settled)) lines_.push_back(line);
    }
  }

  /// Logarithm of the bound, as a share of the load.
  double exponent(const Arrival& a) const {
    double least = 0.0;
    for (const Line& line : lines_) {
      const double decay = line.s * a.since - line.excess[0].real() * a.ray.path[0] -
                           line.excess[1].real() * a.ray.path[1];
      // Most lines are far from a new least: look at the load only where it matters.
      if (decay >= least) continue;
      least = std::min(least, decay + load_size(a, line));
    }
    return least;
  }

 private:
  struct Line {
    double s;
    std::array<Complex, 2> excess;
    double settled;
  };

  double load_size(const Arrival& a, const Line& line) const {
    if (a.part == Arrival::Part::settled) return line.settled;
    return std::log(load_.event(a.event, line.s, 0.0).size * line.s / load_.peak());
  }

  const LoadTransform& load_;
  std::vector<Line> lines_;
};

/// Time from which on a ray is felt: of its front, or, once that has decayed, of the undrained wave
/// behind it.
double felt_arrival(const Ray& ray, const WaveModes& modes) {
  constexpr double decayed = 30.0;
  const ModeState frozen = modes.frozen();
  const double decay =
      frozen.excess[0].real() * ray.path[0] + frozen.excess[1].real() * ray.path[1];
  if (decay < decayed) return ray.arrival;
  return ray.path[0] / modes.undrained_speed() + ray.path[1] / modes.speed(1);
}

/// All parts of the load that have arrived with one ray.
void add_parts(const Ray& ray, const WaveModes& modes, const LoadTransform& load, double t,
               double uncertainty, std::vector<Arrival>& arrivals) {
  const double tau = t - ray.arrival;
  const double felt = t - felt_arrival(ray, modes);
  if (tau < -uncertainty) return;
  // An arrival at this very moment is seen just after it.
  const double least = 0.125 * uncertainty;
  if (load.always_whole()) {
    const double age = std::max(tau, load.shortest_scale());
    arrivals.push_back({ray, Arrival::Part::settled, 0, tau - load.end(), age, false});
  } else if (std::min(tau, felt) >= load.end() - uncertainty) {
    const double since = std::max(tau - load.end(), least);
    arrivals.push_back({ray, Arrival::Part::settled, 0, since, since + load.end(), false});
  } else {
    for (std::size_t e = 0; e < load.event_times().size(); ++e) {
      const double since = tau - load.event_times()[e];
      if (since < -uncertainty) continue;
      const double seen = std::max(since, least);
      arrivals.push_back({ray, Arrival::Part::event, e, seen, seen, false});
    }
  }
}

/// Modes that meet right of 0 or high above it cannot be enclosed cheaply; a sum over all of them
/// need not be.
bool steep(const WaveModes& modes) {
  return modes.branch_point().real() > -0.3 * std::abs(modes.branch_point());
}

/// Finds the parts of which all mode combinations with their number of crossings have arrived, and
/// gives them the age of the oldest.
void find_complete(bool conversion, std::vector<Arrival>& arrivals) {
  const auto key = [](const Arrival& a) { return std::tuple(a.ray.crossings, a.part, a.event); };
  std::stable_sort(arrivals.begin(), arrivals.end(),
                   [&](const Arrival& a, const Arrival& b) { return key(a) < key(b); });
  for (auto begin = arrivals.begin(); begin != arrivals.end();) {
    const auto end = std::find_if(begin, arrivals.end(),
                                  [&](const Arrival& a) { return key(a) != key(*begin); });
    const auto all = conversion ? 2 * (begin->ray.crossings + 1) : 2;
    if (end - begin == all) {
      double age = 0.0;
      for (auto a = begin; a != end; ++a) age = std::max(age, a->age);
      for (auto a = begin; a != end; ++a) {
        a->age = age;
        a->complete = true;
      }
    }
    begin = end;
  }
}

}  // namespace

ArrivalGroups arrivals_of(const Problem& problem, const WaveModes& modes, const LoadTransform& load,
                          std::span<const Ray> rays, double t, double uncertainty) {
  ArrivalGroups result;
  std::vector<Arrival> arrivals;
  for (const Ray& ray : rays) add_parts(ray, modes, load, t, uncertainty, arrivals);
  if (steep(modes)) {
    find_complete(converts(problem.column.near) || converts(problem.column.far), arrivals);
  }
  const Chernoff chernoff(modes, load, t);
  const auto negligible = [&](const Arrival& a) {
    const double exponent = chernoff.exponent(a);
    if (exponent > negligible_exponent) return false;
    result.neglected += 8.0 * std::exp(exponent);
    return true;
  };
  arrivals.erase(std::remove_if(arrivals.begin(), arrivals.end(), negligible), arrivals.end());
  const auto kind = [](const Arrival& a) { return std::tuple(a.complete, a.part); };
  std::stable_sort(arrivals.begin(), arrivals.end(), [&](const Arrival& a, const Arrival& b) {
    return kind(a) != kind(b) ? kind(a) > kind(b) : a.age > b.age;
  });
  for (const Arrival& a : arrivals) {
    const bool fits = !result.groups.empty() &&
                      kind(result.groups.back().arrivals.front()) == kind(a) &&
                      result.groups.back().arrivals.front().age < similar_age * a.age;
    if (!fits) result.groups.push_back({{}, a.complete});
    result.groups.back().arrivals.push_back(a);
  }
  return result;
}

}  // namespace porowave::reference
