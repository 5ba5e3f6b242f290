#include "reference/column_solution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/inversion.hpp"
#include "reference/problem/errors.hpp"

namespace porowave::reference {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// Relative error of an arrival time: a few roundings of speeds, paths and their sum.
constexpr double arrival_rounding = 8.0 * epsilon;
/// Arrivals whose ages differ by more than this factor want contours of different size.
constexpr double similar_age = 8.0;

Fields fields_of(const FourSums& sums) {
  return {sums[0], sums[1], sums[2], sums[3]};
}

BoundedFields unresolved() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double inf = std::numeric_limits<double>::infinity();
  return {{nan, nan, nan, nan}, {inf, inf, inf, inf}};
}

void require_inside(const Column& column, double x, double t) {
  const bool inside = x >= 0.0 && (!column.length || x <= *column.length);
  if (std::isfinite(x) && std::isfinite(t) && inside) return;
  throw InputError(fmt::format(
      "reference at x = {}, t = {}: expected finite numbers and x in the column, from 0{}", x, t,
      column.length ? fmt::format(" to {}", *column.length) : std::string()));
}

/// What has arrived of the load with every ray: first what has settled, then what is passing, each
/// with the oldest first.
std::vector<Arrival> arrivals_of(const std::vector<Ray>& rays, const LoadTransform& load,
                                 double t) {
  std::vector<Arrival> arrivals;
  for (const Ray& ray : rays) {
    const double tau = t - ray.arrival;
    if (tau < 0.0) continue;
    if (!load.passing(tau)) {
      arrivals.push_back({ray, Arrival::Part::settled, 0, tau});
    } else if (load.without_events()) {
      arrivals.push_back({ray, Arrival::Part::passing, 0, tau});
    } else {
      for (std::size_t e = 0; e < load.event_times().size(); ++e) {
        const double since = tau - load.event_times()[e];
        if (since >= 0.0) arrivals.push_back({ray, Arrival::Part::event, e, since});
      }
    }
  }
  const auto passing = [](const Arrival& a) { return a.part != Arrival::Part::settled; };
  std::sort(arrivals.begin(), arrivals.end(), [&](const Arrival& a, const Arrival& b) {
    return passing(a) != passing(b) ? passing(b) : a.since > b.since;
  });
  return arrivals;
}

/// The number of arrivals at the start of the list that can share a contour. What passes never
/// shares one with what has settled: the powers of 1/s in its events want a contour of its own
/// size.
std::size_t similar(std::span<const Arrival> arrivals, double shortest) {
  const double oldest = std::max(arrivals.front().since, shortest);
  std::size_t count = 0;
  while (count < arrivals.size() && arrivals[count].part == arrivals.front().part &&
         std::max(arrivals[count].since, shortest) * similar_age >= oldest) {
    ++count;
  }
  return count;
}

}  // namespace

ColumnSolution::ColumnSolution(const Problem& problem)
    : problem_(problem), modes_(problem.material) {}

BoundedFields ColumnSolution::at(double x, double t) const {
  require_inside(problem_.column, x, t);
  if (t < 0.0) return {};
  const double uncertainty = arrival_rounding * t;
  const auto rays = rays_until(problem_, modes_, x, t + uncertainty);
  if (rays.size() > most_rays) return unresolved();
  const LoadTransform load(problem_.load);
  FourSums value{};
  FourSums error{};
  add_fronts(rays, load, t, value, error);
  if (t == 0.0) return {fields_of(value), fields_of(error)};

  const auto arrivals = arrivals_of(rays, load, t);
  const Inversion inversion(problem_, modes_, load, t);
  // Ages below 1/|singularities| do not need a contour of their own.
  const double shortest = 1.0 / std::max(modes_.relaxation_rate(), std::abs(modes_.branch_point()));
  std::span<const Arrival> rest(arrivals);
  while (!rest.empty()) {
    const std::size_t count = similar(rest, shortest);
    // The sum over rays wants them in the order of their crossings.
    std::vector<Arrival> group(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(count));
    std::stable_sort(group.begin(), group.end(), [](const Arrival& a, const Arrival& b) {
      return a.ray.crossings < b.ray.crossings;
    });
    const Inverted part = inversion.invert(group);
    for (std::size_t f = 0; f < 4; ++f) {
      value[f] += part.value[f];
      error[f] += part.error[f];
    }
    rest = rest.subspan(count);
  }
  // A bound as large as the load says nothing; such a value is not given at all.
  const FourSums unit = unit_fields(problem_);
  for (std::size_t f = 0; f < 4; ++f) {
    if (!(error[f] < unit[f] * load.peak())) return unresolved();
  }
  return {fields_of(value), fields_of(error)};
}

void ColumnSolution::add_fronts(const std::vector<Ray>& rays, const LoadTransform& load, double t,
                                FourSums& value, FourSums& error) const {
  const double uncertainty = arrival_rounding * t;
  const FourSums unit = unit_fields(problem_);
  RaySum frozen(problem_, modes_, rays);
  frozen.at(modes_.frozen(), [&](std::size_t r, const FieldVector& wave, Complex exponent) {
    const double decay = std::exp(exponent.real());
    const double since = t - rays[r].arrival;
    // A front with nothing behind it yet, and the part of a passing load at infinite s.
    const bool at_front = t == 0.0 || (load.without_events() && load.passing(since));
    const double q = at_front && since >= 0.0 ? load.value(since) : 0.0;
    for (std::size_t f = 0; f < 4; ++f) {
      const double size = wave[f].real() * decay;
      value[f] += size * q;
      error[f] += 8.0 * epsilon * (std::abs(size) + decay * unit[f]) * std::abs(q);
      for (const auto& [time, jump] : load.jumps()) {
        if (std::abs(since - time) <= uncertainty) error[f] += std::abs(size * jump);
      }
    }
  });
}

std::vector<double> ColumnSolution::fronts(double t) const {
  std::vector<double> positions;
  const double length = problem_.column.length.value_or(std::numeric_limits<double>::infinity());
  for (const double x : {0.0, problem_.column.length.value_or(0.0)}) {
    for (const Ray& ray : rays_until(problem_, modes_, x, t)) {
      const double ahead = modes_.speed(ray.mode) * (t - ray.arrival);
      const double position = ray.upwards() ? x + ahead : x - ahead;
      // A ray seen at its start; those that started at the other end are found there.
      const bool starts_here = ray.upwards() == (x == 0.0);
      if (starts_here && position >= 0.0 && position <= length) positions.push_back(position);
    }
  }
  std::sort(positions.begin(), positions.end());
  positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
  return positions;
}

}  // namespace porowave::reference
