#include "solver/stability/growth.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>

namespace porowave::solver {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr int basis_size = 24;
constexpr double outgrown = 14.0;  // e^14: what a mode at the limit is ahead of the others
constexpr double eigenvalue_tolerance = 1e-5;

std::span<const double> in(const VectorXd& x) {
  return {x.data(), static_cast<std::size_t>(x.size())};
}
std::span<double> out(VectorXd& x) {
  return {x.data(), static_cast<std::size_t>(x.size())};
}

std::vector<std::complex<double>> unit_mode(const VectorXcd& mode) {
  const VectorXcd unit = mode / mode.norm();
  return {unit.data(), unit.data() + unit.size()};
}

VectorXd noise(std::size_t size, unsigned seed) {
  std::mt19937_64 generator(seed);
  VectorXd x(static_cast<Eigen::Index>(size));
  for (double& value : x) value = static_cast<double>(generator() >> 11) * 0x1p-52 - 1.0;
  return x.normalized();
}

// Noise, and ten times as much of the guess.
VectorXd start_of(std::size_t size, const GrowthSettings& settings) {
  VectorXd x = noise(size, settings.seed);
  if (settings.guess.size() != size) return x;
  for (std::size_t i = 0; i < size; ++i) {
    x[static_cast<Eigen::Index>(i)] += 10.0 * (settings.guess[i].real() + settings.guess[i].imag());
  }
  return x.normalized();
}

// A state that is stepped on, kept at unit norm, and the logarithm of what it was divided by.
struct March {
  const LinearMap& map;
  VectorXd x;
  VectorXd next{x.size()};
  double log_size = 0.0;
  long steps = 0;

  void run(long count) {
    for (long n = 0; n < count; ++n) {
      map.apply(in(x), out(next));
      x.swap(next);
      if (++steps % 16 == 0) normalise();
    }
    normalise();
  }
  void normalise() {
    const double size = x.norm();
    log_size += std::log(size);  // −∞ from when nothing is left
    if (size > 0.0) x /= size;
  }
};

// The dominant pair that Arnoldi's method finds for a power of the map.
struct RitzPair {
  std::complex<double> value;  // of one step
  VectorXcd vector;
  double residual = HUGE_VAL;  // of the power, as a share of the value
  long steps = 0;
};

RitzPair arnoldi(const LinearMap& map, const VectorXd& start, int power) {
  const auto most = std::min<Eigen::Index>(basis_size, start.size());
  MatrixXd basis(start.size(), most + 1);
  MatrixXd hessenberg = MatrixXd::Zero(most + 1, most);
  basis.col(0) = start.normalized();
  Eigen::Index m = 0;
  VectorXd x, next(start.size());
  while (m < most) {
    x = basis.col(m);
    for (int n = 0; n < power; ++n) {
      map.apply(in(x), out(next));
      x.swap(next);
    }
    const double size = x.norm();
    for (int pass = 0; pass < 2; ++pass) {  // the second removes the rounding of the first
      const VectorXd parts = basis.leftCols(m + 1).transpose() * x;
      x -= basis.leftCols(m + 1) * parts;
      hessenberg.col(m).head(m + 1) += parts;
    }
    hessenberg(m + 1, m) = x.norm();
    ++m;
    if (hessenberg(m, m - 1) <= 1e-14 * size) break;  // an invariant space
    basis.col(m) = x / hessenberg(m, m - 1);
  }
  const Eigen::EigenSolver<MatrixXd> small(hessenberg.topLeftCorner(m, m).eval());
  Eigen::Index best = 0;
  small.eigenvalues().cwiseAbs().maxCoeff(&best);
  const std::complex<double> theta = small.eigenvalues()[best];
  const VectorXcd weights = small.eigenvectors().col(best);
  RitzPair pair;
  pair.steps = power * m;
  pair.vector = basis.leftCols(m) * weights;
  pair.residual = hessenberg(m, m - 1) * std::abs(weights[m - 1]) / std::abs(theta);
  pair.value = std::polar(std::pow(std::abs(theta), 1.0 / power), std::arg(theta) / power);
  return pair;
}

// Rayleigh's quotient of one step: the phase that the power leaves open.
std::complex<double> one_step_value(const LinearMap& map, const VectorXcd& mode) {
  VectorXd next(mode.size());
  VectorXcd after(mode.size());
  const VectorXd real = mode.real(), imaginary = mode.imag();
  map.apply(in(real), out(next));
  after.real() = next;
  map.apply(in(imaginary), out(next));
  after.imag() = next;
  return mode.dot(after) / mode.squaredNorm();
}

}  // namespace

Growth growth(const LinearMap& map, const GrowthSettings& settings) {
  return map.size <= settings.largest_dense ? dense_growth(map, settings.want_mode)
                                            : iterated_growth(map, settings);
}

Growth dense_growth(const LinearMap& map, bool want_mode) {
  const auto n = static_cast<Eigen::Index>(map.size);
  MatrixXd matrix(n, n);
  VectorXd unit = VectorXd::Zero(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    unit[k] = 1.0;
    map.apply(in(unit), {matrix.col(k).data(), map.size});
    unit[k] = 0.0;
  }
  Growth found;
  found.steps = static_cast<long>(map.size);
  if (!matrix.allFinite()) {
    found.per_step = HUGE_VAL;
    return found;
  }
  const Eigen::EigenSolver<MatrixXd> solver(matrix, want_mode);
  Eigen::Index best = 0;
  found.per_step = solver.eigenvalues().cwiseAbs().maxCoeff(&best);
  found.eigenvalue = solver.eigenvalues()[best];
  if (want_mode) found.mode = unit_mode(solver.eigenvectors().col(best));
  found.settled = solver.info() == Eigen::Success;
  return found;
}

Growth iterated_growth(const LinearMap& map, const GrowthSettings& settings) {
  March march{map, start_of(map.size, settings)};
  const long most = static_cast<long>(std::ceil(outgrown / settings.limit));
  Growth found;
  double half_size = 0.0;
  for (long next = 256; !found.settled; next *= 4) {
    next = std::min(next, most);
    if (next == most) {
      march.run(std::max(most / 2 - march.steps, 0L));
      half_size = march.log_size;
    }
    const long before = march.steps;
    march.run(next - march.steps);
    const int power = static_cast<int>(std::clamp(next / 32, 1L, 64L));
    const RitzPair pair = arnoldi(map, march.x, power);
    found.steps += pair.steps;
    const bool grows = std::abs(pair.value) > 1.0 + settings.limit;
    if (grows && pair.residual <= eigenvalue_tolerance * power) {
      found.settled = true;
      found.per_step = std::abs(pair.value);
      found.eigenvalue = one_step_value(map, pair.vector);
      if (settings.want_mode) found.mode = unit_mode(pair.vector);
    } else if (next == most) {
      const double rate = (march.log_size - half_size) / static_cast<double>(most - before);
      found.per_step = march.log_size == -HUGE_VAL ? 0.0 : std::exp(rate);
      break;
    }
  }
  found.steps += march.steps;
  return found;
}

}  // namespace porowave::solver
