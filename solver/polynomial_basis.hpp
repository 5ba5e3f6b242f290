#pragma once

// All monomials in Dim variables of total degree <= Order, graded: constant, linear (in the order
// of the axes), quadratic, ... The first size_up_to(k) of them are the complete basis of degree k,
// which is what lets moving least squares fall back to a lower degree.
//
// Example, Dim = 2, Order = 2:  1, ξ, η, ξ², ξη, η².

#include <array>

#include "solver/vector.hpp"

namespace porowave::solver {

template <int Dim, int Order>
struct PolynomialBasis {
  static_assert(Dim >= 1 && Dim <= 3 && Order >= 0 && Order <= 3);

  // Number of monomials of total degree <= degree: the binomial (Dim + degree over Dim).
  static constexpr int size_up_to(int degree) {
    int count = 1;
    for (int a = 1; a <= Dim; ++a) count = count * (degree + a) / a;
    return count;
  }

  static constexpr int size = size_up_to(Order);

  using Values = Eigen::Matrix<double, size, 1>;

  // Monomial j is monomial `parent` times the coordinate of `axis`.
  struct Monomial {
    int degree = 0;
    int parent = 0;
    int axis = 0;
  };

  // Only axes >= the parent's last one are appended, so that ξη appears once.
  static constexpr std::array<Monomial, size> monomials = [] {
    std::array<Monomial, size> table{};
    std::size_t count = 1;
    for (std::size_t parent = 0; parent < count; ++parent) {
      if (table[parent].degree == Order) break;
      for (int axis = table[parent].axis; axis < Dim; ++axis) {
        table[count++] = {table[parent].degree + 1, static_cast<int>(parent), axis};
      }
    }
    return table;
  }();

  // p(ξ)
  static Values at(const Vector<Dim>& xi) {
    Values p;
    p[0] = 1.0;
    for (int j = 1; j < size; ++j) {
      const Monomial& m = monomials[static_cast<std::size_t>(j)];
      p[j] = p[m.parent] * xi[m.axis];
    }
    return p;
  }
};

}  // namespace porowave::solver
