#pragma once

#include <string>

#include "reference/problem/column.hpp"
#include "reference/problem/load.hpp"
#include "reference/problem/material.hpp"

namespace porowave {

class TomlDocument;

/// The statement of the problem, shared by solver and reference and by nothing else of theirs.
///
///   n_s rho_s Dv_s/Dt = d(sigma')/dx - n_s dp/dx - f_d      f_d = -n_f^2 (mu/kappa)(v_f - v_s)
///   n_f rho_f Dv_f/Dt =              - n_f dp/dx + f_d
///   dp/dt = -(K_f/n_f)(n_s dv_s/dx + n_f dv_f/dx)           d(sigma')/dt = E_oed dv_s/dx
///
/// (Chmelnizkij 2023, eqs. 2-4, porosity uniform, no body force; at rest for t < 0.)
/// Signs: stress positive in tension, pore pressure positive in compression, q > 0 compresses.
struct Problem {
  Material material;
  Column column;
  Load load;

  /// The size by which errors of stress and pressure are judged, Pa: the largest |q|; for
  /// near = "velocity", q times impedance.
  double stress_scale() const;
  /// The size by which errors of velocity are judged, m/s: stress_scale over the impedance
  /// rho c of the mixture at its undrained speed.
  double velocity_scale() const;
};

/// The four fields at a point and time. Pa, Pa, m/s, m/s.
struct Fields {
  double effective_stress = 0.0;
  double pore_pressure = 0.0;
  double solid_velocity = 0.0;
  double fluid_velocity = 0.0;
};

/// Reads [material], [column] and [load] and leaves other tables to others.
Problem read_problem(const TomlDocument& document);
/// Reads a problem file. The tables of a case or study may follow; others are refused.
Problem load_problem(const std::string& path);

}  // namespace porowave
