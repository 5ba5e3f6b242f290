#include "verification/cost/relative_fit.hpp"

#include <algorithm>
#include <cmath>

namespace porowave::verification {

namespace {

/// Normal equations of the scaled problem, each term brought to unit length.
struct NormalEquations {
  explicit NormalEquations(std::span<const Measurement> measurements)
      : count(measurements.front().terms.size()),
        matrix(count * count),
        right(count),
        length(count) {
    for (const Measurement& m : measurements) {
      for (std::size_t i = 0; i < count; ++i) length[i] += std::pow(m.terms[i] / m.value, 2);
    }
    for (double& l : length) l = std::sqrt(l);
    for (const Measurement& m : measurements) {
      for (std::size_t i = 0; i < count; ++i) {
        right[i] += scaled(m, i);
        for (std::size_t j = 0; j < count; ++j)
          matrix[i * count + j] += scaled(m, i) * scaled(m, j);
      }
    }
  }
  double scaled(const Measurement& m, std::size_t i) const {
    return length[i] > 0.0 ? m.terms[i] / m.value / length[i] : 0.0;
  }

  std::size_t count;
  std::vector<double> matrix;
  std::vector<double> right;
  std::vector<double> length;
};

}  // namespace

std::vector<double> relative_fit(std::span<const Measurement> measurements) {
  if (measurements.empty()) return {};
  constexpr int most_sweeps = 1'000'000;
  constexpr double negligible = 1e-13;
  const NormalEquations equations(measurements);
  std::vector<double> constants(equations.count, 0.0);
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double largest_change = 0.0;
    for (std::size_t i = 0; i < equations.count; ++i) {
      if (equations.length[i] == 0.0) continue;
      double residual = equations.right[i];
      for (std::size_t j = 0; j < equations.count; ++j) {
        residual -= equations.matrix[i * equations.count + j] * constants[j];
      }
      const double next = std::max(0.0, constants[i] + residual);
      largest_change = std::max(largest_change, std::abs(next - constants[i]));
      constants[i] = next;
    }
    if (largest_change < negligible) break;
  }
  for (std::size_t i = 0; i < equations.count; ++i) {
    if (equations.length[i] > 0.0) constants[i] /= equations.length[i];
  }
  return constants;
}

}  // namespace porowave::verification
