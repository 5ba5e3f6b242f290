#include "reference/digits/column_waves.hpp"

namespace porowave::fixtures::digits {

namespace {

/// What two fields, or sums of fields, are prescribed at an end: [row][field].
using Conditions = std::array<std::array<int, 4>, 2>;

constexpr std::array<int, 4> effective_stress = {1, 0, 0, 0};
constexpr std::array<int, 4> pressure = {0, 1, 0, 0};
constexpr std::array<int, 4> total_stress = {1, -1, 0, 0};
constexpr std::array<int, 4> solid_velocity = {0, 0, 1, 0};
constexpr std::array<int, 4> fluid_velocity = {0, 0, 0, 1};
constexpr std::array<int, 4> relative_velocity = {0, 0, 1, -1};

Conditions conditions(NearEnd end) {
  switch (end) {
    case NearEnd::sealed_traction:
      return {total_stress, relative_velocity};
    case NearEnd::velocity:
      return {solid_velocity, fluid_velocity};
    case NearEnd::drained_traction:
    case NearEnd::fluid_pressure:
      break;
  }
  return {effective_stress, pressure};
}

/// The prescribed values for a unit load.
std::array<int, 2> load_of(NearEnd end) {
  switch (end) {
    case NearEnd::drained_traction:
    case NearEnd::sealed_traction:
      return {-1, 0};
    case NearEnd::fluid_pressure:
      return {0, 1};
    case NearEnd::velocity:
      break;
  }
  return {1, 1};
}

Conditions conditions(FarEnd end) {
  switch (end) {
    case FarEnd::rigid_drained:
      return {solid_velocity, pressure};
    case FarEnd::free_drained:
      return {effective_stress, pressure};
    case FarEnd::rigid_sealed:
    case FarEnd::half_space:
      break;
  }
  return {solid_velocity, fluid_velocity};
}

template <class C>
Matrix<C> in_modes(const Conditions& rows, const std::array<FourFields<C>, 2>& modes) {
  Matrix<C> result;
  for (std::size_t row = 0; row < 2; ++row) {
    for (std::size_t mode = 0; mode < 2; ++mode) {
      C sum(0);
      for (std::size_t f = 0; f < 4; ++f) {
        if (rows[row][f] == 1) sum += modes[mode][f];
        if (rows[row][f] == -1) sum -= modes[mode][f];
      }
      result[row][mode] = sum;
    }
  }
  return result;
}

/// The solution y of matrix y = right.
template <class C>
Pair<C> solve(const Matrix<C>& m, const Pair<C>& right) {
  const C det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  return {C((right[0] * m[1][1] - m[0][1] * right[1]) / det),
          C((m[0][0] * right[1] - right[0] * m[1][0]) / det)};
}

template <class C>
Matrix<C> diagonal(int value) {
  return {{{C(value), C(0)}, {C(0), C(value)}}};
}

/// leaving = -leaving_fields^-1 arriving_fields arriving. Ends that do not convert have a plain
/// sign, and rounding must not make waves there that do not exist.
template <class C>
Matrix<C> reflection(const Conditions& rows, const std::array<FourFields<C>, 2>& leaving,
                     const std::array<FourFields<C>, 2>& arriving) {
  if (rows[0] == solid_velocity && rows[1] == fluid_velocity) return diagonal<C>(-1);
  if (rows[0] == effective_stress && rows[1] == pressure) return diagonal<C>(1);
  const Matrix<C> out = in_modes(rows, leaving);
  const Matrix<C> in = in_modes(rows, arriving);
  const Pair<C> first = solve<C>(out, {C(-in[0][0]), C(-in[1][0])});
  const Pair<C> second = solve<C>(out, {C(-in[0][1]), C(-in[1][1])});
  return {{{first[0], second[0]}, {first[1], second[1]}}};
}

}  // namespace

template <class C>
template <class R>
ColumnWaves<C>::ColumnWaves(const Medium<R>& m, const Column& column, const C& at, Labels labels)
    : s(at) {
  const Pair<C> slowness = m.slowness(s, labels);
  const C friction = m.drag / s;
  for (std::size_t k = 0; k < 2; ++k) {
    wave_number[k] = s * slowness[k];
    // First row of (D + (d/s) J - slowness^2 A) r = 0.
    const C squared = slowness[k] * slowness[k];
    const C solid = friction + squared * m.A[1];
    const C fluid = m.solid + friction - squared * m.A[0];
    const C stress = -m.modulus * slowness[k] * solid;
    const C pore = m.storage * slowness[k] * (m.ns * solid + m.nf * fluid);
    up[k] = {stress, pore, solid, fluid};
    down[k] = {C(-stress), C(-pore), solid, fluid};
  }
  const Conditions near = conditions(column.near);
  const auto load = load_of(column.near);
  source = solve<C>(in_modes(near, up), {C(load[0]), C(load[1])});
  at_near = reflection(near, up, down);
  at_far = column.far == FarEnd::half_space ? diagonal<C>(0)
                                            : reflection(conditions(column.far), down, up);
}

template ColumnWaves<ComplexOf<Real50>>::ColumnWaves(const Medium<Real50>&, const Column&,
                                                     const ComplexOf<Real50>&, Labels);
template ColumnWaves<ComplexOf<Real100>>::ColumnWaves(const Medium<Real100>&, const Column&,
                                                      const ComplexOf<Real100>&, Labels);

}  // namespace porowave::fixtures::digits
