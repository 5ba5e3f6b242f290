#include "reference/digits/arrivals.hpp"

#include <algorithm>
#include <cmath>

namespace porowave::fixtures::digits {

namespace {

constexpr double negligible = -85.0;

/// The labels of an event of age `age`, as the header says.
Labels labels_for(const Medium<Real50>& medium, double age, double reach) {
  const double distance = std::abs(Medium<double>(medium).branch);
  return has_inner_labels(medium) && distance * age > reach ? Labels::inner : Labels::outer;
}

/// Both wave numbers and the size of an event's transform at real s, for upper bounds.
class RealBound {
 public:
  RealBound(const Point& point, const LoadEvent<double>& event, Labels labels) {
    const Medium<double> m(point.medium);
    // Outer labels mean what they say right of the branch points only.
    const double first = std::max(1e-3 / point.t, labels == Labels::outer ? m.branch.real() : 0.0);
    const double last = 1e3 * std::max(std::max(m.rate, std::abs(m.branch)), 1.0 / point.t);
    for (double s = 1.001 * first; s < last; s *= 1.2) {
      const auto slowness = m.slowness(std::complex<double>(s), Labels::outer);
      samples_.push_back({s, s * slowness[0].real(), s * slowness[1].real(),
                          std::log(s * std::abs(event.at(std::complex<double>(s))))});
    }
  }

  bool negligibly_small(double age, const std::array<double, 2>& path) const {
    return std::any_of(samples_.begin(), samples_.end(), [&](const Sample& a) {
      return a.s * age - a.fast * path[0] - a.slow * path[1] + a.load < negligible;
    });
  }

 private:
  struct Sample {
    double s, fast, slow, load;
  };
  std::vector<Sample> samples_;
};

/// The waves of one event.
class Collector {
 public:
  Collector(const Point& point, std::vector<Arrival>& out)
      : point_(point),
        out_(out),
        events_(load_events<Real50>(point.problem.load)),
        length_(point.problem.column.length.value_or(0.0)),
        converting_(converts(point.problem.column)) {}

  void collect(double reach) {
    const std::size_t plain = whole_pulse() ? 2 : events_.size();
    for (std::size_t e = 0; e < plain; ++e) {
      const double age = age_of(e);
      if (age < -arrival_tolerance * point_.t) continue;
      labels_.push_back(labels_for(point_.medium, age, reach));
    }
    const auto rounded = load_events<double>(point_.problem.load);
    for (std::size_t e = 0; e < events_.size(); ++e) {
      const Labels labels = labels_[std::min(e, labels_.size() - 1)];
      bounds_.emplace_back(point_, rounded[e], labels);
    }
    for (event_ = 0; event_ < labels_.size(); ++event_) generations();
  }

 private:
  bool whole_pulse() const {
    return events_.size() == 3 && events_[2].kind == events_[2].Kind::whole_pulse;
  }
  double age_of(std::size_t e) const {
    return static_cast<double>(Real50(point_.t) - events_[e].time);
  }

  void generations() {
    const bool inner = labels_[event_] == Labels::inner;
    for (int crossings = 0;; ++crossings) {
      const bool any = generation(crossings);
      const Real50 speed = inner ? point_.medium.undrained : point_.medium.speed[0];
      const bool all_later = crossings * Real50(length_) > speed * point_.t;
      if (length_ == 0.0 || (!any && all_later)) return;
    }
  }

  bool generation(int crossings) {
    bool any = false;
    for (int slow = 0; slow <= crossings; ++slow) {
      for (std::size_t mode = 0; mode < 2; ++mode) {
        if (!converting_ && slow != (mode == 0 ? 0 : crossings)) continue;
        any = add({crossings, slow, mode, event_, labels_[event_], {}, Real50(0)}) || any;
      }
    }
    return any;
  }

  bool add(Arrival a) {
    const Real50 last = a.crossings % 2 == 0 ? Real50(point_.x) : Real50(length_) - point_.x;
    std::array<Real50, 2> path = {(a.crossings - a.slow) * Real50(length_),
                                  a.slow * Real50(length_)};
    path[a.mode] += last;
    a.path = {static_cast<double>(path[0]), static_cast<double>(path[1])};
    const Real50 travel = path[0] / point_.medium.speed[0] + path[1] / point_.medium.speed[1];
    const Real50 undrained = path[0] / point_.medium.undrained;
    if (a.event < 2 && whole_pulse() && passed_by(travel, undrained)) {
      if (a.event == 1) return false;  // part of the whole pulse
      a.event = 2;
    }
    const Real50 age = Real50(point_.t) - events_[a.event].time;
    if (a.labels == Labels::outer) {
      if (travel > age + arrival_tolerance * point_.t) return false;
      if (travel > age) a.late = travel - age;
    }
    if (bounds_[a.event].negligibly_small(static_cast<double>(age), a.path)) return false;
    out_.push_back(a);
    return true;
  }

  /// The whole of a sin4_pulse has gone by for some time.
  bool passed_by(const Real50& travel, const Real50& undrained) const {
    if (labels_.size() != 2 || labels_[0] != labels_[1]) return false;
    const Real50 since = Real50(point_.t) - 1.5 * events_[1].time;
    const bool drag_matters = point_.medium.rate * point_.t > 30;
    return (!drag_matters || undrained <= since) &&
           (labels_[0] == Labels::inner || travel <= since);
  }

  const Point& point_;
  std::vector<Arrival>& out_;
  std::vector<LoadEvent<Real50>> events_;
  double length_;
  bool converting_;
  std::size_t event_ = 0;
  std::vector<Labels> labels_;
  std::vector<RealBound> bounds_;
};

}  // namespace

bool has_inner_labels(const Medium<Real50>& medium) {
  const std::complex<double> branch = Medium<double>(medium).branch;
  return branch.real() > -0.64 * std::abs(branch);
}

std::vector<Arrival> arrivals_of(const Point& point, double reach) {
  std::vector<Arrival> arrivals;
  Collector(point, arrivals).collect(reach);
  return arrivals;
}

}  // namespace porowave::fixtures::digits
