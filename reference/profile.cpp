#include "reference/profile.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/smooth_pieces.hpp"
#include "reference/time_slice.hpp"

namespace porowave::reference {

namespace {

using FourValues = std::array<double, 4>;

FourValues as_array(const Fields& f) {
  return {f.effective_stress, f.pore_pressure, f.solid_velocity, f.fluid_velocity};
}

/// Last coefficients below this share of the load end the refinement.
constexpr double target = 2e-14;
constexpr int most_halvings = 24;
/// Places, as shares of a piece from either end, where the series is compared with the solution:
/// layers thinner than the distance of the roots are not seen in its coefficients.
constexpr std::array<double, 4> trials = {0.0007, 0.021, 0.973, 0.9991};
constexpr std::array<unsigned, 4> degrees = {12, 20, 36, 64};

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
  const std::vector<double> ends = smooth_pieces(solution, t, end);
  TimeSlice slice(solution, t);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    add(slice, solution.problem(), ends[i], ends[i + 1], 0);
}

void Profile::add(TimeSlice& slice, const Problem& problem, double begin, double end, int depth) {
  const double stress = problem.stress_scale();
  const double velocity = problem.velocity_scale();
  const FourValues scale = {stress, stress, velocity, velocity};
  Piece piece{begin, end, {}};
  if (!std::isfinite(error_)) {  // one unresolved value spoils the profile; the rest may take hours
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    piece.coefficients.assign(1, {nan, nan, nan, nan});
    pieces_.push_back(std::move(piece));
    return;
  }
  double value_error = 0.0;
  double interpolation = std::numeric_limits<double>::infinity();
  for (const unsigned degree : degrees) {
    std::vector<FourValues> values;
    value_error = 0.0;
    bool at_rest = true;
    for (unsigned j = 0; j < degree; ++j) {
      const double root = std::cos((j + 0.5) * std::numbers::pi / degree);
      const auto fields = slice.at(0.5 * (begin + end) + 0.5 * (end - begin) * root);
      ++evaluations_;
      values.push_back(as_array(fields.value));
      const auto bounds = as_array(fields.error);
      for (std::size_t f = 0; f < 4; ++f) {
        value_error = std::max(value_error, bounds[f] / scale[f]);
        at_rest = at_rest && values.back()[f] == 0.0;
      }
      if (at_rest && j == 0) break;  // ahead of the first front, all of the piece is
      if (!std::isfinite(value_error)) break;
    }
    piece.coefficients =
        at_rest ? std::vector<FourValues>(1, FourValues{}) : coefficients_of(values);
    interpolation = at_rest ? 0.0 : tail(piece.coefficients, scale);
    if (!at_rest && interpolation <= std::max(target, value_error)) {
      interpolation = std::max(interpolation, 0.125 * largest_deviation(slice, piece, scale));
    }
    // Coefficients of values with errors cannot fall below those.
    if (interpolation <= std::max(target, value_error) || !std::isfinite(value_error)) break;
  }
  const bool done = interpolation <= std::max(target, value_error);
  if (!done && std::isfinite(value_error) && depth < most_halvings) {
    const double middle = 0.5 * (begin + end);
    add(slice, problem, begin, middle, depth + 1);
    add(slice, problem, middle, end, depth + 1);
    return;
  }
  // NaN coefficients (an unresolved value) must not look like a small error.
  const double error =
      value_error + 8.0 * interpolation + summation_error(piece.coefficients, scale);
  error_ = std::isfinite(error) ? std::max(error_, error) : std::numeric_limits<double>::infinity();
  pieces_.push_back(std::move(piece));
}

double Profile::largest_deviation(TimeSlice& slice, const Piece& piece, const FourValues& scale) {
  double largest = 0.0;
  for (const double share : trials) {
    const double x = std::lerp(piece.begin, piece.end, share);
    const FourValues exact = as_array(slice.at(x).value);
    const FourValues series = as_array(piece.at(x));
    ++evaluations_;
    for (std::size_t f = 0; f < 4; ++f) {
      largest = std::max(largest, std::abs(series[f] - exact[f]) / scale[f]);
    }
  }
  return largest;
}

Fields Profile::at(double x) const {
  const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), x,
                                      [](double value, const Piece& p) { return value < p.begin; });
  return (after == pieces_.begin() ? *after : *(after - 1)).at(x);
}

double Profile::integral(const std::function<double(const Fields&)>& f) const {
  using boost::math::quadrature::gauss;
  double sum = 0.0;
  for (const Piece& piece : pieces_) {
    const auto at_place = [&](double x) { return f(piece.at(x)); };
    // A rule of n nodes integrates the square of a series of n terms.
    const std::size_t terms = piece.coefficients.size();
    if (terms == 1) {
      sum += (piece.end - piece.begin) * at_place(piece.begin);
    } else if (terms <= degrees[0]) {
      sum += gauss<double, degrees[0]>::integrate(at_place, piece.begin, piece.end);
    } else if (terms <= degrees[1]) {
      sum += gauss<double, degrees[1]>::integrate(at_place, piece.begin, piece.end);
    } else {
      sum += gauss<double, degrees[2]>::integrate(at_place, piece.begin, piece.end);
    }
  }
  return sum;
}

Fields Profile::Piece::at(double x) const {
  const double u = (2.0 * x - begin - end) / (end - begin);
  FourValues b1{};
  FourValues b2{};
  for (std::size_t k = coefficients.size() - 1; k > 0; --k) {  // Clenshaw
    for (std::size_t f = 0; f < 4; ++f) {
      const double b0 = coefficients[k][f] + 2.0 * u * b1[f] - b2[f];
      b2[f] = b1[f];
      b1[f] = b0;
    }
  }
  FourValues value;
  for (std::size_t f = 0; f < 4; ++f) value[f] = coefficients[0][f] + u * b1[f] - b2[f];
  return {value[0], value[1], value[2], value[3]};
}

}  // namespace porowave::reference
