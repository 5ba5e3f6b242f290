#pragma once

// Weighting kernels w(r): their value and gradient for an offset vector, and the table that turns
// the name in a study file into a compile-time type.
//
// To add a kernel: copy kernels/kernel_skeleton.hpp, include it below and add its type to
// `Kernels`. Nothing else changes; the tests run over the table.

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "solver/kernels/bspline1.hpp"
#include "solver/kernels/bspline2.hpp"
#include "solver/kernels/bspline3.hpp"
#include "solver/kernels/wendland_c2.hpp"
#include "solver/kernels/wendland_c4.hpp"
#include "solver/kernels/wendland_c6.hpp"
#include "solver/vector.hpp"

namespace porowave::solver {

// ---- the table ----------------------------------------------------------------------------------

using Kernels = std::tuple<BSpline1, BSpline2, BSpline3, WendlandC2, WendlandC4, WendlandC6>;

inline constexpr std::size_t kernel_count = std::tuple_size_v<Kernels>;

// A kernel chosen at run time: its place in `Kernels`. Written as kernel_name<BSpline2>, or taken
// from kernel_from_name("bspline2").
enum class KernelName : std::size_t {};

namespace detail {

template <class Kernel, std::size_t... I>
constexpr std::size_t place_in_table(std::index_sequence<I...>) {
  static_assert((std::is_same_v<Kernel, std::tuple_element_t<I, Kernels>> || ...),
                "the kernel is not in the table");
  return ((std::is_same_v<Kernel, std::tuple_element_t<I, Kernels>> ? I : 0) + ...);
}

}  // namespace detail

template <class Kernel>
inline constexpr KernelName kernel_name{
    detail::place_in_table<Kernel>(std::make_index_sequence<kernel_count>{})};

// Calls f(Kernel{}) with the type behind the name and returns its result, which must have the same
// type for every kernel.
template <std::size_t I = 0, class F>
constexpr decltype(auto) visit_kernel(KernelName kernel, F&& f) {
  if constexpr (I + 1 < kernel_count) {
    if (kernel != KernelName{I}) return visit_kernel<I + 1>(kernel, std::forward<F>(f));
  }
  return std::forward<F>(f)(std::tuple_element_t<I, Kernels>{});
}

// All names, in the order of the table.
constexpr std::array<std::string_view, kernel_count> kernel_names() {
  return std::apply([](auto... kernel) { return std::array{decltype(kernel)::name...}; },
                    Kernels{});
}

constexpr std::string_view to_string(KernelName kernel) {
  return visit_kernel(kernel, [](auto k) { return decltype(k)::name; });
}

// Empty for a name that is not in the table.
constexpr std::optional<KernelName> kernel_from_name(std::string_view name) {
  for (std::size_t i = 0; i < kernel_count; ++i) {
    if (kernel_names()[i] == name) return KernelName{i};
  }
  return std::nullopt;
}

// The usual support radius, in element lengths h.
constexpr double natural_radius(KernelName kernel) {
  return visit_kernel(kernel, [](auto k) { return decltype(k)::natural_radius; });
}

// ---- evaluation ---------------------------------------------------------------------------------

// w(r), dimensionless, and ∂w/∂r, in 1/length. With r = x_p − x the gradient in x is its negative.
template <int Dim>
struct Weight {
  double value;
  Vector<Dim> gradient;
};

// w(r) of a kernel stretched to the support radius (same unit as r, > 0).
// Radial: w = φ(|r|/R). Otherwise the product over the axes of φ(|r_a|/R).
template <class Kernel, int Dim>
double weight_value(const Vector<Dim>& offset, double support_radius) {
  if constexpr (Kernel::radial) {
    return Kernel::value(offset.norm() / support_radius);
  } else {
    double product = 1.0;
    for (int a = 0; a < Dim; ++a) product *= Kernel::value(std::abs(offset[a]) / support_radius);
    return product;
  }
}

// w(r) and its gradient. At a kink (the centre of bspline1) the gradient is the mean of both sides.
template <class Kernel, int Dim>
Weight<Dim> weight(const Vector<Dim>& offset, double support_radius) {
  if constexpr (Kernel::radial) {
    const double distance = offset.norm();
    const double q = distance / support_radius;
    // φ'(q) vanishes at least like q, so the direction at the centre does not matter.
    const double slope = distance > 0.0 ? Kernel::derivative(q) / (support_radius * distance) : 0.0;
    return {Kernel::value(q), slope * offset};
  } else {
    Weight<Dim> w{1.0, Vector<Dim>::Ones()};
    for (int a = 0; a < Dim; ++a) {
      const double q = std::abs(offset[a]) / support_radius;
      const double sign = (offset[a] > 0.0) - (offset[a] < 0.0);
      const double factor = Kernel::value(q);
      const double slope = sign * Kernel::derivative(q) / support_radius;
      for (int b = 0; b < Dim; ++b) w.gradient[b] *= (a == b) ? slope : factor;
      w.value *= factor;
    }
    return w;
  }
}

}  // namespace porowave::solver
