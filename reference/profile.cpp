#include "reference/profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace porowave::reference {

namespace {

using FourValues = std::array<double, 4>;

FourValues as_array(const Fields& f) {
  return {f.effective_stress, f.pore_pressure, f.solid_velocity, f.fluid_velocity};
}

/// Last coefficients below this share of the load end the refinement.
constexpr double target = 2e-14;
constexpr int most_halvings = 14;
constexpr std::array<int, 3> degrees = {16, 32, 64};

/// Times at which the load or its derivatives break; each travels with every ray.
std::vector<double> load_breaks(const Load& load) {
  if (load.shape() == LoadShape::table) return load.times();
  if (has_duration(load.shape())) return {0.0, load.duration()};
  return {0.0};
}

std::vector<double> piece_ends(const ColumnSolution& solution, double t, double end) {
  std::vector<double> ends = {0.0, end};
  for (const double time : load_breaks(solution.problem().load)) {
    if (t <= time) continue;
    for (const double x : solution.fronts(t - time)) {
      if (x > 0.0 && x < end) ends.push_back(x);
    }
  }
  std::sort(ends.begin(), ends.end());
  // Fronts closer than rounding are one.
  const auto same = [end](double a, double b) { return b - a <= 1e-13 * end; };
  ends.erase(std::unique(ends.begin(), ends.end(), same), ends.end());
  ends.back() = end;
  return ends;
}

/// Chebyshev coefficients from values at the n roots cos((j + 1/2) pi/n).
std::vector<FourValues> coefficients_of(const std::vector<FourValues>& values) {
  const std::size_t n = values.size();
  std::vector<FourValues> coefficients(n, FourValues{});
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t j = 0; j < n; ++j) {
      const double angle = static_cast<double>(k * (2 * j + 1) % (4 * n));
      const double cosine = std::cos(angle * std::numbers::pi / (2.0 * static_cast<double>(n)));
      for (std::size_t f = 0; f < 4; ++f) coefficients[k][f] += cosine * values[j][f];
    }
    for (double& c : coefficients[k]) c *= (k == 0 ? 1.0 : 2.0) / static_cast<double>(n);
  }
  return coefficients;
}

/// Size of the last eighth of the coefficients, relative to the scales.
double tail(const std::vector<FourValues>& coefficients, const FourValues& scale) {
  double size = 0.0;
  for (std::size_t k = coefficients.size() - coefficients.size() / 8; k < coefficients.size();
       ++k) {
    for (std::size_t f = 0; f < 4; ++f) {
      size = std::max(size, std::abs(coefficients[k][f]) / scale[f]);
    }
  }
  return size;
}

/// What summing the series may lose: its terms, not its sum, are rounded.
double summation_error(const std::vector<FourValues>& coefficients, const FourValues& scale) {
  double worst = 0.0;
  for (std::size_t f = 0; f < 4; ++f) {
    double sum = 0.0;
    for (const FourValues& c : coefficients) sum += std::abs(c[f]) / scale[f];
    worst = std::max(worst, 16.0 * std::numeric_limits<double>::epsilon() * sum);
  }
  return worst;
}

}  // namespace

Profile::Profile(const ColumnSolution& solution, double t, double end) : time_(t) {
  const std::vector<double> ends = piece_ends(solution, t, end);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) add(solution, ends[i], ends[i + 1], 0);
}

void Profile::add(const ColumnSolution& solution, double begin, double end, int depth) {
  const double stress = solution.problem().stress_scale();
  const double velocity = solution.problem().velocity_scale();
  const FourValues scale = {stress, stress, velocity, velocity};
  Piece piece{begin, end, {}};
  double value_error = 0.0;
  double interpolation = std::numeric_limits<double>::infinity();
  for (const int degree : degrees) {
    std::vector<FourValues> values;
    value_error = 0.0;
    bool at_rest = true;
    for (int j = 0; j < degree; ++j) {
      const double root = std::cos((j + 0.5) * std::numbers::pi / degree);
      const auto fields = solution.at(0.5 * (begin + end) + 0.5 * (end - begin) * root, time_);
      ++evaluations_;
      values.push_back(as_array(fields.value));
      const auto bounds = as_array(fields.error);
      for (std::size_t f = 0; f < 4; ++f) {
        value_error = std::max(value_error, bounds[f] / scale[f]);
        at_rest = at_rest && values.back()[f] == 0.0;
      }
      if (at_rest && j == 0) break;  // ahead of the first front, all of the piece is
    }
    piece.coefficients =
        at_rest ? std::vector<FourValues>(1, FourValues{}) : coefficients_of(values);
    interpolation = at_rest ? 0.0 : tail(piece.coefficients, scale);
    // Coefficients of values with errors cannot fall below those.
    if (interpolation <= std::max(target, value_error) || !std::isfinite(value_error)) break;
  }
  const bool done = interpolation <= std::max(target, value_error);
  if (!done && std::isfinite(value_error) && depth < most_halvings) {
    const double middle = 0.5 * (begin + end);
    add(solution, begin, middle, depth + 1);
    add(solution, middle, end, depth + 1);
    return;
  }
  // NaN coefficients (an unresolved value) must not look like a small error.
  const double error =
      value_error + 8.0 * interpolation + summation_error(piece.coefficients, scale);
  error_ = std::isfinite(error) ? std::max(error_, error) : std::numeric_limits<double>::infinity();
  pieces_.push_back(std::move(piece));
}

Fields Profile::at(double x) const {
  const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), x,
                                      [](double value, const Piece& p) { return value < p.begin; });
  const Piece& piece = after == pieces_.begin() ? *after : *(after - 1);
  const double u = (2.0 * x - piece.begin - piece.end) / (piece.end - piece.begin);
  FourValues b1{};
  FourValues b2{};
  for (std::size_t k = piece.coefficients.size() - 1; k > 0; --k) {  // Clenshaw
    for (std::size_t f = 0; f < 4; ++f) {
      const double b0 = piece.coefficients[k][f] + 2.0 * u * b1[f] - b2[f];
      b2[f] = b1[f];
      b1[f] = b0;
    }
  }
  FourValues value;
  for (std::size_t f = 0; f < 4; ++f) value[f] = piece.coefficients[0][f] + u * b1[f] - b2[f];
  return {value[0], value[1], value[2], value[3]};
}

}  // namespace porowave::reference
