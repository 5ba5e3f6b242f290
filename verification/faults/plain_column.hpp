#pragma once

// The coupled column written out step by step, from the same transfer, placement and nodal update
// as solver/column_solver.hpp, with every piece in the open: tests replace one of them by a wrong
// one and see whether the harness notices. With the pieces as they are it gives what ColumnSolver
// gives, to rounding (plain_column_test.cpp). Points stay where they are, which the loads of the
// studies allow.

#include <functional>
#include <vector>

#include "reference/profile.hpp"
#include "solver/nodal_update.hpp"
#include "solver/placement.hpp"
#include "solver/transfer.hpp"
#include "verification/run.hpp"

namespace porowave::verification::faults {

using Values = std::vector<double>;

/// Rates of strain, 1/s: of the solid at its points, of both phases at the fluid's points.
struct StrainRates {
  Values solid;
  Values solid_at_fluid;
  Values fluid;
};

/// Both phases' points while they are placed.
struct PlacedPhases {
  solver::PointSet<1> solid;
  solver::PointSet<1> fluid;
};

/// The pieces of a step. Each is called with what the right one has made, or makes it itself.
struct ColumnParts {
  /// What the solver takes the case for.
  std::function<void(solver::Case&)> scene = [](solver::Case&) {};
  std::function<void(PlacedPhases&)> points = [](PlacedPhases&) {};
  std::function<void(solver::PhaseNodes& solid, solver::PhaseNodes& fluid)> masses =
      [](solver::PhaseNodes&, solver::PhaseNodes&) {};
  /// The load between two times, s.
  std::function<solver::StepLoad(const Load&, double before, double after)> load =
      [](const Load& q, double before, double after) {
        return solver::StepLoad{q.mean(before, after), q.value(before), q.value(after)};
      };
  /// Nodal velocities gathered from points, m/s.
  std::function<void(Values&)> nodal_velocity = [](Values&) {};
  /// Stresses at the quadrature points, Pa.
  std::function<void(Values&)> quadrature = [](Values&) {};
  /// −∫ ∂N_i s dx of the two stresses to the forces of the phases, N.
  std::function<void(const Material&, const Values& effective, const Values& pressure,
                     solver::PhaseNodes& solid, solver::PhaseNodes& fluid)>
      forces = right_forces;
  std::function<void(const Problem&, const solver::StepLoad&, double dt, solver::PhaseNodes& solid,
                     solver::PhaseNodes& fluid)>
      nodal_update = solver::update_nodes;
  /// Share of its own velocity that a point keeps.
  std::function<double(double flip)> flip = [](double asked) { return asked; };
  /// The nodal velocity whose gradient is the rate of strain.
  std::function<const Values&(const solver::PhaseNodes&)> strain_velocity =
      [](const solver::PhaseNodes& nodes) -> const Values& { return nodes.new_velocity; };
  std::function<void(StrainRates&)> strain_rates = [](StrainRates&) {};
  /// Rates of stress at the solid's points and of pressure at the fluid's, Pa/s.
  std::function<double(const Material&, double solid)> stress_rate =
      [](const Material& m, double solid) { return m.constrained_modulus * solid; };
  std::function<double(const Material&, double solid, double fluid)> pressure_rate =
      [](const Material& m, double solid, double fluid) {
        return -m.storage_modulus() * (m.solid_fraction() * solid + m.porosity * fluid);
      };
  /// By how many steps velocities are brought forward to the time of the stresses.
  double synchronised = 0.5;
  /// Steps made less those planned.
  long extra_steps = 0;

  static void right_forces(const Material&, const Values& effective, const Values& pressure,
                           solver::PhaseNodes& solid, solver::PhaseNodes& fluid);
};

/// Runs the case with these pieces and measures it against the profile, as run_case does.
RunResult run_plain(const solver::Case& scene, const reference::Profile& profile,
                    const ColumnParts& parts = {});

}  // namespace porowave::verification::faults
