#include "reference/time_slice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/constants.hpp"
#include "reference/contour_choice.hpp"
#include "reference/problem/errors.hpp"
#include "reference/waves.hpp"

namespace porowave::reference {

namespace {

/// Relative error of an arrival time: a few roundings of speeds, paths and their sum.
constexpr double arrival_rounding = 8.0 * epsilon;
/// A bound as small as this share of the load is as good as any.
constexpr double good_enough = 1e-13;
/// A contour on which a bound was larger than this serves no other point.
constexpr double worth_sharing = 1e-11;
constexpr int most_splits = 6;
constexpr std::size_t most_known = 12;
constexpr std::size_t most_attempts = 3;

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

/// A bound that needs no second attempt. Those of many waves add up, however they are grouped.
double reachable_bound(const ArrivalGroup& group) {
  return good_enough * (1.0 + 0.1 * static_cast<double>(group.arrivals.size()));
}

}  // namespace

TimeSlice::TimeSlice(const ColumnSolution& solution, double t, TimeIntegral integral)
    : solution_(solution),
      t_(t),
      uncertainty_(arrival_rounding * t),
      load_(solution.problem().load, integral, t),
      unit_(unit_fields(solution.problem())) {
  require_inside(solution.problem().column, 0.0, t);
}

BoundedFields TimeSlice::at(double x) {
  const Problem& problem = solution_.problem();
  require_inside(problem.column, x, t_);
  if (t_ < 0.0) return {};
  const auto rays = rays_until(problem, solution_.modes(), x, t_ + uncertainty_);
  if (rays.size() > most_rays) return unresolved();
  FourSums value{};
  FourSums error{};
  const FourSums jumps = add_fronts(rays, value, error);
  if (t_ == 0.0) return {fields_of(value), fields_of(error)};

  const ArrivalGroups arrivals =
      arrivals_of(problem, solution_.modes(), load_, rays, t_, uncertainty_);
  for (const ArrivalGroup& group : arrivals.groups) {
    const Inverted part = invert_group(group, most_splits);
    for (std::size_t f = 0; f < 4; ++f) {
      value[f] += part.value[f];
      error[f] += part.error[f];
    }
  }
  // The Ricker wavelet is taken without its ends, where it jumps by 3.7e-17.
  const double cut = load_.always_whole() && !arrivals.groups.empty() ? 4e-17 : 0.0;
  // A bound as large as the load says nothing; such a value is not given at all.
  for (std::size_t f = 0; f < 4; ++f) {
    const double full = unit_[f] * load_.peak();
    error[f] +=
        (arrivals.neglected + (f < 2 ? cut : cut * slow_wave_factor(problem.material))) * full;
    if (!(error[f] < full)) return unresolved();
    error[f] += jumps[f];
  }
  return {fields_of(value), fields_of(error)};
}

Inverted TimeSlice::invert_group(const ArrivalGroup& group, int splits) {
  Integrand integrand(solution_.problem(), load_, group.arrivals);
  Inverted best = by_contour(group, integrand);
  if (best.worst <= reachable_bound(group) || splits == 0 || group.complete ||
      group.arrivals.size() < 2) {
    return best;
  }
  // Waves of different age may each want a contour of their own.
  const auto middle =
      group.arrivals.begin() + static_cast<std::ptrdiff_t>(group.arrivals.size() / 2);
  const Inverted older = invert_group({{group.arrivals.begin(), middle}, false}, splits - 1);
  const Inverted younger = invert_group({{middle, group.arrivals.end()}, false}, splits - 1);
  if (older.worst + younger.worst >= best.worst) return best;
  for (std::size_t f = 0; f < 4; ++f) {
    best.value[f] = older.value[f] + younger.value[f];
    best.error[f] = older.error[f] + younger.error[f];
  }
  best.worst = older.worst + younger.worst;
  return best;
}

Inverted TimeSlice::by_contour(const ArrivalGroup& group, Integrand& integrand) {
  const Arrival& oldest = group.arrivals.front();
  const double reachable = reachable_bound(group);
  Inverted best;
  best.error.fill(std::numeric_limits<double>::infinity());
  best.worst = std::numeric_limits<double>::infinity();
  std::size_t attempts = 0;
  for (auto known = known_.begin(); known != known_.end() && attempts < 2; ++known) {
    const double ratio = known->age / oldest.age;
    if (known->part != oldest.part || ratio > 8.0 || ratio < 1.0 / 1.5) continue;
    ++attempts;
    const Inverted result = invert(integrand, known->table, uncertainty_);
    if (result.worst < best.worst) best = result;
    if (result.worst <= std::max(reachable, 1.5 * known->worst) && result.worst <= worth_sharing) {
      known_.splice(known_.begin(), known_, known);
      return best;
    }
  }
  attempts = 0;
  for (const ContourChoice& choice :
       contours_for(solution_.problem(), solution_.modes(), load_, group)) {
    const bool settled = oldest.part == Arrival::Part::settled;
    NodeTable table(solution_.problem(), solution_.modes(), choice.contour, choice.cut,
                    settled ? &load_ : nullptr);
    const Inverted result = invert(integrand, table, uncertainty_);
    if (result.worst < best.worst) {
      best = result;
      known_.push_front({oldest.age, oldest.part, result.worst, std::move(table)});
      if (known_.size() > most_known) known_.pop_back();
    }
    if (best.worst <= reachable || ++attempts == most_attempts) break;
  }
  return best;
}

FourSums TimeSlice::add_fronts(const std::vector<Ray>& rays, FourSums& value,
                               FourSums& error) const {
  FourSums jumps{};
  RaySum frozen(solution_.problem(), rays);
  const WaveModes& modes = solution_.modes();
  frozen.at(wave_state(solution_.problem(), modes, modes.frozen()),
            [&](std::size_t r, const FieldVector& wave, Complex exponent) {
              const double decay = std::exp(exponent.real());
              const double since = t_ - rays[r].arrival;
              const double q = t_ == 0.0 && since >= 0.0 ? load_.value(since) : 0.0;
              for (std::size_t f = 0; f < 4; ++f) {
                const double size = wave[f].real() * decay;
                value[f] += size * q;
                error[f] += 8.0 * epsilon * (std::abs(size) + decay * unit_[f]) * std::abs(q);
                for (const auto& [time, jump] : load_.jumps()) {
                  if (std::abs(since - time) <= uncertainty_) jumps[f] += std::abs(size * jump);
                }
              }
            });
  return jumps;
}

}  // namespace porowave::reference
