#include "reference/load_convolution.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "reference/phi.hpp"

namespace porowave::reference {

namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;

/// integral_0^tau e^(s (tau - t')) dt'
Complex constant(Complex s, double tau) {
  return tau * phi_functions<1>(s * tau)[1];
}

/// q = z^3 (10 - 15 z + 6 z^2), z = t/T; t^n/n! convolves to tau^(n+1) phi_(n+1)(s tau).
Complex smooth_ramp(Complex s, double tau, double T) {
  const auto phi = phi_functions<6>(s * tau);
  const double z = tau / T;
  return tau * z * z * z * (60.0 * phi[4] - z * (360.0 * phi[5] - z * 720.0 * phi[6]));
}

/// sin^4(pi t/T) = 3/8 - cos(w t)/2 + cos(2 w t)/8, w = 2 pi/T; a sum of exponentials e^(iat),
/// each of which convolves to e^(ia tau) tau phi_1((s - ia) tau).
Complex sin4_pulse(Complex s, double tau, double T) {
  Complex sum = 0.375 * constant(s, tau);
  for (const auto& [harmonic, weight] : {std::pair(1.0, -0.25), std::pair(2.0, 0.0625)}) {
    for (const double sign : {1.0, -1.0}) {
      const Complex frequency(0.0, sign * harmonic * 2.0 * pi / T);
      sum += weight * std::exp(frequency * tau) * constant(s - frequency, tau);
    }
  }
  return sum;
}

/// Gauss-Legendre panels; the wavelet and e^(s t) both vary little within one.
Complex ricker(Complex s, double tau, const Load& shape) {
  using Rule = boost::math::quadrature::gauss<double, 30>;
  const double T = shape.duration();
  const auto panels = static_cast<int>(8.0 + std::abs(s) * tau / 8.0);
  const double width = std::min(tau, T) / panels;
  Complex sum = 0.0;
  for (int panel = 0; panel < panels; ++panel) {
    const double middle = (panel + 0.5) * width;
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      for (const double sign : {1.0, -1.0}) {
        const double t = middle + sign * 0.5 * width * Rule::abscissa()[i];
        sum += 0.5 * width * Rule::weights()[i] * shape.value(t) * std::exp(s * (tau - t));
      }
    }
  }
  return sum;
}

/// Pieces v + slope t': h phi_1 and h^2 phi_2, carried on from each piece's end.
Complex table(Complex s, double tau, const Load& load) {
  const auto& t = load.times();
  const auto& v = load.values();
  Complex sum = 0.0;
  for (std::size_t i = 0; i < t.size() && t[i] < tau; ++i) {
    const bool last = i + 1 == t.size();
    const double end = last ? tau : std::min(t[i + 1], tau);
    const double h = end - t[i];
    if (h <= 0.0) continue;
    const double slope = last ? 0.0 : (v[i + 1] - v[i]) / (t[i + 1] - t[i]);
    const auto phi = phi_functions<2>(s * h);
    sum += std::exp(s * (tau - end)) * (h * (v[i] * phi[1] + slope * h * phi[2]));
  }
  return sum;
}

std::vector<std::pair<double, double>> find_jumps(const Load& load) {
  const double size = load.magnitude();
  switch (load.shape()) {
    case LoadShape::step:
      return {{0.0, size}};
    case LoadShape::block:
      return {{0.0, size}, {load.duration(), -size}};
    case LoadShape::table: {
      std::vector<std::pair<double, double>> jumps = {{load.times()[0], size * load.values()[0]}};
      for (std::size_t i = 0; i + 1 < load.times().size(); ++i) {
        if (load.times()[i] < load.times()[i + 1]) continue;
        jumps.emplace_back(load.times()[i], size * (load.values()[i + 1] - load.values()[i]));
      }
      return jumps;
    }
    default:
      return {};
  }
}

}  // namespace

LoadConvolution::LoadConvolution(const Load& load) : load_(load), jumps_(find_jumps(load)) {}

Complex LoadConvolution::unit(Complex s, double tau) const {
  const double T = load_.duration();
  const double within = std::min(tau, T);
  const double after = tau - within;
  switch (load_.shape()) {
    case LoadShape::step:
      return constant(s, tau);
    case LoadShape::block:
      return std::exp(s * after) * constant(s, within);
    case LoadShape::sin4_pulse:
      return std::exp(s * after) * sin4_pulse(s, within, T);
    case LoadShape::smooth_ramp: {
      const Complex ramp = smooth_ramp(s, within, T);
      return after > 0.0 ? std::exp(s * after) * ramp + constant(s, after) : ramp;
    }
    case LoadShape::ricker:
      return ricker(s, tau, Load(LoadShape::ricker, 1.0, T));
    case LoadShape::table:
      return table(s, tau, load_);
  }
  return 0.0;
}

Complex LoadConvolution::operator()(Complex s, double tau) const {
  return load_.magnitude() * unit(s, tau);
}

}  // namespace porowave::reference
