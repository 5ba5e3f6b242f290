#include "reference/integrand.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace porowave::reference {

namespace {

/// A mode may carry little of a field because two parts of it cancel; their rounding stays. It is
/// counted as this many units of rounding of a full wave.
constexpr double cancelled = 12.0;

std::vector<Arrival> by_crossings(std::vector<Arrival> arrivals) {
  std::stable_sort(arrivals.begin(), arrivals.end(), [](const Arrival& a, const Arrival& b) {
    return a.ray.crossings < b.ray.crossings;
  });
  return arrivals;
}

std::vector<Ray> rays_of(const std::vector<Arrival>& arrivals) {
  std::vector<Ray> rays;
  rays.reserve(arrivals.size());
  for (const Arrival& a : arrivals) rays.push_back(a.ray);
  return rays;
}

/// At least |z|, at most 1.42 |z|; a root in every term would take a third of the time.
double size_of(Complex z) {
  return std::abs(z.real()) + std::abs(z.imag());
}

/// std::exp without its detours for infinities: terms that are not finite are looked for.
Complex exp_of(Complex z) {
  return std::exp(z.real()) * Complex(std::cos(z.imag()), std::sin(z.imag()));
}

}  // namespace

FourSums unit_fields(const Problem& problem) {
  const double stress = problem.stress_scale() / problem.load.peak();
  const double velocity = problem.velocity_scale() / problem.load.peak();
  return {stress, stress, velocity, velocity};
}

bool NodeSum::finite() const {
  double sum = size;
  for (std::size_t f = 0; f < 4; ++f) sum += std::abs(value[f]) + rounding[f];
  return std::isfinite(sum);
}

Integrand::Integrand(const Problem& problem, const LoadTransform& load,
                     std::vector<Arrival> arrivals)
    : load_(load),
      arrivals_(by_crossings(std::move(arrivals))),
      rays_(rays_of(arrivals_)),
      unit_(unit_fields(problem)),
      sum_(problem, rays_),
      rates_(arrivals_.size()) {
  for (std::size_t f = 0; f < 4; ++f) {
    full_[f] = unit_[f] * load.peak();
    per_full_[f] = 1.0 / full_[f];
  }
}

ScaledTransform Integrand::part(const Arrival& a, Complex s) const {
  ScaledTransform part =
      a.part == Arrival::Part::settled ? load_.settled(s) : load_.event(a.event, s, 0.0);
  return part;
}

namespace {

/// Roundings of the exponents enter multiplied by the size of these.
class Amplification {
 public:
  Amplification(Complex s, const ModeState& modes)
      : s_(size_of(s)), excess_{size_of(modes.excess[0]), size_of(modes.excess[1])} {}
  double of(const Arrival& a) const {
    return 12.0 +
           6.0 * (s_ * std::abs(a.since) + excess_[0] * a.ray.path[0] + excess_[1] * a.ray.path[1]);
  }

 private:
  double s_;
  std::array<double, 2> excess_;
};

}  // namespace

NodeSum Integrand::at(const Node& node) {
  // All arrivals of a group are of one kind; what has settled has the same transform for all.
  const bool settled = arrivals_.front().part == Arrival::Part::settled;
  const Complex s = node.s;
  ScaledTransform load = settled && node.settled ? *node.settled : part(arrivals_.front(), s);
  const Amplification amplification(s, node.state.modes);
  std::array<Complex, 4> total{};
  NodeSum sum;
  sum_.at(node.state, [&](std::size_t r, const FieldVector& fields, Complex exponent) {
    if (fields[0] == 0.0 && fields[1] == 0.0 && fields[2] == 0.0) return;  // no conversion
    const Arrival& a = arrivals_[r];
    if (!settled && r > 0) load = part(a, s);
    const Complex factor = node.weight * exp_of(load.exponent + s * a.since + exponent);
    const Complex wave = load.value * factor;
    const double units = amplification.of(a) + 4.0 * size_of(load.exponent);
    const double lost = cancelled * load.size * size_of(factor);
    FourSums& rate = rates_[r];
    for (std::size_t f = 0; f < 4; ++f) {
      const Complex term = wave * fields[f];
      total[f] += term;
      sum.rounding[f] += units * size_of(term) + lost * unit_[f];
      rate[f] += s.real() * term.real() - s.imag() * term.imag();
    }
  });
  for (std::size_t f = 0; f < 4; ++f) {
    sum.value[f] = total[f].real();
    sum.size = std::max(sum.size, size_of(total[f]) * per_full_[f]);
  }
  return sum;
}

NodeSum Integrand::residue(std::size_t arrival, const ImaginaryPole& pole, const WaveState& state) {
  const Complex s(0.0, pole.frequency);
  NodeSum node;
  sum_.at(state, [&](std::size_t r, const FieldVector& fields, Complex exponent) {
    if (r != arrival) return;
    const Arrival& a = arrivals_[r];
    const Complex wave = 2.0 * pole.residue * std::exp(s * a.since + exponent);
    const double units = Amplification(s, state.modes).of(a);
    for (std::size_t f = 0; f < 4; ++f) {
      const Complex term = wave * fields[f];
      node.value[f] = term.real();
      node.rounding[f] = units * size_of(term) + cancelled * size_of(wave) * unit_[f];
    }
  });
  return node;
}

std::vector<ImaginaryPole> Integrand::poles(std::size_t arrival) const {
  const Arrival& a = arrivals_[arrival];
  if (a.part != Arrival::Part::event) return {};
  return load_.event_poles(a.event);
}

FourSums Integrand::rates() const {
  FourSums sum{};
  for (const FourSums& rate : rates_) {
    for (std::size_t f = 0; f < 4; ++f) sum[f] += std::abs(rate[f]);
  }
  return sum;
}

void Integrand::reset_rates() {
  std::fill(rates_.begin(), rates_.end(), FourSums{});
}

double Integrand::largest_exponent(Complex s, const ModeState& modes) const {
  double largest = -std::numeric_limits<double>::infinity();
  for (const Arrival& a : arrivals_) {
    const Complex exponent = part(a, s).exponent + s * a.since -
                             (modes.excess[0] * a.ray.path[0] + modes.excess[1] * a.ray.path[1]);
    largest = std::max(largest, exponent.real());
  }
  return largest;
}

double Integrand::longest_age() const {
  double longest = 0.0;
  for (const Arrival& a : arrivals_) longest = std::max(longest, a.age);
  return longest;
}

}  // namespace porowave::reference
