#include "reference/column_solution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/contour.hpp"
#include "reference/load_convolution.hpp"
#include "reference/problem/errors.hpp"
#include "reference/rays.hpp"

namespace porowave::reference {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr int most_nodes = 1 << 16;
/// Relative error of an arrival time: a few roundings of speeds, paths and their sum.
constexpr double arrival_rounding = 8.0 * epsilon;

/// A mode may carry little of a field, or a load be small at its start, because large parts of it
/// cancel; their rounding stays. It is counted as this many units of rounding of a full wave.
constexpr double cancelled = 8.0;

using FourSums = std::array<double, 4>;

/// Fields of a full wave per unit of load.
FourSums unit_scale(const Problem& problem) {
  const double stress = problem.stress_scale() / problem.load.peak();
  const double velocity = problem.velocity_scale() / problem.load.peak();
  return {stress, stress, velocity, velocity};
}

Fields fields_of(const FourSums& sums) {
  return {sums[0], sums[1], sums[2], sums[3]};
}

/// Real part of (1/2 pi i) times the integrand, summed over nodes, and what bounds its rounding.
struct NodeSum {
  FourSums value{};
  FourSums rounding{};
  int nodes = 0;
};

/// A bound as large as the load says nothing; such a value is not given at all.
constexpr double useless = 1.0;

BoundedFields unresolved() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double inf = std::numeric_limits<double>::infinity();
  return {{nan, nan, nan, nan}, {inf, inf, inf, inf}};
}

/// The transform of all arrived rays, to be integrated over one closed contour.
class Integrand {
 public:
  Integrand(const Problem& problem, const WaveModes& modes, std::span<const Ray> rays, double t)
      : modes_(modes),
        load_(problem.load),
        rays_(rays),
        t_(t),
        unit_(unit_scale(problem)),
        peak_(problem.load.peak()),
        sum_(problem, modes, rays) {}

  /// Adds the nodes of the upper half plane at angles first, first + step, ... below or at pi;
  /// the lower half plane is their mirror image.
  void add(const Ellipse& ellipse, double first, double step, int count, NodeSum& sum) {
    for (int i = 0; i < count; ++i) {
      const double angle = first + step * i;
      const bool on_axis = angle == 0.0 || i == count - 1;
      add_node(ellipse, angle, on_axis && is_axis(angle) ? 1.0 : 2.0, sum);
    }
  }

 private:
  static bool is_axis(double angle) {
    return angle == 0.0 || std::abs(angle - std::numbers::pi) < 1e-9;
  }

  void add_node(const Ellipse& ellipse, double angle, double weight, NodeSum& sum) {
    const Complex s = ellipse.point(angle);
    const Complex factor = weight * ellipse.tangent(angle) / Complex(0.0, 1.0);
    const ModeState state = modes_.at(s);
    sum_.at(state, [&](std::size_t r, const FieldVector& contribution, double decay) {
      const Ray& ray = rays_[r];
      const double since = std::max(0.0, t_ - ray.arrival);
      const Complex weighted = factor * load_(s, since);
      // Roundings of the exponents enter multiplied by their size.
      const double exponent = std::abs(s) * t_ + std::abs(state.excess[0]) * ray.path[0] +
                              std::abs(state.excess[1]) * ray.path[1];
      const double amplification = 8.0 + 4.0 * exponent;
      const double full_load = peak_ * since * std::max(1.0, std::exp(s.real() * since));
      const double size = std::abs(factor) * full_load * decay;
      for (std::size_t field = 0; field < 4; ++field) {
        const Complex term = weighted * contribution[field];
        sum.value[field] += term.real();
        sum.rounding[field] += amplification * std::abs(term) + cancelled * size * unit_[field];
      }
    });
    sum.nodes += static_cast<int>(weight);
  }

  const WaveModes& modes_;
  LoadConvolution load_;
  std::span<const Ray> rays_;
  double t_;
  FourSums unit_;
  double peak_;
  RaySum sum_;
};

struct ContourResult {
  FourSums value{};
  FourSums error{};
  double worst = std::numeric_limits<double>::infinity();  ///< error over scale
};

/// Doubles the nodes until two results differ by less than their rounding.
ContourResult integrate(Integrand& integrand, const Ellipse& ellipse, int first_nodes,
                        const FourSums& scale) {
  NodeSum sum;
  int nodes = first_nodes;
  integrand.add(ellipse, 0.0, 2.0 * std::numbers::pi / nodes, nodes / 2 + 1, sum);
  ContourResult result;
  FourSums before{};
  for (std::size_t f = 0; f < 4; ++f) before[f] = sum.value[f] / nodes;
  while (2 * nodes <= most_nodes) {
    const double step = 2.0 * std::numbers::pi / nodes;
    integrand.add(ellipse, 0.5 * step, step, nodes / 2, sum);
    nodes *= 2;
    result.worst = 0.0;
    bool resolved = true;
    for (std::size_t f = 0; f < 4; ++f) {
      result.value[f] = sum.value[f] / nodes;
      const double rounding = epsilon * sum.rounding[f] / nodes;
      const double change = std::abs(result.value[f] - before[f]);
      result.error[f] = rounding + change;
      resolved = resolved && change <= rounding;
      // std::max would drop a NaN, and a sum that overflowed must not look resolved.
      const double relative = result.error[f] / scale[f];
      result.worst = std::isfinite(relative) ? std::max(result.worst, relative)
                                             : std::numeric_limits<double>::infinity();
      if (!std::isfinite(relative)) break;
      before[f] = result.value[f];
    }
    if (resolved || !std::isfinite(result.worst)) break;
  }
  return result;
}

/// Nodes below which a sum cannot have seen all of the integrand: a few for each factor e of
/// convergence, and two for each radian of phase.
int fewest_nodes(const Ellipse& ellipse, double growth, double t) {
  const double for_growth = 4.0 / std::log(growth);
  const double for_phase = (ellipse.real_axis + ellipse.imaginary_axis) * t;
  const double needed = std::max({16.0, for_growth, for_phase});
  if (!(needed < most_nodes)) return most_nodes;
  return static_cast<int>(std::bit_ceil(static_cast<unsigned>(needed)));
}

}  // namespace

ColumnSolution::ColumnSolution(const Problem& problem)
    : problem_(problem), modes_(problem.material) {}

BoundedFields ColumnSolution::at(double x, double t) const {
  if (!std::isfinite(x) || !std::isfinite(t) || x < 0.0 ||
      (problem_.column.length && x > *problem_.column.length)) {
    throw InputError(fmt::format(
        "reference at x = {}, t = {}: expected x in the column, from 0{}", x, t,
        problem_.column.length ? fmt::format(" to {}", *problem_.column.length) : std::string()));
  }
  if (t < 0.0) return {};
  const double uncertainty = arrival_rounding * t;
  const auto reached = rays_until(problem_, modes_, x, t + uncertainty);
  std::vector<Ray> rays;
  for (const Ray& ray : reached) {
    if (ray.arrival <= t) rays.push_back(ray);
  }

  // The front itself, travelling at the frozen speed: its strength times the load since arrival.
  const LoadConvolution load(problem_.load);
  FourSums front{};
  FourSums error{};
  RaySum frozen(problem_, modes_, reached);
  const FourSums unit = unit_scale(problem_);
  frozen.at(modes_.frozen(), [&](std::size_t r, const FieldVector& strength, double decay) {
    const double since = t - reached[r].arrival;
    for (std::size_t f = 0; f < 4; ++f) {
      const double size = strength[f].real();
      if (since >= 0.0) front[f] += size * load.value(since);
      const double full = std::abs(size) + decay * unit[f];
      error[f] += cancelled * epsilon * full * std::abs(load.value(since));
      for (const auto& [time, jump] : load.jumps()) {
        if (std::abs(since - time) <= uncertainty) error[f] += std::abs(size * jump);
      }
    }
  });
  if (rays.empty() || t == 0.0) return {fields_of(front), fields_of(error)};

  double first_arrival = rays.front().arrival;
  for (const Ray& ray : rays) first_arrival = std::min(first_arrival, ray.arrival);
  const double since_arrival = t - first_arrival;
  const double velocity_scale = problem_.velocity_scale();
  const double stress_scale = problem_.stress_scale();
  const FourSums scale = {stress_scale, stress_scale, velocity_scale, velocity_scale};

  // The farther the contour, the fewer nodes; but rounding grows like e^(distance * time).
  const Ellipse smallest = enclosing_singularities(modes_);
  Integrand integrand(problem_, modes_, rays, t);
  ContourResult best;
  for (const double exponent : {4.0, 12.0, 1.0}) {
    const double size = smallest.real_axis + smallest.imaginary_axis;
    const double distance = std::min(exponent / std::max(since_arrival, 1e-300), 20.0 * size);
    const double growth = growth_for_distance(smallest, distance);
    const Ellipse ellipse = grown(smallest, growth);
    const ContourResult result =
        integrate(integrand, ellipse, fewest_nodes(ellipse, growth, t), scale);
    if (!(result.worst >= best.worst)) best = result;
    if (best.worst <= 1e-13) break;
  }
  if (!(best.worst < useless)) return unresolved();
  for (std::size_t f = 0; f < 4; ++f) {
    front[f] += best.value[f];
    error[f] += best.error[f];
  }
  return {fields_of(front), fields_of(error)};
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
