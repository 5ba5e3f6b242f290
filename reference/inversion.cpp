#include "reference/inversion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace porowave::reference {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;

/// Terms smaller than this share of the load are not summed.
constexpr double negligible = 1e-17;
constexpr int most_evaluations = 1 << 15;
constexpr int first_nodes = 64;
/// Size of the integrand on the real axis that rounding can bear.
constexpr double bearable = 50.0;
/// A bound below this share of the load needs no second contour.
constexpr double good_enough = 1e-13;
/// A mode may carry little of a field because two parts of it cancel; their rounding stays. It is
/// counted as this many units of rounding of a full wave.
constexpr double cancelled = 8.0;

struct Integrand {
  std::array<Complex, 4> value{};
  FourSums rounding{};  ///< in units of epsilon
  double size = 0.0;    ///< largest |value| over what a full wave has

  bool finite() const {
    return std::isfinite(size) && std::isfinite(rounding[0]) && std::isfinite(rounding[1]) &&
           std::isfinite(rounding[2]) && std::isfinite(rounding[3]);
  }
};

/// The transform of a group of arrivals.
class Group {
 public:
  Group(const Problem& problem, const WaveModes& modes, const LoadTransform& load, double t,
        std::span<const Arrival> arrivals)
      : modes_(modes),
        load_(load),
        t_(t),
        arrivals_(arrivals),
        rays_(rays_of(arrivals)),
        unit_(unit_fields(problem)),
        sum_(problem, modes, rays_) {}

  double longest() const {
    double longest = 0.0;
    for (const Arrival& a : arrivals_) longest = std::max(longest, a.since);
    return longest;
  }

  /// Fields of a full wave under the whole load.
  FourSums full_wave() const {
    FourSums full;
    for (std::size_t f = 0; f < 4; ++f) full[f] = unit_[f] * load_.peak();
    return full;
  }

  /// Size of the largest exponent of decay, which is a phase where s is complex.
  double decay_exponent(Complex s) const {
    const ModeState state = modes_.at(s);
    double largest = 0.0;
    for (const Ray& ray : rays_) {
      largest = std::max(largest, std::abs(state.excess[0]) * ray.path[0] +
                                      std::abs(state.excess[1]) * ray.path[1]);
    }
    return largest;
  }

  Integrand at(Complex s) {
    Integrand result;
    const ModeState state = modes_.at(s);
    // All arrivals of a group are of one kind; what has settled has the same transform for all.
    const bool settled = arrivals_.front().part == Arrival::Part::settled;
    const ScaledTransform whole = settled ? load_.settled(s) : ScaledTransform{};
    sum_.at(state, [&](std::size_t r, const FieldVector& fields, Complex exponent) {
      ScaledTransform load = settled ? whole : passing_part(arrivals_[r], s);
      if (settled) load.exponent = s * (arrivals_[r].since - load_.end());
      const Complex factor = std::exp(load.exponent + exponent);
      add(amplification(s, state, arrivals_[r].ray), load.value * factor,
          load.size * std::abs(factor), fields, result);
    });
    for (std::size_t f = 0; f < 4; ++f) {
      result.size = std::max(result.size, std::abs(result.value[f]) / (unit_[f] * load_.peak()));
    }
    return result;
  }

  /// Residues at poles of the load that lie outside of the contour.
  void add_outer_poles(const Ellipse& ellipse, Inverted& result) {
    for (std::size_t i = 0; i < arrivals_.size(); ++i) {
      if (arrivals_[i].part != Arrival::Part::event) continue;
      for (const ImaginaryPole& pole : load_.event_poles(arrivals_[i].event)) {
        if (!ellipse.encloses({0.0, pole.frequency})) add_pole(i, pole, result);
      }
    }
  }

 private:
  static std::vector<Ray> rays_of(std::span<const Arrival> arrivals) {
    std::vector<Ray> rays;
    for (const Arrival& a : arrivals) rays.push_back(a.ray);
    return rays;
  }

  ScaledTransform passing_part(const Arrival& a, Complex s) const {
    return a.part == Arrival::Part::event ? load_.event(a.event, s, a.since)
                                          : load_.passing_part(s, a.since);
  }

  /// Roundings of the exponents enter multiplied by their size.
  double amplification(Complex s, const ModeState& state, const Ray& ray) const {
    return 8.0 + 4.0 * (std::abs(s) * t_ + std::abs(state.excess[0]) * ray.path[0] +
                        std::abs(state.excess[1]) * ray.path[1]);
  }

  void add(double amplification, Complex load, double load_size, const FieldVector& fields,
           Integrand& result) const {
    for (std::size_t f = 0; f < 4; ++f) {
      const Complex term = load * fields[f];
      result.value[f] += term;
      result.rounding[f] += amplification * std::abs(term) + cancelled * load_size * unit_[f];
    }
  }

  void add_pole(std::size_t i, const ImaginaryPole& pole, Inverted& result) {
    const Complex s(0.0, pole.frequency);
    const ModeState state = modes_.at(s);
    sum_.at(state, [&](std::size_t r, const FieldVector& fields, Complex exponent) {
      if (r != i) return;
      const Complex wave = 2.0 * pole.residue * std::exp(s * arrivals_[i].since + exponent);
      const double factor = amplification(s, state, arrivals_[i].ray);
      for (std::size_t f = 0; f < 4; ++f) {
        result.value[f] += (wave * fields[f]).real();
        result.error[f] +=
            epsilon * std::abs(wave) * (factor * std::abs(fields[f]) + cancelled * unit_[f]);
      }
    });
  }

  const WaveModes& modes_;
  const LoadTransform& load_;
  double t_;
  std::span<const Arrival> arrivals_;
  std::vector<Ray> rays_;
  FourSums unit_;
  RaySum sum_;
};

/// The trapezoidal rule on the upper half of an ellipse, with nested doubling of the nodes.
class Trapezoid {
 public:
  Trapezoid(Group& group, const Ellipse& ellipse) : group_(group), ellipse_(ellipse) {
    for (int j = 0; j <= first_nodes / 2; ++j) add_node(2.0 * pi * j / nodes_);
    best_ = mean();
    before_.fill(infinity);
  }

  /// Adds the nodes between those there are, up to the last one that counted and its neighbour.
  /// False, and nothing done, if that would take too many evaluations.
  bool refine() {
    const double step = 2.0 * pi / nodes_;
    const double between = std::ceil(std::min(pi, last_angle_ + step) / step - 0.5);
    if (!(static_cast<double>(evaluations_) + between <= most_evaluations)) return false;
    const auto count = static_cast<int>(between);
    for (int j = 0; j < count; ++j) add_node((j + 0.5) * step);
    nodes_ *= 2.0;
    before_ = best_;
    best_ = mean();
    return true;
  }

  double nodes() const { return nodes_; }
  long evaluations() const { return evaluations_; }
  double value(std::size_t f) const { return best_[f]; }
  double change(std::size_t f) const { return std::abs(best_[f] - before_[f]); }
  double rounding(std::size_t f) const { return epsilon * rounding_[f] / nodes_; }

  bool finite() const { return std::isfinite(best_[0] + best_[1] + best_[2] + best_[3]); }
  bool settled() const {
    for (std::size_t f = 0; f < 4; ++f) {
      if (!(change(f) <= rounding(f))) return false;
    }
    return true;
  }

 private:
  void add_node(double angle) {
    const bool on_axis = angle == 0.0 || angle > pi * (1.0 - 1e-14);
    const double weight = on_axis ? 1.0 : 2.0;
    const Integrand integrand = group_.at(ellipse_.point(angle));
    const Complex tangent = weight * ellipse_.tangent(angle) / Complex(0.0, 1.0);
    for (std::size_t f = 0; f < 4; ++f) {
      sum_[f] += (tangent * integrand.value[f]).real();
      rounding_[f] += std::abs(tangent) * integrand.rounding[f];
    }
    // Written so that a size that is not a number counts.
    if (!(integrand.size * std::abs(tangent) < negligible)) {
      last_angle_ = std::max(last_angle_, angle);
    }
    ++evaluations_;
  }

  FourSums mean() const {
    FourSums mean;
    for (std::size_t f = 0; f < 4; ++f) mean[f] = sum_[f] / nodes_;
    return mean;
  }

  Group& group_;
  Ellipse ellipse_;
  double nodes_ = first_nodes;
  double last_angle_ = 0.0;
  long evaluations_ = 0;
  FourSums sum_{};
  FourSums rounding_{};
  FourSums best_{};
  FourSums before_{};
};

/// Nodes below which a sum cannot have seen all of the integrand: a few for each factor e of
/// convergence, and two for each radian of phase.
double fewest_nodes(Group& group, const GrownEllipse& contour) {
  const double phase =
      (contour.ellipse.real_axis + contour.ellipse.imaginary_axis) * group.longest();
  double decay = 0.0;
  for (const double angle : {0.0, 0.5 * pi, pi}) {
    decay = std::max(decay, group.decay_exponent(contour.ellipse.point(angle)));
  }
  return std::max({1.0 * first_nodes, 4.0 / contour.log_growth, phase + 2.0 * decay});
}

double worst_share(const FourSums& error, const FourSums& unit, double peak) {
  double worst = 0.0;
  for (std::size_t f = 0; f < 4; ++f) {
    const double share = error[f] / (unit[f] * peak);
    if (!std::isfinite(share)) return infinity;  // std::max would drop a NaN
    worst = std::max(worst, share);
  }
  return worst;
}

Inverted integrate(Group& group, const Ellipse& smallest, double distance) {
  const GrownEllipse contour = grown(smallest, distance);
  const double needed = fewest_nodes(group, contour);
  Inverted result;
  result.error.fill(infinity);
  Trapezoid rule(group, contour.ellipse);
  while (rule.finite() && (rule.nodes() < needed || !rule.settled()) && rule.refine()) {
  }
  result.nodes = rule.evaluations();
  if (!(rule.nodes() >= needed)) return result;
  const FourSums full = group.full_wave();
  for (std::size_t f = 0; f < 4; ++f) {
    result.value[f] = rule.value(f);
    result.error[f] = rule.rounding(f) + rule.change(f) + negligible * full[f];
  }
  group.add_outer_poles(contour.ellipse, result);
  return result;
}

/// Distance of the contour's right end from the singularities: the largest at which the integrand
/// is still bearable, on a scale from well within 1/since to well beyond all singularities.
double best_distance(Group& group, const Ellipse& smallest) {
  const double size = smallest.real_axis + smallest.imaginary_axis;
  const double shortest = 0.25 / std::max(group.longest(), 0.01 / size);
  const double longest = 64.0 * shortest + 20.0 * size;
  double best = shortest;
  double least = infinity;
  const int doublings = static_cast<int>(std::log2(longest / shortest));
  for (int i = 0; i <= doublings; ++i) {
    const double distance = std::ldexp(shortest, i);
    const Complex s(smallest.rightmost + distance, 0.0);
    const Integrand integrand = group.at(s);
    if (!integrand.finite()) break;
    const double height = integrand.size * std::max(std::abs(s), distance);
    if (height <= bearable || height < least) best = distance;
    least = std::min(least, height);
  }
  return best;
}

/// Largest integrand times length of step at a few places of the upper half.
double height_along(Group& group, const Ellipse& ellipse) {
  constexpr int places = 24;
  double highest = 0.0;
  for (int i = 0; i < places; ++i) {
    const double angle = pi * i / places;
    const Integrand integrand = group.at(ellipse.point(angle));
    if (!integrand.finite()) return infinity;
    highest = std::max(highest, integrand.size * std::abs(ellipse.tangent(angle)));
  }
  return highest;
}

struct Contour {
  Ellipse smallest;
  double distance;
};

/// Thin ellipses need the fewest nodes. Near the front of the undrained wave, where the integrand
/// falls along the imaginary axis but grows to both sides of it, only a fat one stays low.
Contour best_contour(Group& group, const WaveModes& modes, double t) {
  const Ellipse thinnest = enclosing_singularities(modes);
  const double modest = 20.0;
  Contour best{thinnest, best_distance(group, thinnest)};
  if (thinnest.real_axis * t < modest) return best;
  double lowest = infinity;
  for (const double shape : {0.0, 0.3, 0.6, 1.0}) {
    Ellipse smallest = thinnest;
    smallest.imaginary_axis = std::max(thinnest.imaginary_axis, shape * thinnest.real_axis);
    const double distance = best_distance(group, smallest);
    const double height = height_along(group, grown(smallest, distance).ellipse);
    if (height < lowest) {
      lowest = height;
      best = {smallest, distance};
    }
    if (lowest <= 4.0 * bearable) break;
  }
  return best;
}

}  // namespace

FourSums unit_fields(const Problem& problem) {
  const double stress = problem.stress_scale() / problem.load.peak();
  const double velocity = problem.velocity_scale() / problem.load.peak();
  return {stress, stress, velocity, velocity};
}

Inversion::Inversion(const Problem& problem, const WaveModes& modes, const LoadTransform& load,
                     double t)
    : problem_(problem), modes_(modes), load_(load), t_(t) {}

Inverted Inversion::invert(std::span<const Arrival> arrivals) const {
  const FourSums unit = unit_fields(problem_);
  Group group(problem_, modes_, load_, t_, arrivals);
  const auto [smallest, distance] = best_contour(group, modes_, t_);
  Inverted best;
  double least = infinity;
  long nodes = 0;
  best.error.fill(infinity);
  for (const double factor : {1.0, 0.25, 4.0}) {
    const Inverted result = integrate(group, smallest, factor * distance);
    nodes += result.nodes;
    const double worst = worst_share(result.error, unit, load_.peak());
    if (worst < least) {
      best = result;
      least = worst;
    }
    if (least <= good_enough) break;
  }
  best.nodes = nodes;
  return best;
}

}  // namespace porowave::reference
