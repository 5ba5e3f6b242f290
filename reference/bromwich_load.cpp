#include "reference/bromwich_load.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "reference/constants.hpp"

namespace porowave::reference::line {

namespace {

using Complex = std::complex<double>;

LoadPiece powers(double start, std::vector<LoadPiece::Power> terms) {
  return {LoadPiece::Kind::powers, start, 0.0, 0.0, std::move(terms)};
}

/// Jumps and changes of slope at the points of a table.
std::vector<LoadPiece> table_pieces(const Load& load) {
  std::vector<LoadPiece> pieces;
  double value = 0.0;
  double slope = 0.0;
  const auto& t = load.times();
  const auto& v = load.values();
  for (std::size_t i = 0; i < t.size(); ++i) {
    const bool more = i + 1 < t.size() && t[i + 1] > t[i];
    const double next = more ? (v[i + 1] - v[i]) / (t[i + 1] - t[i]) : 0.0;
    const double jump = load.magnitude() * (v[i] - value);
    const double bend = load.magnitude() * (next - slope);
    if (jump != 0.0 || bend != 0.0) pieces.push_back(powers(t[i], {{0, jump}, {1, bend}}));
    slope = next;
    value = more ? v[i + 1] : v[i];
  }
  return pieces;
}

}  // namespace

std::vector<LoadPiece> load_pieces(const Load& load) {
  const double q = load.magnitude();
  const double T = load.duration();
  switch (load.shape()) {
    case LoadShape::step:
      return {powers(0.0, {{0, q}})};
    case LoadShape::block:
      return {powers(0.0, {{0, q}}), powers(T, {{0, -q}})};
    case LoadShape::smooth_ramp: {
      // 10 z^3 - 15 z^4 + 6 z^5, and what makes it 1 from T on: 1 minus it, about z = 1.
      const double a = q / (T * T * T);
      return {powers(0.0, {{3, 60 * a}, {4, -360 * a / T}, {5, 720 * a / (T * T)}}),
              powers(T, {{3, -60 * a}, {4, -360 * a / T}, {5, -720 * a / (T * T)}})};
    }
    case LoadShape::sin4_pulse:
      return {{LoadPiece::Kind::sine, 0.0, T, q, {}}, {LoadPiece::Kind::sine, T, T, -q, {}}};
    case LoadShape::ricker:
      return {{LoadPiece::Kind::wavelet, 0.0, T, q, {}}};
    case LoadShape::table:
      break;
  }
  return table_pieces(load);
}

Complex LoadPiece::transform(Complex s) const {
  switch (kind) {
    case Kind::powers: {
      Complex sum = 0.0;
      for (const Power& term : powers) sum += term.size * std::pow(s, -(term.power + 1));
      return sum;
    }
    case Kind::sine: {
      const double w = 2.0 * pi / duration;
      const Complex square = s * s;
      return size * 1.5 * std::pow(w, 4) / (s * (square + w * w) * (square + 4.0 * w * w));
    }
    case Kind::wavelet:
      break;
  }
  // The wavelet is minus half the second derivative of e^(-a), a as in load.hpp.
  const Complex b = s * duration / 13.0;
  return -size * (duration / 13.0) * (0.5 * std::sqrt(pi)) * b * b *
         std::exp(0.25 * b * b - 0.5 * s * duration);
}

double LoadPiece::integral(int times, double tau) const {
  double sum = 0.0;
  for (const Power& term : powers) {
    const int order = term.power + times;
    sum += term.size * std::pow(tau, order) / std::tgamma(order + 1.0);
  }
  return sum;
}

Complex ramp_transform(const Load& load, Complex s) {
  using Rule = boost::math::quadrature::gauss<double, 30>;
  // Transform of the derivative 30 z^2 (1 - z)^2/T, over s.
  Complex sum = 0.0;
  for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
    for (const double sign : {-1.0, 1.0}) {
      const double z = 0.5 * (1.0 + sign * Rule::abscissa()[i]);
      const double rate = 30.0 * z * z * (1.0 - z) * (1.0 - z);
      sum += 0.5 * Rule::weights()[i] * rate * std::exp(-s * (z * load.duration()));
    }
  }
  return load.magnitude() * sum / s;
}

}  // namespace porowave::reference::line
