#include "reference/modal_modes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace porowave::reference::quarter_wave {

namespace {

using Complex = std::complex<double>;
using Roots = std::array<Complex, 4>;
using ComplexAmplitudes = std::array<Complex, 4>;

/// Roots nearer to each other than this share of their size, and whose difference does not matter
/// within the time t, are not taken singly.
constexpr double near_roots = 1e-2;
/// Radius of the contour around such roots, in units of their half distance, at least, and of their
/// distance from others, at most; and its nodes, which leave 3^-64.
constexpr double clearance = 3.0;
constexpr int contour_nodes = 64;

/// One mode: z' = -kappa w + force q', w' = kappa z - g (g . w), kappa = c k.
struct Mode {
  Pair kappa;
  Pair g;
  Pair force;

  /// det(s - matrix)
  Complex determinant(Complex s) const {
    const Complex a = s * s + kappa[0] * kappa[0];
    const Complex b = s * s + kappa[1] * kappa[1];
    return a * b + s * (g[0] * g[0] * b + g[1] * g[1] * a);
  }
  Complex determinant_slope(Complex s) const {
    const Complex a = s * s + kappa[0] * kappa[0];
    const Complex b = s * s + kappa[1] * kappa[1];
    const double g0 = g[0] * g[0];
    const double g1 = g[1] * g[1];
    return 2.0 * s * (a + b) + g0 * b + g1 * a + 2.0 * s * s * (g0 + g1);
  }
  /// (s - matrix)^-1 (force, 0) times the determinant.
  ComplexAmplitudes numerator(Complex s) const {
    ComplexAmplitudes result;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t o = 1 - k;
      const Complex other = s * s + kappa[o] * kappa[o];
      const double coupling = g[0] * g[1] * kappa[o] * force[o];
      result[k] =
          force[k] * ((s + g[k] * g[k]) * other + s * s * (g[o] * g[o])) + kappa[k] * coupling;
      result[2 + k] = kappa[k] * force[k] * (other + s * (g[o] * g[o])) - s * coupling;
    }
    return result;
  }
  Roots roots() const;
};

Roots Mode::roots() const {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  for (int k = 0; k < 2; ++k) {
    const auto i = static_cast<std::size_t>(k);
    matrix(k, 2 + k) = -kappa[i];
    matrix(2 + k, k) = kappa[i];
    for (int o = 0; o < 2; ++o) matrix(2 + k, 2 + o) = -g[i] * g[static_cast<std::size_t>(o)];
  }
  const Eigen::EigenSolver<Eigen::Matrix4d> solver(matrix, false);
  Roots roots;
  double largest = 0.0;
  for (int i = 0; i < 4; ++i) largest = std::max(largest, std::abs(solver.eigenvalues()(i)));
  for (int i = 0; i < 4; ++i) {
    Complex& root = roots[static_cast<std::size_t>(i)];
    root = solver.eigenvalues()(i);
    // The solver's error is relative to the largest root; small ones (consolidation) are improved.
    for (int step = 0; step < 2 && std::abs(root) < 1e-2 * largest; ++step) {
      const Complex change = determinant(root) / determinant_slope(root);
      if (std::abs(change) < 1e-6 * std::abs(root)) root -= change;
    }
  }
  return roots;
}

/// The residue of the resolvent at one root, times what the load has done to it.
ComplexAmplitudes residue(const Mode& mode, const SmoothLoad& load, const Roots& roots,
                          std::size_t i) {
  Complex factor = load.response(roots[i]);
  for (std::size_t j = 0; j < 4; ++j) {
    if (j != i) factor /= roots[i] - roots[j];
  }
  ComplexAmplitudes result = mode.numerator(roots[i]);
  for (Complex& amplitude : result) amplitude *= factor;
  return result;
}

/// Some roots inside of a circle without others.
struct Cluster {
  std::vector<std::size_t> members;
  Complex centre;
  double radius;
};

/// Takes more roots into the cluster until the circle keeps clear of those within and without.
void settle(Cluster& cluster, const Roots& roots, double largest_radius) {
  while (true) {
    cluster.centre = 0.0;
    for (const std::size_t i : cluster.members) cluster.centre += roots[i];
    cluster.centre /= static_cast<double>(cluster.members.size());
    double inside = 0.0;
    double outside = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const double distance = std::abs(roots[i] - cluster.centre);
      if (std::count(cluster.members.begin(), cluster.members.end(), i) > 0) {
        inside = std::max(inside, distance);
      } else if (distance < outside) {
        outside = distance;
        nearest = i;
      }
    }
    cluster.radius = std::max(clearance * inside, std::min(largest_radius, outside / clearance));
    if (cluster.radius * clearance <= outside * (1.0 + 1e-9)) return;
    cluster.members.push_back(nearest);
  }
}

ComplexAmplitudes contour(const Mode& mode, const SmoothLoad& load, const Roots& roots,
                          const Cluster& cluster) {
  ComplexAmplitudes sum{};
  for (int node = 0; node < contour_nodes; ++node) {
    const Complex step =
        std::polar(cluster.radius, 2.0 * std::numbers::pi * (node + 0.5) / contour_nodes);
    const Complex s = cluster.centre + step;
    Complex factor = load.response(s) * step / static_cast<double>(contour_nodes);
    for (const Complex& root : roots) factor /= s - root;
    const ComplexAmplitudes numerator = mode.numerator(s);
    for (std::size_t f = 0; f < 4; ++f) sum[f] += factor * numerator[f];
  }
  return sum;
}

/// A pair of roots that must not be taken singly, if there is one.
std::vector<std::size_t> near_pair(const Roots& roots, double t) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      const double gap = std::abs(roots[i] - roots[j]);
      if (gap < near_roots * std::abs(roots[i]) && gap * t < 1.0) return {i, j};
    }
  }
  return {};
}

}  // namespace

Frame::Frame(const Problem& problem) {
  const Material& m = problem.material;
  const double E = m.constrained_modulus;
  const double K = m.storage_modulus();
  const Eigen::Vector2d root_density(std::sqrt(m.solid_partial_density()),
                                     std::sqrt(m.fluid_partial_density()));
  Eigen::Matrix2d B;
  B << std::sqrt(E) / root_density(0), 0.0, std::sqrt(K) * m.solid_fraction() / root_density(0),
      std::sqrt(K) * m.porosity / root_density(1);
  const Eigen::JacobiSVD<Eigen::Matrix2d> svd(B, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix2d& X = svd.matrixU();
  const Eigen::Matrix2d& W = svd.matrixV();
  const Eigen::Vector2d prescribed = problem.column.near == NearEnd::fluid_pressure
                                         ? Eigen::Vector2d(0.0, -1.0 / std::sqrt(K))
                                         : Eigen::Vector2d(-1.0 / std::sqrt(E), 0.0);
  const Eigen::Vector2d relative(1.0 / root_density(0), -1.0 / root_density(1));
  for (int k = 0; k < 2; ++k) {
    const auto i = static_cast<std::size_t>(k);
    speed_[i] = svd.singularValues()(k);
    drag_[i] = std::sqrt(m.drag()) * W.col(k).dot(relative);
    boundary_[i] = X.col(k).dot(prescribed);
    stress_[0][i] = std::sqrt(E) * X(0, k);
    stress_[1][i] = -std::sqrt(K) * X(1, k);
    for (int phase = 0; phase < 2; ++phase) {
      velocity_[static_cast<std::size_t>(phase)][i] = W(phase, k) / root_density(phase);
    }
  }
}

std::array<double, 4> Frame::fields(const Amplitudes& a) const {
  return {stress_[0][0] * a[0] + stress_[0][1] * a[1], stress_[1][0] * a[0] + stress_[1][1] * a[1],
          velocity_[0][0] * a[2] + velocity_[0][1] * a[3],
          velocity_[1][0] * a[2] + velocity_[1][1] * a[3]};
}

Amplitudes mode_amplitudes(const Frame& frame, const SmoothLoad& load, double t, double k,
                           double share) {
  Mode mode;
  mode.g = frame.drag();
  for (std::size_t i = 0; i < 2; ++i) {
    mode.kappa[i] = frame.speed()[i] * k;
    mode.force[i] = -frame.boundary()[i] * share;
  }
  const Roots roots = mode.roots();
  Cluster cluster{near_pair(roots, t), 0.0, 0.0};
  Amplitudes sum{};
  const auto add = [&](const ComplexAmplitudes& part, double weight) {
    for (std::size_t f = 0; f < 4; ++f) sum[f] += weight * part[f].real();
  };
  if (cluster.members.empty()) {
    for (std::size_t i = 0; i < 4; ++i) {
      // Complex roots come with their conjugates.
      if (roots[i].imag() < 0.0) continue;
      add(residue(mode, load, roots, i), roots[i].imag() > 0.0 ? 2.0 : 1.0);
    }
    return sum;
  }
  // The conjugate of a pair off the real axis is as near; its part is the conjugate.
  settle(cluster, roots, 2.0 / t);
  const bool mirrored = std::abs(cluster.centre.imag()) > cluster.radius;
  add(contour(mode, load, roots, cluster), mirrored ? 2.0 : 1.0);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& in = cluster.members;
    if (std::count(in.begin(), in.end(), i) > 0) continue;
    if (mirrored && std::abs(roots[i] - std::conj(cluster.centre)) < cluster.radius) continue;
    add(residue(mode, load, roots, i), 1.0);
  }
  return sum;
}

}  // namespace porowave::reference::quarter_wave
