#include "reference/contour_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace porowave::reference {

namespace {

constexpr std::array<double, 7> angles = {1.0, 0.75, 0.5, 0.3, 0.18, 0.1, 0.05};
/// A height that rounding can bear.
constexpr double bearable = 30.0;
/// Units of rounding that come with a term of the size of the load.
constexpr double usual_rounding = 64.0;
/// Singularities closer than this (in u) are too near.
constexpr double least_clearance = 0.06;
/// Integrands below e^-40 of the load do not count.
constexpr double negligible_exponent = -40.0;
constexpr std::size_t most_samples = 24;
/// What a contour is worse by on which the integrand, once gone, comes back near the relaxation
/// rate: it oscillates too fast there.
constexpr double comeback_penalty = 1e4;

/// Some of the arrivals, the oldest and the youngest among them.
std::vector<Arrival> sample(const std::vector<Arrival>& arrivals) {
  if (arrivals.size() <= most_samples) return arrivals;
  std::vector<Arrival> chosen;
  for (std::size_t i = 0; i < most_samples; ++i) {
    chosen.push_back(arrivals[i * (arrivals.size() - 1) / (most_samples - 1)]);
  }
  return chosen;
}

class Search {
 public:
  Search(const Problem& problem, const WaveModes& modes, const LoadTransform& load,
         const ArrivalGroup& group)
      : problem_(problem),
        modes_(modes),
        complete_(group.complete),
        integrand_(problem, load, sample(group.arrivals)),
        negligible_at_branch_(
            integrand_.largest_exponent(modes.branch_point(),
                                        modes.at(modes.branch_point() * (1.0 + 1e-9))) <
            negligible_exponent) {}

  /// The lowest contour of one angle and shift.
  ContourChoice lowest(double angle, double shift) {
    const double age = integrand_.longest_age();
    const double size = std::max(modes_.relaxation_rate(), std::abs(modes_.branch_point()));
    ContourChoice best{{}, WaveModes::Cut::between, std::numeric_limits<double>::infinity()};
    // With stiff drag the height may rise before it falls to the saddle.
    const int patience = age * size > 50.0 ? 4 : 2;
    int worse = 0;
    for (double distance = 0.25 / age; distance < std::max(32.0 / age, 4.0 * size);
         distance *= 2.0) {
      const Hyperbola contour = hyperbola_through(shift, shift + distance, angle);
      const auto cut = permitted(contour);
      if (!cut) continue;
      const double height = height_of(contour, *cut);
      worse = height < best.height ? 0 : worse + 1;
      if (height < best.height) best = {contour, *cut, height};
      // Beyond the saddle the integrand only grows.
      if (worse >= patience && best.height < bearable) break;
    }
    return best;
  }

 private:
  std::optional<WaveModes::Cut> permitted(const Hyperbola& contour) const {
    const double clearance = contour.clearance(modes_.branch_point());
    if (clearance > least_clearance) return WaveModes::Cut::between;
    if (clearance > -least_clearance) return std::nullopt;
    if (complete_ || negligible_at_branch_) return WaveModes::Cut::outwards;
    return std::nullopt;
  }

  double height_of(const Hyperbola& contour, WaveModes::Cut cut) {
    for (std::size_t i = 0; i < integrand_.arrivals().size(); ++i) {
      for (const ImaginaryPole& pole : integrand_.poles(i)) {
        if (std::abs(contour.clearance({0.0, pole.frequency})) < least_clearance) {
          return std::numeric_limits<double>::infinity();
        }
      }
    }
    const NodeTable nodes(problem_, modes_, contour, cut);
    constexpr double step = 0.4;
    constexpr double share = 1e-12;
    // Beyond the last term that counts a few more are looked at, to see that none counts again.
    const double size = 8.0 * std::max(modes_.relaxation_rate(), std::abs(modes_.branch_point()));
    constexpr double gone = 1e-17;
    constexpr double back = 1e-15;
    bool was_gone = false;
    bool came_back = false;
    double highest = 0.0;
    double last = 0.0;
    for (double u = 0.0; u < 100.0;) {
      const Node node = nodes.at(u);
      const NodeSum sum = integrand_.at(node);
      if (!sum.finite()) return std::numeric_limits<double>::infinity();
      for (std::size_t f = 0; f < 4; ++f) {
        highest = std::max(highest, sum.rounding[f] / integrand_.full_wave()[f] / usual_rounding);
      }
      highest = std::max(highest, sum.size);
      if (sum.size > share) last = u;
      was_gone = was_gone || sum.size < gone;
      came_back = came_back || (was_gone && sum.size > back);
      if (u > last + 2.0 && std::abs(node.s) > size) break;
      u += step;
    }
    return came_back ? comeback_penalty * std::max(1.0, highest) : highest;
  }

  const Problem& problem_;
  const WaveModes& modes_;
  bool complete_;
  Integrand integrand_;
  bool negligible_at_branch_;
};

}  // namespace

std::vector<ContourChoice> contours_for(const Problem& problem, const WaveModes& modes,
                                        const LoadTransform& load, const ArrivalGroup& group) {
  Search search(problem, modes, load, group);
  const Complex branch = modes.branch_point();
  std::vector<double> shifts = {0.0};
  // Branch points above or right of 0 are enclosed by no hyperbola that starts near 0.
  if (branch.real() > -0.3 * std::abs(branch)) {
    shifts.push_back(std::max(0.0, branch.real()) + 0.3 * std::abs(branch));
  }
  std::vector<ContourChoice> choices;
  for (const double shift : shifts) {
    for (const double angle : angles) {
      if (angle > load.widest_angle()) continue;
      const ContourChoice choice = search.lowest(angle, shift);
      if (!std::isfinite(choice.height)) continue;
      choices.push_back(choice);
      if (choice.height <= bearable) break;
    }
  }
  std::sort(choices.begin(), choices.end(),
            [](const ContourChoice& a, const ContourChoice& b) { return a.height < b.height; });
  return choices;
}

}  // namespace porowave::reference
