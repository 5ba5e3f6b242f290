#include "reference/adaptive_integral.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>

namespace porowave::reference {

namespace {

constexpr double target = 1e-13;
constexpr std::size_t most_panels = 4000;

/// Part of a piece: t = begin + width w^2 for low <= w <= high.
struct Panel {
  double begin;
  double width;
  double low;
  double high;
  double value = 0.0;
  double size = 0.0;   ///< integral of |f|
  double error = 0.0;  ///< of the rule
  double noise = 0.0;  ///< from the errors of the values

  bool operator<(const Panel& other) const { return excess() < other.excess(); }
  /// Error that halving may remove; none where it is rounding of the values.
  double excess() const { return error > noise ? error : 0.0; }
};

Panel panel(const std::function<Bounded(double)>& f, double begin, double width, double low,
            double high) {
  Panel panel{begin, width, low, high};
  double largest_error = 0.0;
  // The rule is asked for -1 <= z <= 1 only: elsewhere Boost 1.74 does not scale its error.
  const double half = 0.5 * (high - low);
  const auto of_place = [&](double z) {
    const double w = low + half * (1.0 + z);
    const double jacobian = 2.0 * width * w * half;
    const Bounded y = f(begin + width * w * w);
    largest_error = std::max(largest_error, y.error * jacobian);
    return y.value * jacobian;
  };
  panel.value = boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
      of_place, -1.0, 1.0, 0, 0.0, &panel.error, &panel.size);
  panel.noise =
      2.0 * largest_error + 16.0 * std::numeric_limits<double>::epsilon() * std::abs(panel.size);
  return panel;
}

Panel sum(const std::vector<Panel>& panels) {
  Panel sum{};
  for (const Panel& p : panels) {
    sum.value += p.value;
    sum.size += p.size;
    sum.error += p.error;
    sum.noise += p.noise;
  }
  return sum;
}

}  // namespace

Bounded adaptive_integral(const std::function<Bounded(double)>& f, std::span<const double> ends) {
  std::vector<Panel> panels;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    panels.push_back(panel(f, ends[i], ends[i + 1] - ends[i], 0.0, 1.0));
  }
  std::make_heap(panels.begin(), panels.end());
  Panel all = sum(panels);
  while (all.error > std::max(target * all.size, all.noise) && panels.size() < most_panels) {
    std::pop_heap(panels.begin(), panels.end());
    const Panel worst = panels.back();
    if (!(worst.excess() > 0.0)) break;
    const double middle = 0.5 * (worst.low + worst.high);
    panels.back() = panel(f, worst.begin, worst.width, worst.low, middle);
    std::push_heap(panels.begin(), panels.end());
    panels.push_back(panel(f, worst.begin, worst.width, middle, worst.high));
    std::push_heap(panels.begin(), panels.end());
    all = sum(panels);
  }
  const double error = all.error + all.noise;
  if (std::isfinite(error)) return {all.value, error};
  return {all.value, std::numeric_limits<double>::infinity()};
}

}  // namespace porowave::reference
