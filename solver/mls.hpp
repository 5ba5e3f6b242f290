#pragma once

// Moving least squares: the shape values of scattered points at one evaluation point x,
//
//   Φ_p(x) = w(x_p − x) p(ξ_p)ᵀ M⁻¹(x) p(0),   M(x) = Σ_p w(x_p − x) p(ξ_p) p(ξ_p)ᵀ,
//   ξ_p = (x_p − x) / R,
//
// p the complete polynomial basis of total degree Order, R the support radius. With values u_p at
// the points, u(x) = Σ_p Φ_p(x) u_p is the weighted least-squares polynomial through them, read at
// x. It reproduces every polynomial of total degree <= order_used; in particular Σ_p Φ_p = 1.
//
// Φ_p may be negative from order 1 on, near a boundary of the points also by a lot:
// Σ_p |Φ_p| <= sqrt(Σ_p w_p (M⁻¹)_00), which is sqrt(condition) for the linear basis in one
// dimension.
//
// Sources: Lancaster & Salkauskas (1981), doi:10.1090/S0025-5718-1981-0616367-1; as the transfer of
// an MPM: Sulsky & Gong (2016), doi:10.1007/978-3-319-39022-2_10.

#include <cstddef>
#include <span>

#include "solver/kernel.hpp"
#include "solver/moment_matrix.hpp"

namespace porowave::solver {

// A degree is accepted while the condition (see moment_matrix.hpp) is below this. In one dimension
// 1e4 bounds the linear basis by Σ_p |Φ_p| < 100 and loses at most four digits. Measured in 1D over
// all kernels and degrees 1 to 3, regular, stratified and random points, one to four per cell, up
// to 20001 nodes: Σ_p |Φ_p| < 310 where the full degree is accepted. Regular points, two or more
// per cell, keep every degree up to the ends of a column; only wendland_c6 at degree 3 and two per
// cell would need 4.5e4.
inline constexpr double default_max_condition = 1e4;

// The status of one evaluation; always set, nothing is thrown.
struct MlsResult {
  int order_used = -1;  // degree of the basis; below Order where the points cannot carry it;
                        // -1 if no point has positive weight, then every Φ_p and ∇Φ_p is zero
  double condition = 0.0;  // of the moment matrix at order_used, >= 1; 0 if order_used is -1
};

template <class Kernel, int Dim, int Order>
class MovingLeastSquares {
 public:
  // support_radius > 0, in the unit of the coordinates; max_condition > 1.
  explicit MovingLeastSquares(double support_radius, double max_condition = default_max_condition)
      : support_radius_(support_radius), max_condition_(max_condition) {}

  // Φ_p(x) of every point; zero outside the support. phi must be as long as points; coordinates
  // must be finite. Does not allocate.
  MlsResult evaluate(const Vector<Dim>& x, std::span<const Vector<Dim>> points,
                     std::span<double> phi) const {
    Moments moments;
    for (std::size_t p = 0; p < points.size(); ++p) {
      phi[p] = weight_value<Kernel, Dim>(points[p] - x, support_radius_);
      if (phi[p] > 0.0) moments.add(phi[p], basis(points[p], x));
    }
    moments.factorise(max_condition_);
    if (moments.order() < 0) return {};

    const Coefficients c = moments.solve(Coefficients::Unit(0));
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (phi[p] > 0.0) phi[p] *= basis(points[p], x).dot(c);
    }
    return {moments.order(), moments.condition()};
  }

  // The same, and ∇Φ_p(x), the full derivative in x at the order used (Φ_p jumps where that
  // changes). In 1/(unit of the coordinates). gradients must be as long as points.
  MlsResult evaluate(const Vector<Dim>& x, std::span<const Vector<Dim>> points,
                     std::span<double> phi, std::span<Vector<Dim>> gradients) const {
    Moments moments;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const auto w = weight<Kernel, Dim>(points[p] - x, support_radius_);
      phi[p] = w.value;
      gradients[p] = -w.gradient;  // ∇_x w
      if (w.value > 0.0) moments.add(w.value, basis(points[p], x));
    }
    moments.factorise(max_condition_);
    if (moments.order() < 0) return {};

    const Coefficients c = moments.solve(Coefficients::Unit(0));
    const Slopes dc = coefficient_slopes(moments, c, x, points, gradients);
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (!(phi[p] > 0.0)) continue;
      const Coefficients b = basis(points[p], x);
      gradients[p] = gradients[p] * b.dot(c) + phi[p] * (dc.transpose() * b);
      phi[p] *= b.dot(c);
    }
    return {moments.order(), moments.condition()};
  }

 private:
  using Moments = MomentMatrix<Dim, Order>;
  using Basis = PolynomialBasis<Dim, Order>;
  using Coefficients = typename Basis::Values;
  using Slopes = Eigen::Matrix<double, Basis::size, Dim>;

  Coefficients basis(const Vector<Dim>& point, const Vector<Dim>& x) const {
    return Basis::at((point - x) * (1.0 / support_radius_));
  }

  // ∂c/∂x of c = M⁻¹ p(0), column a: M⁻¹ (∂p/∂x_a − ∂M/∂x_a c).
  // Φ_p does not depend on where the complete basis is centred, so the centre can stay at this x
  // while the evaluation point moves: only p(0) (∂/∂x_a = 1/R in monomial 1 + a) and w move.
  Slopes coefficient_slopes(const Moments& moments, const Coefficients& c, const Vector<Dim>& x,
                            std::span<const Vector<Dim>> points,
                            std::span<const Vector<Dim>> weight_gradients) const {
    Slopes rhs = Slopes::Zero();
    if constexpr (Order >= 1)
      rhs.template block<Dim, Dim>(1, 0).diagonal().array() = 1.0 / support_radius_;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const Coefficients b = basis(points[p], x);
      rhs -= b * b.dot(c) * weight_gradients[p].transpose();
    }
    Slopes dc;
    for (int a = 0; a < Dim; ++a) dc.col(a) = moments.solve(rhs.col(a));
    return dc;
  }

  double support_radius_;
  double max_condition_;
};

}  // namespace porowave::solver
