#include "reference/limits.hpp"

#include <array>
#include <cmath>

namespace porowave::reference {

namespace {

/// In the order effective stress, pore pressure, solid velocity, fluid velocity.
using Four = std::array<double, 4>;

double product(const Four& a, const Four& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

/// `of` . fields = `load` * q(t) at an end.
struct Condition {
  Four of;
  double load;
};

constexpr Four effective_stress = {1, 0, 0, 0};
constexpr Four pore_pressure = {0, 1, 0, 0};
constexpr Four total_stress = {1, -1, 0, 0};
constexpr Four solid_velocity = {0, 0, 1, 0};
constexpr Four fluid_velocity = {0, 0, 0, 1};
constexpr Four relative_velocity = {0, 0, 1, -1};

/// A wave that keeps its shape: v(t - x/speed) with the four fields of unit amplitude.
struct Wave {
  double speed;
  Four up;

  /// Both phases obey dp/dt = -K (n_s v_s' + n_f v_f') and d(sigma')/dt = E v_s'.
  Wave(const Material& m, double c, double solid, double fluid)
      : speed(c),
        up{-m.constrained_modulus * solid / c,
           m.storage_modulus() * (m.solid_fraction() * solid + m.porosity * fluid) / c, solid,
           fluid} {}

  Four down() const { return {-up[0], -up[1], up[2], up[3]}; }
};

/// Solves matrix . result = right.
std::array<double, 1> solve(const std::array<std::array<double, 1>, 1>& matrix,
                            const std::array<double, 1>& right) {
  return {right[0] / matrix[0][0]};
}
std::array<double, 2> solve(const std::array<std::array<double, 2>, 2>& m,
                            const std::array<double, 2>& right) {
  const double determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  return {(right[0] * m[1][1] - m[0][1] * right[1]) / determinant,
          (m[0][0] * right[1] - right[0] * m[1][0]) / determinant};
}

/// A column with as many undamped waves each way as there are conditions at each end.
template <std::size_t N>
class UndampedColumn {
 public:
  using Values = std::array<double, N>;

  UndampedColumn(const Problem& problem, const std::array<Wave, N>& waves,
                 const std::array<Condition, N>& near, const std::array<Condition, N>& far)
      : load_(problem.load), length_(problem.column.length.value_or(0.0)), waves_(waves) {
    Values loads;
    for (std::size_t i = 0; i < N; ++i) loads[i] = near[i].load;
    source_ = solve(seen_by(near, true), loads);
    at_near_ = reflection(near, true);
    if (problem.column.length) at_far_ = reflection(far, false);
  }

  Fields at(double x, double t) const {
    Four sum{};
    for (std::size_t k = 0; k < N; ++k) {
      const double c = waves_[k].speed;
      const double going_up = leaving_near(k, t - x / c);
      const double going_down = leaving_far(k, t - (length_ - x) / c);
      for (std::size_t f = 0; f < 4; ++f) {
        sum[f] += going_up * waves_[k].up[f] + going_down * waves_[k].down()[f];
      }
    }
    return {sum[0], sum[1], sum[2], sum[3]};
  }

 private:
  using Matrix = std::array<Values, N>;

  /// What the conditions of an end see of the waves that go up (or down) there.
  Matrix seen_by(const std::array<Condition, N>& end, bool up) const {
    Matrix seen;
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t k = 0; k < N; ++k) {
        seen[i][k] = product(end[i].of, up ? waves_[k].up : waves_[k].down());
      }
    }
    return seen;
  }

  /// [arriving wave][leaving wave]
  Matrix reflection(const std::array<Condition, N>& end, bool leaving_up) const {
    const Matrix leaving = seen_by(end, leaving_up);
    const Matrix arriving = seen_by(end, !leaving_up);
    Matrix result;
    for (std::size_t j = 0; j < N; ++j) {
      Values right;
      for (std::size_t i = 0; i < N; ++i) right[i] = -arriving[i][j];
      result[j] = solve(leaving, right);
    }
    return result;
  }

  double leaving_near(std::size_t k, double t) const {
    if (t < 0.0) return 0.0;
    double sum = source_[k] * load_.value(t);
    for (std::size_t j = 0; j < N; ++j) {
      if (std::abs(at_near_[j][k]) < negligible) continue;
      sum += at_near_[j][k] * leaving_far(j, t - length_ / waves_[j].speed);
    }
    return sum;
  }

  double leaving_far(std::size_t k, double t) const {
    if (t < 0.0) return 0.0;
    double sum = 0.0;
    for (std::size_t j = 0; j < N; ++j) {
      if (std::abs(at_far_[j][k]) < negligible) continue;
      sum += at_far_[j][k] * leaving_near(j, t - length_ / waves_[j].speed);
    }
    return sum;
  }

  static constexpr double negligible = 1e-14;  ///< rounding of an end that does not convert

  const Load& load_;
  double length_;
  std::array<Wave, N> waves_;
  Values source_;
  Matrix at_near_{};
  Matrix at_far_{};
};

std::array<Condition, 2> near_conditions(NearEnd end) {
  switch (end) {
    case NearEnd::drained_traction:
      return {Condition{effective_stress, -1.0}, Condition{pore_pressure, 0.0}};
    case NearEnd::sealed_traction:
      return {Condition{total_stress, -1.0}, Condition{relative_velocity, 0.0}};
    case NearEnd::fluid_pressure:
      return {Condition{effective_stress, 0.0}, Condition{pore_pressure, 1.0}};
    case NearEnd::velocity:
      break;
  }
  return {Condition{solid_velocity, 1.0}, Condition{fluid_velocity, 1.0}};
}

/// A half-space reflects nothing; its conditions are not used.
std::array<Condition, 2> far_conditions(FarEnd end) {
  switch (end) {
    case FarEnd::rigid_drained:
      return {Condition{solid_velocity, 0.0}, Condition{pore_pressure, 0.0}};
    case FarEnd::free_drained:
      return {Condition{effective_stress, 0.0}, Condition{pore_pressure, 0.0}};
    case FarEnd::rigid_sealed:
    case FarEnd::half_space:
      break;
  }
  return {Condition{solid_velocity, 0.0}, Condition{fluid_velocity, 0.0}};
}

/// Velocities r with (A - c^2 D) r = 0, from the row in which less cancels.
Wave frozen_wave(const Material& m, double c) {
  const double ns = m.solid_fraction();
  const double nf = m.porosity;
  const double K = m.storage_modulus();
  const double coupling = K * ns * nf;
  const double solid = c * c * m.solid_partial_density() - m.constrained_modulus - K * ns * ns;
  const double fluid = c * c * m.fluid_partial_density() - K * nf * nf;
  if (std::abs(solid) > std::abs(fluid)) return {m, c, coupling / solid, 1.0};
  return {m, c, 1.0, coupling / fluid};
}

}  // namespace

Fields undamped(const Problem& problem, double x, double t) {
  const WaveSpeeds speeds = wave_speeds(problem.material);
  const std::array<Wave, 2> waves = {frozen_wave(problem.material, speeds.p1),
                                     frozen_wave(problem.material, speeds.p2)};
  return UndampedColumn<2>(problem, waves, near_conditions(problem.column.near),
                           far_conditions(problem.column.far))
      .at(x, t);
}

Fields rigidly_coupled(const Problem& problem, double x, double t) {
  const Material& m = problem.material;
  const std::array<Wave, 1> wave = {Wave(m, m.undrained_speed(), 1.0, 1.0)};
  const std::array<Condition, 1> near = {problem.column.near == NearEnd::velocity
                                             ? Condition{solid_velocity, 1.0}
                                             : Condition{total_stress, -1.0}};
  const std::array<Condition, 1> far = {problem.column.far == FarEnd::free_drained
                                            ? Condition{total_stress, 0.0}
                                            : Condition{solid_velocity, 0.0}};
  return UndampedColumn<1>(problem, wave, near, far).at(x, t);
}

}  // namespace porowave::reference
