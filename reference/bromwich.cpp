#include "reference/bromwich.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <unordered_map>

#include "reference/constants.hpp"
#include "reference/fourier_integral.hpp"
#include "reference/problem/errors.hpp"

namespace porowave::reference {

namespace {

using line::Complex;
using line::FourOf;
using line::Image;
using line::LoadPiece;
using Four = FourOf<double>;
using Kind = LoadPiece::Kind;

/// sigma tau: how far right of s = 0 the line runs. Small enough for e^(sigma tau) not to matter.
constexpr double offset = 5.0;
/// And how far right of the meeting points of the modes at least.
constexpr double margin = 3.0;
/// Front terms that are taken off before integrating.
constexpr std::size_t front_terms = 3;
/// Beyond this age in durations the two pieces of a ramp nearly cancel.
constexpr double settled_age = 3.0;
/// Loads with a band of frequencies are integrated as a whole up to the edge of the band, omega
/// duration = this, piece by piece from there on. The poles of a sine are at 2 pi and 4 pi.
constexpr double smooth_band = 20.0;
/// Beyond this one nothing is left of a wavelet: e^(-(165/26)^2) = 3e-18.
constexpr double wavelet_band = 165.0;
/// Radians that a panel of the band spans, for rules of 61 nodes.
constexpr double head_panel = 20.0;
/// Integrals of numbers of size 1 are not wanted more accurately than this.
constexpr double finest_goal = 2e-13;

/// An image, a piece of the load that has arrived with it, and how long ago.
struct WaveArrival {
  const Image* image;
  const LoadPiece* piece;
  double since;
};

/// Sums up fields that are relative to the load.
struct Sum {
  Four value{};
  Four error{};
};

class Inverter {
 public:
  Inverter(const Problem& problem, const line::Medium& medium, double tolerance)
      : problem_(problem), medium_(medium), tolerance_(tolerance) {
    const double stress = problem.stress_scale();
    const double velocity = problem.velocity_scale();
    unit_ = {stress, stress, velocity, velocity};
  }

  const Four& unit() const { return unit_; }

  /// Adds one piece with one image; `hidden` is the rounding of arrival times.
  void add(const WaveArrival& arrival, double hidden, Sum& sum);
  /// True if the load at this age is to be taken whole, by add_in_bands.
  bool in_bands(double age) const;
  /// Adds all pieces of the load with an image that arrived `age` ago.
  void add_in_bands(const Image& image, std::span<const LoadPiece> pieces, double age, Sum& sum);

 private:
  double goal(double factor) const { return std::max(tolerance_ / factor, finest_goal); }
  double sigma(double age) const {
    return std::max(offset / age, std::max(0.0, medium_.meeting.real()) + margin / age);
  }
  FourOf<Complex> fields(const Image& image, Complex s) const {
    return line::image_fields(problem_.column, medium_, image, 1.0 / s);
  }
  FourOf<Series> front(const Image& image) const {
    return line::image_fields(problem_.column, medium_, image, Series::variable());
  }
  void add_rest(const WaveArrival& arrival, const FourOf<Series>& front, Sum& sum);
  void add_head(const Image& image, std::span<const LoadPiece> pieces, double age, double line,
                double edge, Sum& sum);
  void add_tail(const WaveArrival& arrival, double line, double edge, Sum& sum);
  /// An integral times `factor`, with the rounding of integrands of the size `largest`.
  void accept(const Integral& integral, double factor, double largest, std::size_t f, Sum& sum) {
    sum.value[f] += factor * integral.value;
    sum.error[f] += std::abs(factor) * (2.0 * integral.error + 16.0 * epsilon * largest);
  }

  const Problem& problem_;
  const line::Medium& medium_;
  double tolerance_;
  Four unit_;
  FourierIntegral quadrature_;
};

/// Remembers a function's values: the four fields ask for most of them at the same y.
class Remembered {
 public:
  using Function = std::function<FourOf<Complex>(double)>;
  explicit Remembered(Function function) : function_(std::move(function)) {}

  Complex at(double y, std::size_t f) {
    const auto [place, fresh] = values_.try_emplace(y);
    if (fresh) place->second = function_(y);
    largest_ = std::max(largest_, std::abs(place->second[f]));
    return place->second[f];
  }
  double largest() const { return largest_; }

 private:
  Function function_;
  std::unordered_map<double, FourOf<Complex>> values_;
  double largest_ = 0.0;
};

void Inverter::add(const WaveArrival& arrival, double hidden, Sum& sum) {
  const FourOf<Series> fronts = front(*arrival.image);
  for (std::size_t f = 0; f < 4; ++f) {
    for (std::size_t k = 0; k < front_terms; ++k) {
      const double part =
          fronts[f].c[k] * arrival.piece->integral(static_cast<int>(k), arrival.since) / unit_[f];
      sum.value[f] += part;
      sum.error[f] += 8.0 * epsilon * std::abs(part);
    }
    const double jump = fronts[f].c[0] * arrival.piece->integral(0, 0.0) / unit_[f];
    if (arrival.since <= hidden) sum.error[f] += std::abs(jump);
  }
  if (arrival.since > 0.0) add_rest(arrival, fronts, sum);
}

void Inverter::add_rest(const WaveArrival& arrival, const FourOf<Series>& fronts, Sum& sum) {
  const double since = arrival.since;
  const double line = sigma(since);
  Remembered rest([&](double y) {
    const Complex s(line, y / since);
    FourOf<Complex> result = fields(*arrival.image, s);
    const Complex load = arrival.piece->transform(s) / since;
    for (std::size_t f = 0; f < 4; ++f) {
      const auto& c = fronts[f].c;
      result[f] = (result[f] - c[0] - (c[1] + c[2] / s) / s) * load / unit_[f];
    }
    return result;
  });
  const double factor = 2.0 / pi * std::exp(line * since);
  for (std::size_t f = 0; f < 4; ++f) {
    const Integral integral =
        quadrature_.to_infinity([&](double y) { return rest.at(y, f).real(); }, 0.0,
                                FourierIntegral::Weight::cosine, goal(factor));
    accept(integral, factor, rest.largest(), f, sum);
  }
}

bool Inverter::in_bands(double age) const {
  const Load& load = problem_.load;
  return load.shape() == LoadShape::sin4_pulse || load.shape() == LoadShape::ricker ||
         (load.shape() == LoadShape::smooth_ramp && age >= settled_age * load.duration());
}

void Inverter::add_in_bands(const Image& image, std::span<const LoadPiece> pieces, double age,
                            Sum& sum) {
  const double duration = problem_.load.duration();
  const bool wavelet = pieces.front().kind == Kind::wavelet;
  const double line = sigma(wavelet ? std::max(age, duration) : age);
  const double edge = (wavelet ? wavelet_band : smooth_band) / duration;
  add_head(image, pieces, age, line, edge, sum);
  if (wavelet) return;
  for (const LoadPiece& piece : pieces) {
    if (age > piece.start) add_tail({&image, &piece, age - piece.start}, line, edge, sum);
  }
}

void Inverter::add_head(const Image& image, std::span<const LoadPiece> pieces, double age,
                        double line, double edge, Sum& sum) {
  const bool ramp = pieces.front().kind == Kind::powers;
  const double unit_of_time = std::max(age, problem_.load.duration());
  Remembered head([&](double y) {
    const Complex s(line, y / unit_of_time);
    FourOf<Complex> result = fields(image, s);
    Complex load = ramp ? line::ramp_transform(problem_.load, s) : 0.0;
    for (const LoadPiece& piece : pieces) {
      if (!ramp && age > piece.start) load += piece.transform(s) * std::exp(-s * piece.start);
    }
    load *= std::polar(1.0, y * age / unit_of_time) / unit_of_time;
    for (std::size_t f = 0; f < 4; ++f) result[f] *= load / unit_[f];
    return result;
  });
  const double factor = std::exp(line * age) / pi;
  const double end = edge * unit_of_time;
  const int panels = 1 + static_cast<int>(end / head_panel);
  for (int panel = 0; panel < panels; ++panel) {
    for (std::size_t f = 0; f < 4; ++f) {
      const Integral integral =
          quadrature_.between([&](double y) { return head.at(y, f).real(); }, panel * end / panels,
                              (panel + 1) * end / panels, goal(factor) / panels);
      accept(integral, factor, head.largest() / panels, f, sum);
    }
  }
}

void Inverter::add_tail(const WaveArrival& arrival, double line, double edge, Sum& sum) {
  const double since = arrival.since;
  Remembered tail([&](double y) {
    const Complex s(line, y / since);
    FourOf<Complex> result = fields(*arrival.image, s);
    const Complex load = arrival.piece->transform(s) / since;
    for (std::size_t f = 0; f < 4; ++f) result[f] *= load / unit_[f];
    return result;
  });
  const double factor = std::exp(line * since) / pi;
  for (std::size_t f = 0; f < 4; ++f) {
    const Integral real =
        quadrature_.to_infinity([&](double y) { return tail.at(y, f).real(); }, edge * since,
                                FourierIntegral::Weight::cosine, goal(factor));
    accept(real, factor, tail.largest(), f, sum);
    const Integral imaginary =
        quadrature_.to_infinity([&](double y) { return tail.at(y, f).imag(); }, edge * since,
                                FourierIntegral::Weight::sine, goal(factor));
    accept(imaginary, -factor, tail.largest(), f, sum);
  }
}

BoundedFields unresolved() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double inf = std::numeric_limits<double>::infinity();
  return {{nan, nan, nan, nan}, {inf, inf, inf, inf}};
}

}  // namespace

BromwichSolution::BromwichSolution(const Problem& problem, double tolerance)
    : problem_(problem),
      tolerance_(tolerance),
      medium_(problem.material),
      pieces_(line::load_pieces(problem.load)) {
  if (tolerance >= 1e-13 && tolerance < 1.0) return;
  throw InputError(
      fmt::format("bromwich: tolerance = {}: expected a number from 1e-13 to below 1", tolerance));
}

BoundedFields BromwichSolution::at(double x, double t) const {
  const double length = problem_.column.length.value_or(std::numeric_limits<double>::max());
  if (!(x >= 0.0 && x <= length && std::isfinite(t))) {
    throw InputError(
        fmt::format("bromwich: x = {}, t = {}: expected x in the column and a finite t", x, t));
  }
  const double hidden = 8.0 * epsilon * std::abs(t);
  const auto images = line::images_until(problem_.column, medium_, x, t + hidden);
  if (images.size() > line::most_images) return unresolved();

  // A table with many points asks for more integrals than one of the others.
  const double integrals = static_cast<double>(std::max<std::size_t>(1, images.size()) *
                                               std::max<std::size_t>(1, pieces_.size()));
  Inverter inverter(problem_, medium_, 0.1 * tolerance_ / integrals);
  Sum sum;
  for (const Image& image : images) {
    const double age = t - image.arrival;
    if (inverter.in_bands(age)) {
      if (age > 0.0) inverter.add_in_bands(image, pieces_, age, sum);
      continue;
    }
    for (const LoadPiece& piece : pieces_) {
      const double since = age - piece.start;
      if (since >= -hidden) inverter.add({&image, &piece, since}, hidden, sum);
    }
  }
  for (const double error : sum.error) {
    if (!(error < 1.0)) return unresolved();
  }
  const Four& unit = inverter.unit();
  const auto fields = [&](const Four& four) {
    return Fields{four[0] * unit[0], four[1] * unit[1], four[2] * unit[2], four[3] * unit[3]};
  };
  return {fields(sum.value), fields(sum.error)};
}

}  // namespace porowave::reference
