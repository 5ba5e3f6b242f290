#include "reference/fronts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/load_transform.hpp"
#include "reference/problem/errors.hpp"
#include "reference/rays.hpp"

namespace porowave::reference {

namespace {

struct Departure {
  double time;
  double jump;
};

/// What sends fronts off: the jumps of the load, those at one time together, and its onset.
std::vector<Departure> departures_of(const Load& load) {
  const LoadTransform transform(load);
  const auto& events = transform.event_times();
  std::vector<Departure> all = {{events.empty() ? 0.0 : events.front(), 0.0}};
  for (const auto& [time, jump] : transform.jumps()) {
    if (time > all.back().time) all.push_back({time, 0.0});
    all.back().jump += jump;
  }
  const auto nothing = [](const Departure& departure) { return departure.jump == 0.0; };
  all.erase(std::remove_if(all.begin() + 1, all.end(), nothing), all.end());
  return all;
}

/// Adds the legs that start at one end and are being run when `elapsed` has passed, as rays up to
/// where they have come.
void add_running_legs(const Problem& problem, const WaveModes& modes, double end, double elapsed,
                      std::vector<Ray>& legs) {
  const double length = problem.column.length.value_or(std::numeric_limits<double>::infinity());
  const auto rays = rays_until(problem, modes, end, elapsed);
  if (rays.size() > most_rays) {
    throw InputError(
        fmt::format("fronts {} s after they started: expected at most {} of them; ask for earlier "
                    "times",
                    elapsed, most_rays));
  }
  for (Ray ray : rays) {
    if (ray.upwards() != (end == 0.0)) continue;  // it started at the other end
    const double run = modes.speed(ray.mode) * (elapsed - ray.arrival);
    if (run > length) continue;
    ray.path[static_cast<std::size_t>(ray.mode)] += run;
    legs.push_back(ray);
  }
}

std::vector<Ray> running_legs(const Problem& problem, const WaveModes& modes, double elapsed) {
  std::vector<Ray> legs;
  add_running_legs(problem, modes, 0.0, elapsed, legs);
  if (problem.column.length)
    add_running_legs(problem, modes, *problem.column.length, elapsed, legs);
  std::stable_sort(legs.begin(), legs.end(),
                   [](const Ray& a, const Ray& b) { return a.crossings < b.crossings; });
  return legs;
}

Front front_of(const Problem& problem, const WaveModes& modes, const Ray& leg, double elapsed) {
  const double run = modes.speed(leg.mode) * (elapsed - leg.arrival);
  const double x = leg.upwards() ? run : *problem.column.length - run;
  return {x, leg.mode, leg.upwards(), leg.crossings, leg.slow_crossings, 0.0, false, {}};
}

}  // namespace

std::vector<Front> fronts_at(const Problem& problem, const WaveModes& modes, double t) {
  if (!std::isfinite(t)) {
    throw InputError(fmt::format("fronts at t = {}: expected a finite number", t));
  }
  std::vector<Front> fronts;
  for (const Departure& departure : departures_of(problem.load)) {
    if (departure.time > t) continue;
    const double elapsed = t - departure.time;
    const auto legs = running_legs(problem, modes, elapsed);
    RaySum amplitudes(problem, legs);
    const WaveState frozen = wave_state(problem, modes, modes.frozen());
    amplitudes.at(frozen, [&](std::size_t r, const FieldVector& wave, Complex exponent) {
      Front front = front_of(problem, modes, legs[r], elapsed);
      const double size = departure.jump * std::exp(exponent.real());
      front.started = departure.time;
      front.of_jump = departure.jump != 0.0;
      front.jump = {size * wave[0].real(), size * wave[1].real(), size * wave[2].real(),
                    size * wave[3].real()};
      fronts.push_back(front);
    });
  }
  std::stable_sort(fronts.begin(), fronts.end(),
                   [](const Front& a, const Front& b) { return a.x < b.x; });
  return fronts;
}

}  // namespace porowave::reference
