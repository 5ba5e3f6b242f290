#pragma once

// A bar in uniaxial finite strain: the problem that BarSolver solves.
//
//   ρ Dv/Dt = ∂σ/∂x + b,   DF/Dt = F ∂v/∂x,   σ = σ(F),   ρ = ρ_0/F        on near(t) < x < far(t)
//
// F is the stretch (deformation gradient) of the material with respect to its stress-free state. SI
// units; stress positive in tension.

#include <functional>

#include "solver/moving/constitutive_law.hpp"

namespace porowave::solver {

// What acts on an end. Without anything the end is free of stress.
struct BarEnd {
  bool held = false;                       // v = 0; the end must lie on a node of the grid
  std::function<double(double t)> stress;  // σ at the end, Pa, wherever it has moved
};

struct Bar {
  double near = 0.0;  // m, ends at t = 0
  double far = 0.0;
  double density = 0.0;  // ρ_0, kg/m³ of the stress-free material
  ConstitutiveLaw law;
  BarEnd near_end;
  BarEnd far_end;
  // b, N/m³ of the deformed bar, at place x (m) and time t (s); absent: none.
  std::function<double(double x, double t)> body_force;
  // At t = 0: F at place x; absent: 1.
  std::function<double(double x)> initial_stretch;
  // Velocity, m/s, at time t of the point that is at x at t = 0; asked for half a step before
  // t = 0. Absent: at rest.
  std::function<double(double x, double t)> initial_velocity;
};

}  // namespace porowave::solver
