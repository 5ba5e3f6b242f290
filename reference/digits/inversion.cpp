#include "reference/digits/inversion.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <tuple>

namespace porowave::fixtures::digits {

namespace {

/// Runs over the nodes of a contour, in the numbers R.
template <class R>
class Nodes {
 public:
  using C = ComplexOf<R>;

  Nodes(const Contour& contour, int count) : contour_(contour) {
    using std::cos;
    using std::exp;
    using std::sin;
    width_ = contour.end / R(count);
    const R v = contour.v;
    if (contour.family.circle) {
      width_ = boost::math::constants::pi<R>() / count;
      ratio_ = C(R(cos(width_)), R(sin(width_)));
      power_ = exp(v) * C(R(cos(R(width_ / 2))), R(sin(R(width_ / 2))));
    } else {
      sine_ = sin(v);
      cosine_ = cos(v);
      ratio_ = C(R(exp(width_)));
      power_ = C(R(exp(R(width_ / 2))));
    }
  }

  const R& width() const { return width_; }

  /// s at the current node, and ds/du in `ds`.
  C at(C& ds) const {
    if (contour_.family.circle) {
      ds = C(-power_.imag(), power_.real());
      return contour_.family.size + power_;
    }
    // sin(v - i u) = sin v cosh u - i cos v sinh u, cos(v - i u) = cos v cosh u + i sin v sinh u
    const R up = power_.real();
    const R cosh = (up + 1 / up) / 2;
    const R sinh = (up - 1 / up) / 2;
    const R size = contour_.family.size;
    ds = size * C(-sine_ * sinh, cosine_ * cosh);
    return size * C(R(1 - sine_ * cosh), R(cosine_ * sinh));
  }

  void next() { power_ *= ratio_; }

 private:
  const Contour& contour_;
  R width_;
  R sine_, cosine_;
  C ratio_, power_;
};

/// Amplitudes leaving an end after `crossings` crossings, [slow crossings], with their decay and
/// delay up to there.
template <class C>
class Amplitudes {
 public:
  Amplitudes(const ColumnWaves<C>& waves, const Pair<C>& crossing, bool converting, int most_slow)
      : ends_{waves.at_far, waves.at_near},
        converting_(converting),
        most_slow_(static_cast<std::size_t>(most_slow)),
        current_{waves.source} {
    for (Matrix<C>& end : ends_) {
      for (std::size_t k = 0; k < 2; ++k) end[0][k] *= crossing[k], end[1][k] *= crossing[k];
    }
  }

  const C& of(const Arrival& a) {
    for (; crossings_ < a.crossings; ++crossings_) advance();
    return current_[converting_ ? static_cast<std::size_t>(a.slow) : 0][a.mode];
  }

 private:
  void advance() {
    const Matrix<C>& end = ends_[static_cast<std::size_t>(crossings_ % 2)];
    if (!converting_) {
      for (std::size_t k = 0; k < 2; ++k) current_[0][k] *= end[k][k];
      return;
    }
    const std::size_t size = std::min(current_.size(), most_slow_) + 1;
    std::vector<Pair<C>> next(size, Pair<C>{C(0), C(0)});
    for (std::size_t slow = 0; slow < current_.size(); ++slow) {
      for (std::size_t mode = 0; mode < 2; ++mode) {
        if (slow + mode >= size) continue;
        next[slow + mode][0] += end[0][mode] * current_[slow][mode];
        next[slow + mode][1] += end[1][mode] * current_[slow][mode];
      }
    }
    current_.swap(next);
  }

  std::array<Matrix<C>, 2> ends_;  ///< a crossing and then the end: far, near
  bool converting_;
  std::size_t most_slow_;
  int crossings_ = 0;
  std::vector<Pair<C>> current_;
};

/// The integrand of a group.
template <class R>
class Integrand {
 public:
  using C = ComplexOf<R>;

  Integrand(const Point& point, const Group& group)
      : problem_(point.problem),
        medium_(point.problem.material),
        events_(load_events<R>(point.problem.load)),
        arrivals_(group.arrivals),
        labels_(group.labels),
        t_(point.t),
        x_(point.x),
        length_(point.problem.column.length.value_or(0.0)) {
    std::sort(arrivals_.begin(), arrivals_.end(), [](const Arrival& a, const Arrival& b) {
      return std::tie(a.crossings, a.slow, a.mode) < std::tie(b.crossings, b.slow, b.mode);
    });
    for (const Arrival& a : arrivals_) most_slow_ = std::max(most_slow_, a.slow);
    used_.resize(events_.size());
    for (const Arrival& a : arrivals_) used_[a.event] = true;
  }

  FourFields<C> at(const C& s) {
    using std::exp;
    const ColumnWaves<C> waves(medium_, problem_.column, s, labels_);
    std::vector<C> load(events_.size());
    for (std::size_t e = 0; e < load.size(); ++e) {
      if (used_[e]) load[e] = events_[e].at(s) * exp(C(s * (t_ - events_[e].time)));
    }
    Pair<C> crossing;
    for (std::size_t k = 0; k < 2; ++k) crossing[k] = decay(waves, k, length_);
    Amplitudes<C> amplitudes(waves, crossing, converts(problem_.column), most_slow_);
    Pair<C> up = {C(0), C(0)};
    Pair<C> down = {C(0), C(0)};
    C all_events(0);
    for (std::size_t i = 0; i < arrivals_.size(); ++i) {
      const Arrival& a = arrivals_[i];
      all_events += a.late > 0 ? C(load[a.event] * exp(C(s * R(a.late)))) : load[a.event];
      if (i + 1 < arrivals_.size() && same_wave(a, arrivals_[i + 1])) continue;
      (a.crossings % 2 == 0 ? up : down)[a.mode] += amplitudes.of(a) * all_events;
      all_events = C(0);
    }
    FourFields<C> sum;
    for (std::size_t k = 0; k < 2; ++k) {
      up[k] *= decay(waves, k, x_);
      if (length_ > 0) down[k] *= decay(waves, k, R(length_ - x_));
    }
    for (std::size_t f = 0; f < 4; ++f) {
      sum[f] = waves.up[0][f] * up[0] + waves.up[1][f] * up[1] + waves.down[0][f] * down[0] +
               waves.down[1][f] * down[1];
    }
    return sum;
  }

 private:
  static bool same_wave(const Arrival& a, const Arrival& b) {
    return a.crossings == b.crossings && a.slow == b.slow && a.mode == b.mode;
  }

  static C decay(const ColumnWaves<C>& waves, std::size_t mode, const R& path) {
    using std::exp;
    return exp(C(-waves.wave_number[mode] * path));
  }

  const Problem& problem_;
  Medium<R> medium_;
  std::vector<LoadEvent<R>> events_;
  std::vector<Arrival> arrivals_;
  Labels labels_;
  R t_, x_, length_;
  int most_slow_ = 0;
  std::vector<bool> used_;
};

/// Fields of the whole finite column at s: waves leaving x = 0, (1 - round trip)^-1 source.
FourFields<ComplexOf<Real50>> whole_column(const Point& point, const ComplexOf<Real50>& s) {
  using C = ComplexOf<Real50>;
  const Real50 length = point.problem.column.length.value_or(0.0);
  const ColumnWaves<C> waves(point.medium, point.problem.column, s, Labels::outer);
  const Matrix<C>& far = waves.at_far;
  const Matrix<C>& near = waves.at_near;
  Pair<C> crossing, up, down;
  for (std::size_t k = 0; k < 2; ++k) crossing[k] = exp(C(-waves.wave_number[k] * length));
  Matrix<C> round = {{{C(1), C(0)}, {C(0), C(1)}}};
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      for (std::size_t k = 0; k < 2; ++k) {
        round[i][j] -= near[i][k] * crossing[k] * far[k][j] * crossing[j];
      }
    }
  }
  const C det = round[0][0] * round[1][1] - round[0][1] * round[1][0];
  const Pair<C> leaving = {
      C((waves.source[0] * round[1][1] - round[0][1] * waves.source[1]) / det),
      C((round[0][0] * waves.source[1] - waves.source[0] * round[1][0]) / det)};
  for (std::size_t k = 0; k < 2; ++k) {
    up[k] = leaving[k] * exp(C(-waves.wave_number[k] * point.x));
    down[k] = (far[k][0] * crossing[0] * leaving[0] + far[k][1] * crossing[1] * leaving[1]) *
              exp(C(-waves.wave_number[k] * (length - point.x)));
  }
  FourFields<C> sum;
  for (std::size_t f = 0; f < 4; ++f) {
    sum[f] = C(0);
    for (std::size_t k = 0; k < 2; ++k)
      sum[f] += waves.up[k][f] * up[k] + waves.down[k][f] * down[k];
  }
  return sum;
}

}  // namespace

template <class R>
FourReals invert(const Point& point, const Group& group, double refinement) {
  using C = ComplexOf<R>;
  const int count = static_cast<int>(group.contour.nodes() * refinement) + 1;
  Integrand<R> integrand(point, group);
  Nodes<R> nodes(group.contour, count);
  std::array<R, 4> sum = {};
  for (int k = 0; k < count; ++k, nodes.next()) {
    C ds;
    const C s = nodes.at(ds);
    const auto fields = integrand.at(s);
    // (1/(2 pi i)) times the integral over both halves is the imaginary part of one, over pi.
    for (std::size_t f = 0; f < 4; ++f) sum[f] += C(fields[f] * ds).imag();
  }
  FourReals result;
  const R factor = nodes.width() / boost::math::constants::pi<R>();
  for (std::size_t f = 0; f < 4; ++f) result[f] = static_cast<Real50>(R(sum[f] * factor));
  return result;
}

template FourReals invert<Real50>(const Point&, const Group&, double);
template FourReals invert<Real100>(const Point&, const Group&, double);

FourReals invert_ricker(const Point& point, int variant) {
  using C = ComplexOf<Real50>;
  constexpr double smallness = 75.0;
  const double T = point.problem.load.duration();
  // The wavelet before its start must be small against e^smallness.
  const Real50 period = std::max((variant == 0 ? 1.6 : 1.9) * point.t, point.t + 0.7 * T);
  const Real50 shift = smallness / period;
  const Real50 spacing = 2 * boost::math::constants::pi<Real50>() / period;
  const double width = T / 13.0;
  const double last =
      2.0 / width *
      std::sqrt(2.0 * smallness + std::pow(0.5 * width * static_cast<double>(shift), 2));
  const int count = static_cast<int>(last / static_cast<double>(spacing)) + 1;
  FourReals sum = {};
  for (int k = 0; k <= count; ++k) {
    const C s(shift, spacing * (k + (variant == 0 ? 0.0 : 0.5)));
    const C load = ricker_transform<Real50>(point.problem.load, s) *
                   exp(C(s * (Real50(point.t) - Real50(T) / 2)));
    const auto fields = whole_column(point, s);
    // The node on the real axis counts once, the others with their conjugates.
    const double weight = k == 0 && variant == 0 ? 0.5 : 1.0;
    for (std::size_t f = 0; f < 4; ++f) sum[f] += weight * C(fields[f] * load).real();
  }
  for (std::size_t f = 0; f < 4; ++f) sum[f] *= 2 / period;
  return sum;
}

}  // namespace porowave::fixtures::digits
