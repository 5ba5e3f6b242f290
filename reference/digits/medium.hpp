#pragma once

#include <array>

#include "reference/digits/numbers.hpp"
#include "reference/problem/problem.hpp"

namespace porowave::fixtures::digits {

/// Which of the two modes is called the fast one where they are not apart. Both kinds agree near
/// the real axis on the right.
enum class Labels {
  outer,  ///< continued from s = infinity: cuts from the branch points inwards, to s = 0
  inner,  ///< continued from s = 0: cuts from the branch points outwards
};

/// Material constants of A V'' = s (s D + d J) V and of its eigenvalues, in the numbers R.
template <class R>
struct Medium {
  R ns, nf;                  ///< volume fractions
  R solid, fluid;            ///< partial densities, D = diag(solid, fluid)
  R modulus, storage, drag;  ///< E, K, d
  std::array<R, 3> A;        ///< A11, A12 = A21, A22
  /// lambda^2/s^2 has the sum trace[0] + trace[1]/s and the product det[0] + det[1]/s.
  std::array<R, 2> trace, det;
  R gap;                   ///< 1/c2^2 - 1/c1^2
  ComplexOf<R> branch;     ///< where the modes meet, with its conjugate; Im >= 0
  R rate;                  ///< the cut is [-rate, 0]
  std::array<R, 2> speed;  ///< c1, c2
  R undrained;             ///< speed of both phases together

  explicit Medium(const Material& m) {
    using std::sqrt;
    nf = m.porosity;
    ns = 1 - nf;
    solid = ns * m.grain_density;
    fluid = nf * m.fluid_density;
    modulus = m.constrained_modulus;
    storage = R(m.fluid_bulk_modulus) / nf;
    drag = nf * nf * m.fluid_viscosity / m.intrinsic_permeability;
    A = {modulus + storage * ns * ns, storage * ns * nf, storage * nf * nf};
    const R area = modulus * storage * nf * nf;  // determinant of A
    trace = {(A[2] * solid + A[0] * fluid) / area, drag * (A[0] + 2 * A[1] + A[2]) / area};
    det = {solid * fluid / area, drag * (solid + fluid) / area};
    // The discriminant in z = 1/s: gap^2 + middle z + trace[1]^2 z^2.
    gap = sqrt(trace[0] * trace[0] - 4 * det[0]);
    const R middle = 2 * trace[0] * trace[1] - 4 * det[1];
    const R below = 4 * gap * gap * trace[1] * trace[1] - middle * middle;
    const R height = below > 0 ? R(sqrt(below)) : R(0);
    branch = ComplexOf<R>(-middle / (2 * gap * gap), height / (2 * gap * gap));
    rate = drag * (1 / solid + 1 / fluid);
    const R slow = (trace[0] + gap) / 2;
    speed = {sqrt(slow / det[0]), 1 / sqrt(slow)};
    undrained = sqrt((modulus + storage) / (solid + fluid));
  }

  /// Rounds the constants of a wider type.
  template <class Wide>
  explicit Medium(const Medium<Wide>& m) {
    const auto to = [](const Wide& w) { return static_cast<R>(w); };
    ns = to(m.ns), nf = to(m.nf), solid = to(m.solid), fluid = to(m.fluid);
    modulus = to(m.modulus), storage = to(m.storage), drag = to(m.drag);
    A = {to(m.A[0]), to(m.A[1]), to(m.A[2])};
    trace = {to(m.trace[0]), to(m.trace[1])};
    det = {to(m.det[0]), to(m.det[1])};
    gap = to(m.gap), rate = to(m.rate), undrained = to(m.undrained);
    branch = ComplexOf<R>(to(m.branch.real()), to(m.branch.imag()));
    speed = {to(m.speed[0]), to(m.speed[1])};
  }

  /// lambda_k/s, the slowness of both modes; its real part is positive off the cut.
  template <class C>
  std::array<C, 2> slowness(const C& s, Labels labels) const {
    using std::conj;
    using std::sqrt;
    const C z = R(1) / s;
    const C other(branch.real(), -branch.imag());
    const C root = labels == Labels::outer
                       ? C(gap * sqrt(C(R(1) - branch * z)) * sqrt(C(R(1) - other * z)))
                       : C(trace[1] * z * sqrt(C(R(1) - s / branch)) * sqrt(C(R(1) - s / other)));
    const C slow = (trace[0] + trace[1] * z + root) / R(2);
    return {sqrt(C((det[0] + det[1] * z) / slow)), sqrt(slow)};
  }
};

}  // namespace porowave::fixtures::digits
