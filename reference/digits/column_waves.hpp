#pragma once

#include "reference/digits/medium.hpp"

namespace porowave::fixtures::digits {

/// Transforms of effective stress, pore pressure, solid velocity and fluid velocity.
template <class C>
using FourFields = std::array<C, 4>;
/// Amplitudes of the two modes; matrices act on them, [row][column].
template <class C>
using Pair = std::array<C, 2>;
template <class C>
using Matrix = std::array<Pair<C>, 2>;

/// True if the ends turn one mode into the other.
constexpr bool converts(const Column& column) {
  return column.near == NearEnd::sealed_traction || column.far == FarEnd::rigid_drained;
}

/// The waves in the column at one s: fields of both modes running up (to larger x) and down, for
/// unit amplitude, and what the ends make of them.
template <class C>
struct ColumnWaves {
  C s;
  Pair<C> wave_number;              ///< lambda
  std::array<FourFields<C>, 2> up;  ///< fields of a mode that runs up
  std::array<FourFields<C>, 2> down;
  Pair<C> source;     ///< leaving x = 0, per unit of the transformed load
  Matrix<C> at_near;  ///< arriving at x = 0 -> leaving
  Matrix<C> at_far;   ///< arriving at x = length -> leaving; 0 for a half-space

  template <class R>
  ColumnWaves(const Medium<R>& medium, const Column& column, const C& at, Labels labels);
};

extern template ColumnWaves<ComplexOf<Real50>>::ColumnWaves(const Medium<Real50>&, const Column&,
                                                            const ComplexOf<Real50>&, Labels);
extern template ColumnWaves<ComplexOf<Real100>>::ColumnWaves(const Medium<Real100>&, const Column&,
                                                             const ComplexOf<Real100>&, Labels);

}  // namespace porowave::fixtures::digits
