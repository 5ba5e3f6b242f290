#pragma once

// Shape functions of the grid N_i, and the table that turns the name in a study file into a
// compile-time type.
//
// Every shape is one even function S(t), t = (x − x_i)/h, of an infinite row of nodes, with
// Σ_i S(t − i) = 1 and Σ_i i S(t − i) = t; in Dim > 1 a product over the axes. `half` is half the
// edge of the point's domain over h. The column has no nodes beyond its ends: those are replaced by
// what a linear field through the last two nodes would give them, u_−k = (1 + k) u_0 − k u_1, so
//
//   N_0 = S_0 + Σ_k (1 + k) S_−k,   N_1 = S_1 − Σ_k k S_−k,
//
// which keeps both properties up to the ends, makes N_0 = 1 there and stays >= 0: for splines the
// boundary functions of Steffen, Wallstedt, Guilkey, Kirby & Berzins (2008), CMES 31, 107-127. The
// cubic N_0 is 1 − r + r³/6 in the first cell; the quadratic one is linear in the first half cell;
// GIMP sees a point whose domain sticks out as if the linear functions went on.
//
// To add a shape: one file like shapes/gimp.hpp, included below, and its type in `Shapes`. The
// tests run over the table.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "solver/kernels/bspline1.hpp"
#include "solver/kernels/bspline2.hpp"
#include "solver/kernels/bspline3.hpp"
#include "solver/shapes/gimp.hpp"
#include "solver/shapes/spline_shape.hpp"
#include "solver/weights.hpp"

namespace porowave::solver {

using LinearSpline = SplineShape<BSpline1>;
using Shapes = std::tuple<LinearSpline, SplineShape<BSpline2>, SplineShape<BSpline3>,
                          GimpShape<false>, GimpShape<true>>;

inline constexpr std::size_t shape_count = std::tuple_size_v<Shapes>;

// A shape chosen at run time: its place in `Shapes`.
enum class ShapeName : std::size_t {};

// Written as shape_name<LinearSpline>, or taken from shape_from_name("bspline1").
template <class Shape, std::size_t I = 0>
constexpr ShapeName place_of_shape() {
  if constexpr (std::is_same_v<Shape, std::tuple_element_t<I, Shapes>>) {
    return ShapeName{I};
  } else {
    return place_of_shape<Shape, I + 1>();
  }
}
template <class Shape>
inline constexpr ShapeName shape_name = place_of_shape<Shape>();

constexpr std::array<std::string_view, shape_count> shape_names() {
  return std::apply([](auto... shape) { return std::array{decltype(shape)::name...}; }, Shapes{});
}

constexpr std::string_view to_string(ShapeName shape) {
  return shape_names()[static_cast<std::size_t>(shape)];
}

// Empty for a name that is not in the table.
constexpr std::optional<ShapeName> shape_from_name(std::string_view name) {
  for (std::size_t i = 0; i < shape_count; ++i) {
    if (shape_names()[i] == name) return ShapeName{i};
  }
  return std::nullopt;
}

// Calls f(Shape{}) with the type behind the name.
template <std::size_t I = 0, class F>
constexpr decltype(auto) visit_shape(ShapeName shape, F&& f) {
  if constexpr (I + 1 < shape_count) {
    if (shape != ShapeName{I}) return visit_shape<I + 1>(shape, std::forward<F>(f));
  }
  return std::forward<F>(f)(std::tuple_element_t<I, Shapes>{});
}

// True if the points' domains follow the strain of the solid.
constexpr bool convects_domains(ShapeName shape) {
  return visit_shape(shape, [](auto s) { return decltype(s)::convects; });
}

// N_i(x_p) and ∂N_i/∂x_a(x_p); all structures are the same. `domain` is the edge of every point's
// domain in the unit of the coordinates (> 0), used by gimp and cpgimp only and else may be empty.
// Outside the grid the linear functions of the nearest cell are continued.
// Throws std::invalid_argument for positions or domains that are not finite or do not fit.
template <int Dim>
LinearRows<Dim> shape_rows(std::span<const Vector<Dim>> points, std::span<const double> domain,
                           const Grid<Dim>& grid, ShapeName shape);

}  // namespace porowave::solver
