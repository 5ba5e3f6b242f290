#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "reference/modal_modes.hpp"

namespace porowave::reference::quarter_wave {

namespace {

/// Number of layers, and of terms in 1/k^2 that they match.
constexpr int orders = 4;

/// A combination of derivatives of q for both components: [n] multiplies q^(n).
using Derivatives = std::array<std::vector<double>, 2>;

Pair value(const Derivatives& of, const SmoothLoad& load) {
  Pair sum{};
  for (std::size_t k = 0; k < 2; ++k) {
    for (std::size_t n = 0; n < of[k].size(); ++n) {
      if (of[k][n] != 0.0) sum[k] += of[k][n] * load.derivative(static_cast<int>(n));
    }
  }
  return sum;
}

/// W_i from Z_i.
Derivatives velocity_term(const Frame& frame, Derivatives stress) {
  for (std::size_t k = 0; k < 2; ++k) {
    stress[k].insert(stress[k].begin(), 0.0);
    for (double& term : stress[k]) term /= frame.speed()[k];
  }
  return stress;
}

/// Z_i+1 from W_i.
Derivatives stress_term(const Frame& frame, const Derivatives& velocity) {
  const Pair& g = frame.drag();
  const Pair& c = frame.speed();
  Derivatives stress;
  for (std::size_t k = 0; k < 2; ++k) {
    stress[k].assign(velocity[k].size() + 1, 0.0);
    for (std::size_t n = 0; n < velocity[k].size(); ++n) {
      stress[k][n + 1] += velocity[k][n] / c[k];
      stress[k][n] += g[k] * (g[0] * velocity[0][n] + g[1] * velocity[1][n]) / c[k];
    }
  }
  return stress;
}

/// cosh(m (L - x))/cosh(m L) and the same with sinh, without overflow.
Pair hyperbolic(double m, double length, double x) {
  const double decay = std::exp(-m * x) / (1.0 + std::exp(-2.0 * m * length));
  const double mirrored = std::exp(-2.0 * m * (length - x));
  return {decay * (1.0 + mirrored), decay * (1.0 - mirrored)};
}

}  // namespace

EndLayers::EndLayers(const Frame& frame, const SmoothLoad& load, double length, double peak)
    : length_(length) {
  Derivatives stress = {std::vector<double>{frame.boundary()[0]},
                        std::vector<double>{frame.boundary()[1]}};
  constant_ = value(stress, load);
  Eigen::Matrix<double, orders, 2> Z;
  Eigen::Matrix<double, orders, 2> W;
  for (int i = 0; i < orders; ++i) {
    const Derivatives velocity = velocity_term(frame, stress);
    stress = stress_term(frame, velocity);
    const Pair w = value(velocity, load);
    const Pair z = value(stress, load);
    W.row(i) << w[0], w[1];
    Z.row(i) << z[0], z[1];
  }
  // As thick as keeps every term Z_i/m^(2i) of the size of the load.
  const double unit = peak * std::hypot(frame.boundary()[0], frame.boundary()[1]);
  double squared = 1.0 / (length * length);
  for (int i = 0; i < orders; ++i) {
    squared = std::max(squared, std::pow(Z.row(i).norm() / unit, 1.0 / (i + 1)));
  }
  // sum_j factor_j m_j^(2i) = -Z_(i+1) and -W_i, with m_j^2 = j m^2.
  Eigen::Matrix<double, orders, orders> powers;
  for (int i = 0; i < orders; ++i) {
    for (int j = 0; j < orders; ++j) powers(i, j) = std::pow(j + 1.0, i);
    Z.row(i) *= -std::pow(squared, -i);
    W.row(i) *= -std::pow(squared, -i);
  }
  const Eigen::PartialPivLU<Eigen::Matrix<double, orders, orders>> solver(powers);
  const Eigen::Matrix<double, orders, 2> in_z = solver.solve(Z);
  const Eigen::Matrix<double, orders, 2> in_w = solver.solve(W);
  for (int j = 0; j < orders; ++j) {
    layers_.push_back(
        {std::sqrt((j + 1) * squared), {in_z(j, 0), in_z(j, 1)}, {in_w(j, 0), in_w(j, 1)}});
  }
}

Amplitudes EndLayers::at(double x) const {
  Amplitudes sum = {constant_[0], constant_[1], 0.0, 0.0};
  for (const Layer& layer : layers_) {
    const Pair h = hyperbolic(layer.m, length_, x);
    for (std::size_t k = 0; k < 2; ++k) {
      sum[k] += layer.stress[k] * (1.0 - h[0]) / (layer.m * layer.m);
      sum[2 + k] += layer.velocity[k] * h[1] / layer.m;
    }
  }
  return sum;
}

Amplitudes EndLayers::coefficients(double k, double share) const {
  Amplitudes sum{};
  for (const Layer& layer : layers_) {
    const double of_sine = share / (k * k + layer.m * layer.m);
    for (std::size_t mode = 0; mode < 2; ++mode) {
      sum[mode] += layer.stress[mode] * of_sine;
      sum[2 + mode] += layer.velocity[mode] * of_sine * k;
    }
  }
  return sum;
}

double EndLayers::size() const {
  double largest = std::hypot(constant_[0], constant_[1]);
  for (const Layer& layer : layers_) {
    largest = std::max({largest, std::hypot(layer.stress[0], layer.stress[1]) / (layer.m * layer.m),
                        std::hypot(layer.velocity[0], layer.velocity[1]) / layer.m});
  }
  return largest;
}

}  // namespace porowave::reference::quarter_wave
