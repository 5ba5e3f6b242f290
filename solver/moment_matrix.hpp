#pragma once

// The moment matrix of moving least squares and its factorisation M = L D Lᵀ, which finds the
// highest polynomial degree that the points around can carry.
//
// No pivoting: the basis is graded, so the leading blocks of one factorisation are the moment
// matrices of all lower degrees, and a fall-back costs nothing. (Cholesky's method is backward
// stable without pivoting.)
//
// Conditioning. The ratio d_j / M_jj is the share of monomial j, in the inner product of the
// weighted points, that the monomials before it cannot express: 1 for an orthogonal one, 0 if the
// points cannot tell it apart (collinear or coincident points, or too few). It does not depend on
// the unit of length or on the sum of weights. The condition reported is 1 / min_j (d_j / M_jj),
// the largest variance inflation factor met by the elimination. It is the condition of M after
// scaling to a unit diagonal, up to a factor that only depends on the size.
// Sources: van der Sluis (1969), doi:10.1007/BF02165096 (unit diagonal is nearly the best scaling);
// Higham, Accuracy and Stability of Numerical Algorithms (2002), sec. 10.1 (error of Cholesky).

#include <algorithm>

#include "solver/polynomial_basis.hpp"

namespace porowave::solver {

template <int Dim, int Order>
class MomentMatrix {
 public:
  using Basis = PolynomialBasis<Dim, Order>;
  using Coefficients = typename Basis::Values;

  // M += w p pᵀ; p is in coordinates centred at the evaluation point and scaled by the support.
  void add(double w, const typename Basis::Values& p) {
    for (int j = 0; j < Basis::size; ++j) {
      const double wp = w * p[j];
      for (int i = j; i < Basis::size; ++i) lower_(i, j) += wp * p[i];
    }
  }

  // Overwrites M by L and D, degree by degree, as far as the condition stays below the limit.
  void factorise(double max_condition) {
    double condition = 1.0;
    for (int degree = 0; degree <= Order; ++degree) {
      const int end = Basis::size_up_to(degree);
      for (int j = degree == 0 ? 0 : Basis::size_up_to(degree - 1); j < end; ++j) {
        const double diagonal = lower_(j, j);
        eliminate(j);
        // Written so that 0/0 (a monomial that vanishes at every point) is a rejection.
        if (!(lower_(j, j) * max_condition > diagonal)) return;
        condition = std::max(condition, diagonal / lower_(j, j));
      }
      order_ = degree;
      condition_ = condition;
    }
  }

  // Highest degree accepted; -1 if there is no weight at all.
  int order() const { return order_; }

  // Condition at that degree, >= 1; 0 if there is none.
  double condition() const { return condition_; }

  // M⁻¹ b at the degree accepted (>= 0); coefficients of higher degrees are zero.
  Coefficients solve(const Coefficients& b) const {
    const int n = Basis::size_up_to(order_);
    Coefficients c = Coefficients::Zero();
    for (int i = 0; i < n; ++i) {
      c[i] = b[i];
      for (int k = 0; k < i; ++k) c[i] -= lower_(i, k) * c[k];
    }
    for (int i = n - 1; i >= 0; --i) {
      c[i] /= lower_(i, i);
      for (int k = i + 1; k < n; ++k) c[i] -= lower_(k, i) * c[k];
    }
    return c;
  }

 private:
  // Column j of L and d_j, from the columns before it.
  void eliminate(int j) {
    for (int k = 0; k < j; ++k) {
      const double ld = lower_(j, k) * lower_(k, k);
      for (int i = j; i < Basis::size; ++i) lower_(i, j) -= ld * lower_(i, k);
    }
    for (int i = j + 1; i < Basis::size; ++i) lower_(i, j) /= lower_(j, j);
  }

  // Lower triangle: first M, then D on and L (unit diagonal) below the diagonal.
  Eigen::Matrix<double, Basis::size, Basis::size> lower_ =
      Eigen::Matrix<double, Basis::size, Basis::size>::Zero();
  int order_ = -1;
  double condition_ = 0.0;
};

}  // namespace porowave::solver
