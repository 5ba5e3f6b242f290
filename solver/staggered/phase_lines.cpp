#include "solver/staggered/phase_lines.hpp"

#include <algorithm>
#include <cmath>

#include "reference/problem/errors.hpp"
#include "solver/staggered/reconstruction.hpp"

namespace porowave::solver {

namespace {

CubicLine velocity_line(const Column& column, std::size_t cells, double spacing) {
  const bool rigid = column.far == FarEnd::rigid_sealed || column.far == FarEnd::half_space;
  return CubicLine::nodes(cells, spacing, EndRule::open, rigid ? EndRule::odd : EndRule::open);
}

// Where a rigid wall lets fluid through, or moves, its stresses have no symmetry. At a sealed
// loaded end the sum of both is known: the pressure is continued, the effective stress held.
CubicLine stress_line(const Column& column, Phase phase, std::size_t cells, double spacing) {
  const bool solid = phase == Phase::solid;
  EndRule near = EndRule::held;
  if (column.near == NearEnd::velocity) near = EndRule::open;
  if (column.near == NearEnd::sealed_traction && !solid) near = EndRule::open;
  EndRule far = EndRule::even;
  if (column.far == FarEnd::free_drained) far = EndRule::held;
  if (column.far == FarEnd::rigid_drained) far = solid ? EndRule::open : EndRule::held;
  return CubicLine::middles(cells, spacing, near, far);
}

// The points that a place sees reach this many places to either side, with the cubics.
std::size_t half_width(double support_radius) {
  const auto reach = static_cast<std::size_t>(std::min(std::ceil(support_radius), 4.0)) + 1;
  return std::max<std::size_t>(reach, 2);
}

// (9/8 (f_1 − f_0) − 1/24 (f_2 − f_−1))/h for out_0 ... out_count−1, f_0 under out_0.
void staggered_difference(const double* __restrict f, double* __restrict out, std::size_t count,
                          double spacing) {
  const double inner = 9.0 / 8.0 / spacing;
  const double outer = 1.0 / 24.0 / spacing;
  for (std::size_t k = 0; k < count; ++k) {
    out[k] = inner * (f[k + 1] - f[k]) - outer * (f[k + 2] - *(f + k - 1));
  }
}

}  // namespace

double at(const CubicRow& row, const std::vector<double>& values) {
  double sum = 0.0;
  for (std::size_t j = 0; j < 4; ++j) sum += row.weight[j] * values[row.index[j]];
  return sum;
}

PhaseLines::PhaseLines(const Case& scene, Phase phase, double spacing)
    : cells_(static_cast<std::size_t>(scene.discretization.elements)),
      spacing_(spacing),
      velocity_line_(velocity_line(scene.problem.column, cells_, spacing)),
      stress_line_(stress_line(scene.problem.column, phase, cells_, spacing)) {
  PlacedPoints placed = place_points(scene.discretization, spacing, phase);
  x_ = std::move(placed.x);
  volume_ = std::move(placed.volume);
  velocity_through_points_ = through_points(scene, velocity_line_, 0.0, cells_ + 1, cells_ + 1);
  stress_through_points_ = through_points(scene, stress_line_, 0.5 * spacing, cells_, cells_ + 2);
  for (auto* values : {&velocity_sum, &displacement, &velocity}) values->assign(cells_ + 1, 0.0);
  for (auto* values : {&stress_sum, &stress}) values->assign(cells_ + 2, 0.0);

  const auto x = [&](double places) { return spacing * places; };
  const auto n = static_cast<double>(cells_);
  stress_slope_rows_ = {stress_line_.slope(0.0), stress_line_.slope(x(1.0)),
                        stress_line_.slope(x(n - 1.0)), stress_line_.slope(x(n))};
  velocity_slope_rows_ = {velocity_line_.slope(x(0.5)), velocity_line_.slope(x(n - 0.5))};
  near_end_row_ = stress_line_.value(0.0);
}

BandMatrix PhaseLines::through_points(const Case& scene, const CubicLine& line, double first,
                                      std::size_t places, std::size_t values) {
  const Discretization& d = scene.discretization;
  std::vector<double> x(places);
  for (std::size_t k = 0; k < places; ++k) x[k] = first + spacing_ * static_cast<double>(k);
  const AdaptiveRows phi =
      adaptive_rows(x, x_, {d.kernel, d.support_radius * spacing_, d.basis_order});
  if (phi.empty > 0) {
    throw BreakdownError(
        "step 0: a node or cell middle is out of reach of every point, even with an enlarged "
        "support; more points per element would reach it");
  }
  reduced_rows_ += phi.reduced;
  const std::size_t shift = values - places == 0 ? 0 : 1;  // a value for the near end comes first
  return through(phi.rows, x_, line, {values, shift, half_width(d.support_radius)});
}

void PhaseLines::reconstruct(std::size_t end) {
  velocity_through_points_.multiply(velocity_sum, velocity, end);
  stress_through_points_.multiply(stress_sum, std::span(stress).subspan(1), end);
}

void PhaseLines::stress_slopes(const std::vector<double>& values, std::vector<double>& slopes,
                               std::size_t end) const {
  const std::size_t inner_end = std::min(end, cells_ - 1);
  staggered_difference(values.data() + 2, slopes.data() + 2, inner_end - 2, spacing_);
  slopes[0] = at(stress_slope_rows_[0], values);
  slopes[1] = at(stress_slope_rows_[1], values);
  if (end < cells_ + 1) return;
  slopes[cells_ - 1] = at(stress_slope_rows_[2], values);
  slopes[cells_] = at(stress_slope_rows_[3], values);
}

void PhaseLines::velocity_slopes(const std::vector<double>& values, std::vector<double>& slopes,
                                 std::size_t end) const {
  const std::size_t inner_end = std::min(end, cells_ - 1);
  staggered_difference(values.data() + 1, slopes.data() + 1, inner_end - 1, spacing_);
  slopes[0] = at(velocity_slope_rows_[0], values);
  if (end >= cells_) slopes[cells_ - 1] = at(velocity_slope_rows_[1], values);
}

double PhaseLines::stress_at_near_end(const std::vector<double>& values) const {
  return at(near_end_row_, values);
}

PhasePoints PhaseLines::points() const {
  PhasePoints points{x_, volume_, {}, {}};
  for (std::size_t p = 0; p < x_.size(); ++p) {
    const CubicRow row = velocity_line_.value(x_[p]);
    points.velocity.push_back(at(row, velocity_sum));
    points.stress.push_back(at(stress_line_.value(x_[p]), stress_sum));
    points.x[p] += at(row, displacement);
  }
  return points;
}

}  // namespace porowave::solver
