#pragma once

// To add a kernel: copy this file, give it a name, a formula and a source, include it in kernel.hpp
// and add its type to `Kernels` there. kernel_test.cpp compiles this one as well.
//
//   φ(q) = 1 − q,  φ'(q) = −1,  q < 1
//
// q = distance / support radius >= 0. A kernel is positive and falls up to q = 1, and is zero from
// there on; its size does not matter. Its derivative is that in q.
// Source: author (year), doi.

#include <string_view>

namespace porowave::solver {

struct KernelSkeleton {
  static constexpr std::string_view name = "skeleton";  // the word in a case file
  static constexpr double natural_radius = 1.0;         // in element lengths h
  static constexpr bool radial = false;                 // φ(|r|/R), or a product over the axes

  static constexpr double value(double q) { return q < 1.0 ? 1.0 - q : 0.0; }
  static constexpr double derivative(double q) { return q < 1.0 ? -1.0 : 0.0; }
};

}  // namespace porowave::solver
