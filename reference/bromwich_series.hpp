#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace porowave::reference {

/// A real power series in u = 1/s, cut off after u^3. What is computed with it from functions of u
/// gives their expansion for large s, so one piece of code serves a complex s and the fronts.
struct Series {
  static constexpr std::size_t size = 4;
  std::array<double, size> c{};  ///< of u^0, u^1, ...

  constexpr Series(double constant = 0.0) : c{constant} {}  // NOLINT: a number is a series
  /// The series of u itself.
  static constexpr Series variable() {
    Series u;
    u.c[1] = 1.0;
    return u;
  }

  friend Series operator+(Series a, const Series& b) {
    for (std::size_t i = 0; i < size; ++i) a.c[i] += b.c[i];
    return a;
  }
  friend Series operator-(Series a, const Series& b) {
    for (std::size_t i = 0; i < size; ++i) a.c[i] -= b.c[i];
    return a;
  }
  friend Series operator-(const Series& a) { return Series() - a; }
  friend Series operator*(const Series& a, const Series& b) {
    Series product;
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; i + j < size; ++j) product.c[i + j] += a.c[i] * b.c[j];
    }
    return product;
  }
  /// Term by term from quotient * b = a; b.c[0] is not 0.
  friend Series operator/(const Series& a, const Series& b) {
    Series quotient;
    for (std::size_t i = 0; i < size; ++i) {
      double rest = a.c[i];
      for (std::size_t j = 0; j < i; ++j) rest -= quotient.c[j] * b.c[i - j];
      quotient.c[i] = rest / b.c[0];
    }
    return quotient;
  }
  /// Term by term from root * root = a; a.c[0] > 0.
  friend Series sqrt(const Series& a) {
    Series root(std::sqrt(a.c[0]));
    for (std::size_t i = 1; i < size; ++i) {
      double rest = a.c[i];
      for (std::size_t j = 1; j < i; ++j) rest -= root.c[j] * root.c[i - j];
      root.c[i] = 0.5 * rest / root.c[0];
    }
    return root;
  }
  /// Term by term from e' = a' e.
  friend Series exp(const Series& a) {
    Series e(std::exp(a.c[0]));
    for (std::size_t i = 1; i < size; ++i) {
      for (std::size_t j = 1; j <= i; ++j) {
        e.c[i] += static_cast<double>(j) * a.c[j] * e.c[i - j] / static_cast<double>(i);
      }
    }
    return e;
  }
};

}  // namespace porowave::reference
