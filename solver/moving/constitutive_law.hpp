#pragma once

// Elastic laws of a bar in uniaxial strain: the deformation gradient is diag(F, 1, 1), so J = F and
// the stretch of the bar is its only strain. The axial component of the first Piola-Kirchhoff
// stress, J σ F⁻¹, is then the axial Cauchy stress itself: one number serves for both.
//
//   LinearElastic   σ = E_oed (F − 1), small strains
//   NeoHookean      σ = (μ/J)(F² − 1) + (λ/J) ln J, J = F      (Bonet & Wood 2008, eq. 6.29:
//                   σ = (μ/J)(b − I) + (λ/J)(ln J) I, compressible neo-Hookean, axial component)
//
// Both have E_oed = λ + 2μ at F = 1. Tension positive; Pa; F > 0 dimensionless. Nothing is thrown:
// the law of a stretch that is not positive is NaN or infinite (BarSolver stops there).

#include <cmath>
#include <variant>

namespace porowave::solver {

struct LinearElastic {
  double constrained_modulus;  // E_oed, Pa

  double stress(double stretch) const { return constrained_modulus * (stretch - 1.0); }
  double stress_slope(double /*stretch*/) const { return constrained_modulus; }
};

struct NeoHookean {
  double shear_modulus;  // μ, Pa
  double lame_modulus;   // λ, Pa

  double stress(double stretch) const {
    return (shear_modulus * (stretch * stretch - 1.0) + lame_modulus * std::log(stretch)) / stretch;
  }
  // ∂σ/∂F
  double stress_slope(double stretch) const {
    const double square = stretch * stretch;
    return shear_modulus * (1.0 + 1.0 / square) + lame_modulus * (1.0 - std::log(stretch)) / square;
  }
};

using ConstitutiveLaw = std::variant<LinearElastic, NeoHookean>;

inline double stress(const ConstitutiveLaw& law, double stretch) {
  return std::visit([&](const auto& of) { return of.stress(stretch); }, law);
}

inline double stress_slope(const ConstitutiveLaw& law, double stretch) {
  return std::visit([&](const auto& of) { return of.stress_slope(stretch); }, law);
}

// Speed of a small wave in the deformed bar as seen on the fixed grid, m/s: F sqrt((∂σ/∂F)/ρ_0),
// with ρ_0 in kg/m³ of the undeformed bar.
inline double wave_speed(const ConstitutiveLaw& law, double stretch, double density) {
  return stretch * std::sqrt(stress_slope(law, stretch) / density);
}

}  // namespace porowave::solver
