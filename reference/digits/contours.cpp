#include "reference/digits/contours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace porowave::fixtures::digits {

namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();
/// e^-digits_wanted is what discretisation and truncation may leave of the load.
constexpr double digits_wanted = 55.0;
constexpr double largest_height = 150.0;
/// Above this, more than 50 digits are needed, at four times the cost.
constexpr double height_for_50_digits = 50.0;
constexpr int most_nodes = 20'000;

/// The integrand along one contour of a family, but for the load and the ages.
struct Line {
  double v;
  std::vector<Complex> s;
  std::vector<double> log_ds;                ///< log |ds/du|
  std::vector<std::array<double, 2>> decay;  /**< Re lambda, infinite out of the labels' reach */
  std::vector<std::vector<double>> log_load; /**< log |transform| of each event */
};

/// All contours of a family, at the same values of u.
struct Sheet {
  Family family;
  std::vector<double> u;
  std::vector<Line> lines;  ///< in order of v
};

Complex point_of(const Family& family, double v, double u) {
  const Complex w(v, family.circle ? u : -u);
  return family.circle ? family.size + std::exp(w) : family.size * (1.0 - std::sin(w));
}

Complex derivative_of(const Family& family, double v, double u) {
  const Complex w(v, family.circle ? u : -u);
  return family.circle ? std::exp(w) : family.size * std::cos(w);
}

/// The v of the contour through s.
double v_of(const Family& family, Complex s) {
  return family.circle ? std::log(std::abs(s - family.size))
                       : std::asin(1.0 - s / family.size).real();
}

struct Choice {
  std::size_t line = 0;
  double step = 0.0;
  double end = 0.0;
  double height = 0.0;
  double cost = infinity;  ///< in nodes of 50 digits
};

class Planner {
 public:
  Planner(const Point& point, Labels labels, int variant)
      : point_(point),
        medium_(point.medium),
        events_(load_events<double>(point.problem.load)),
        labels_(labels),
        variant_(variant) {
    circles();
    if (medium_.rate * point.t > 15.0) hyperbolas();
  }

  bool distribute(std::vector<Arrival> waiting, std::vector<Group>& groups) {
    while (!waiting.empty()) {
      const Arrival first = waiting.front();
      const Sheet* best_sheet = nullptr;
      Choice best;
      for (const Sheet& sheet : sheets_) {
        const Choice choice = best_line(sheet, first);
        if (choice.cost < best.cost) best = choice, best_sheet = &sheet;
      }
      if (best_sheet == nullptr) return false;
      groups.push_back(take(*best_sheet, best, waiting));
    }
    return true;
  }

 private:
  void circles() {
    const Family family{true, (variant_ == 0 ? -0.5 : -0.4) * medium_.rate};
    const double least =
        std::max(std::abs(medium_.rate + family.size), std::abs(medium_.branch - family.size));
    const double first = std::log(std::max(1.05 * least, 0.5 / point_.t)) + 0.08 * variant_;
    double last = std::max(10.0 * least, 200.0 / point_.t);
    // All poles of a sine want to be inside.
    for (const auto& event : events_) last = std::max(last, 20.0 * event.frequency);
    last = std::log(last);
    Sheet sheet{family, {}, {}};
    for (int i = 0; i < 24; ++i) sheet.u.push_back((i + 0.5) * pi / 24);
    for (double v = first; v < last; v += 0.2) sheet.lines.push_back(line(sheet, v));
    if (labels_ == Labels::outer) sheets_.push_back(sheet);
  }

  void hyperbolas() {
    const double last = 20.0 * std::max(medium_.rate, std::abs(medium_.branch));
    for (double size = (variant_ == 0 ? 1.0 : 1.4) / point_.t; size < last; size *= 2.0) {
      Sheet sheet{{false, size}, {}, {}};
      const double reach = std::min(1e9 / point_.t, 10.0 * last);
      for (double u = 0.0; u < std::log(2.0 * reach / size); u += 0.25) sheet.u.push_back(u);
      for (int i = -4; i < 15; ++i) {
        sheet.lines.push_back(line(sheet, 0.1 * i + 0.05 * (variant_ == 0 ? 1 : 0)));
      }
      sheets_.push_back(sheet);
    }
  }

  Line line(const Sheet& sheet, double v) const {
    Line line{v, {}, {}, {}, {}};
    line.log_load.resize(events_.size());
    for (const double u : sheet.u) {
      const Complex s = point_of(sheet.family, v, u);
      line.s.push_back(s);
      line.log_ds.push_back(std::log(std::abs(derivative_of(sheet.family, v, u))));
      for (std::size_t e = 0; e < events_.size(); ++e) {
        line.log_load[e].push_back(std::log(std::abs(events_[e].at(s))));
      }
      const bool reached = labels_ == Labels::outer || std::abs(s) < 0.8 * std::abs(medium_.branch);
      const auto slowness = medium_.slowness(s, labels_);
      line.decay.push_back(reached ? std::array{(s * slowness[0]).real(), (s * slowness[1]).real()}
                                   : std::array{-infinity, -infinity});
    }
    return line;
  }

  /// Log of the integrand along a line.
  std::vector<double> heights(const Line& line, const Arrival& a) const {
    const LoadEvent<double>& event = events_[a.event];
    const double age = point_.t - event.time;
    std::vector<double> result(line.s.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] = line.s[i].real() * age - line.decay[i][0] * a.path[0] -
                  line.decay[i][1] * a.path[1] + line.log_load[a.event][i] + line.log_ds[i];
      if (std::isinf(line.decay[i][0])) result[i] = infinity;
    }
    return result;
  }

  /// The singularities must be inside, at larger v of a hyperbola and at smaller v of a circle.
  double limit(const Family& family, const Arrival& a) const {
    std::vector<Complex> singular;
    if (labels_ == Labels::outer) singular.push_back(medium_.branch);
    if (events_[a.event].kind == LoadEvent<double>::Kind::sine) {
      singular.push_back({0.0, 4.0 * events_[a.event].frequency});
      singular.push_back({0.0, 2.0 * events_[a.event].frequency});
    }
    if (!family.circle) {
      double result = 0.5 * pi;
      for (const Complex s : singular) result = std::min(result, v_of(family, s));
      return result;
    }
    singular.push_back({-medium_.rate, 0.0});
    singular.push_back({0.0, 0.0});
    double result = -infinity;
    for (const Complex s : singular) result = std::max(result, v_of(family, s));
    return result;
  }

  Choice best_line(const Sheet& sheet, const Arrival& a) const {
    const double edge = limit(sheet.family, a);
    std::vector<std::vector<double>> height;
    for (const Line& one : sheet.lines) {
      height.push_back(heights(one, a));
    }
    Choice best;
    for (std::size_t i = 0; i < sheet.lines.size(); ++i) {
      const Choice choice = judge(sheet, height, i, edge);
      if (choice.cost < best.cost) best = choice;
    }
    return best;
  }

  /// The step and the end that one line of a sheet needs.
  static Choice judge(const Sheet& sheet, const std::vector<std::vector<double>>& height,
                      std::size_t line, double edge) {
    const double v = sheet.lines[line].v;
    const bool circle = sheet.family.circle;
    if (circle ? v <= edge : v >= edge) return {};
    // Where the integrand has become negligible for good, or as far as the labels reach.
    const auto& own_heights = height[line];
    const auto reach = static_cast<std::size_t>(
        std::find(own_heights.begin(), own_heights.end(), infinity) - own_heights.begin());
    std::size_t end = reach;
    if (!circle) {
      while (end > 0 && own_heights[end - 1] < -digits_wanted) --end;
      if (end == reach || end == 0) return {};
      ++end;
    }
    const auto top = [&](std::size_t l) {
      return *std::max_element(height[l].begin(),
                               height[l].begin() + static_cast<std::ptrdiff_t>(end));
    };
    const double own = top(line);
    if (!(own < largest_height)) return {};
    // The further the contour could be moved to either side, the coarser the rule may be.
    std::array<double, 2> step = {0.0, 0.0};
    for (std::size_t l = 0; l < sheet.lines.size(); ++l) {
      const double other = sheet.lines[l].v;
      if (l == line || (circle ? other <= edge : other >= edge)) continue;
      double& side = step[other > v ? 1 : 0];
      side = std::max(side, 2.0 * pi * std::abs(other - v) / std::max(5.0, top(l) + digits_wanted));
    }
    Choice choice{line, std::min(step[0], step[1]), circle ? pi : sheet.u[end - 1], own, 0.0};
    choice.cost = choice.end / choice.step;
    if (!(choice.cost < most_nodes)) return {};
    if (own > height_for_50_digits) choice.cost *= 4.0;
    return choice;
  }

  /// Removes from `waiting` what suits this contour as well and puts it on it.
  Group take(const Sheet& sheet, const Choice& choice, std::vector<Arrival>& waiting) const {
    Group group{{sheet.family, sheet.lines[choice.line].v, choice.step, choice.end, choice.height},
                labels_,
                {waiting.front()}};
    std::vector<Arrival> rest;
    for (std::size_t i = 1; i < waiting.size(); ++i) {
      std::vector<std::vector<double>> height;
      for (const Line& one : sheet.lines) height.push_back(heights(one, waiting[i]));
      const Choice own = judge(sheet, height, choice.line, limit(sheet.family, waiting[i]));
      if (own.cost > std::max(200.0, 2.0 * choice.cost)) {
        rest.push_back(waiting[i]);
        continue;
      }
      group.arrivals.push_back(waiting[i]);
      group.contour.step = std::min(group.contour.step, own.step);
      group.contour.end = std::max(group.contour.end, own.end);
      group.contour.height = std::max(group.contour.height, own.height);
    }
    waiting.swap(rest);
    return group;
  }

  const Point& point_;
  Medium<double> medium_;
  std::vector<LoadEvent<double>> events_;
  Labels labels_;
  int variant_;
  std::vector<Sheet> sheets_;
};

}  // namespace

std::optional<std::vector<Group>> plan(const Point& point, const std::vector<Arrival>& arrivals,
                                       int variant) {
  std::vector<Group> groups;
  for (const Labels labels : {Labels::outer, Labels::inner}) {
    std::vector<Arrival> some;
    std::copy_if(arrivals.begin(), arrivals.end(), std::back_inserter(some),
                 [&](const Arrival& a) { return a.labels == labels; });
    if (some.empty()) continue;
    if (!Planner(point, labels, variant).distribute(some, groups)) return std::nullopt;
  }
  return groups;
}

}  // namespace porowave::fixtures::digits
