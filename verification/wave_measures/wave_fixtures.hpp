#pragma once

#include <functional>

#include "reference/problem/problem_fixtures.hpp"
#include "verification/wave_measures/grid_fields.hpp"

/// Snapshots of known fields, for the tests of measures.
namespace porowave::verification::wave_fixtures {

using FieldsAt = std::function<Fields(double x)>;

/// Four points a cell and phase, regular.
inline solver::Snapshot snapshot_of(const FieldsAt& at, double time, int cells,
                                    double length = 0.1) {
  solver::Snapshot s;
  s.time = time;
  const double h = length / cells;
  for (int c = 0; c < cells; ++c) {
    s.cell_x.push_back(h * (c + 0.5));
    const Fields middle = at(s.cell_x.back());
    s.effective_stress.push_back(middle.effective_stress);
    s.pore_pressure.push_back(middle.pore_pressure);
    for (int p = 0; p < 4; ++p) {
      const double x = h * (c + (p + 0.5) / 4);
      const Fields f = at(x);
      s.solid.x.push_back(x);
      s.solid.volume.push_back(h / 4);
      s.solid.stress.push_back(f.effective_stress);
      s.solid.velocity.push_back(f.solid_velocity);
      s.fluid.x.push_back(x);
      s.fluid.volume.push_back(h / 4);
      s.fluid.stress.push_back(f.pore_pressure);
      s.fluid.velocity.push_back(f.fluid_velocity);
    }
  }
  for (int i = 0; i <= cells; ++i) {
    s.node_x.push_back(h * i);
    s.solid_velocity.push_back(at(s.node_x.back()).solid_velocity);
    s.fluid_velocity.push_back(at(s.node_x.back()).fluid_velocity);
  }
  return s;
}

/// What a reference with these fields would be at the places of snapshot_of.
inline ReferenceValues values_of(const FieldsAt& at, int cells, double length = 0.1) {
  const solver::Snapshot s = snapshot_of(at, 0.0, cells, length);
  return {{s.solid.stress, s.fluid.stress, s.solid.velocity, s.fluid.velocity},
          {s.effective_stress, s.pore_pressure, s.solid_velocity, s.fluid_velocity}};
}

/// The paper's column with another permeability (m^2): 1e-2 is as good as no drag.
inline Problem column(const Load& load, double permeability = 1e-11) {
  Problem problem = fixtures::paper_problem(load);
  problem.material.intrinsic_permeability = permeability;
  return problem;
}

inline Fields scaled(const Fields& f, double by) {
  return {by * f.effective_stress, by * f.pore_pressure, by * f.solid_velocity,
          by * f.fluid_velocity};
}

inline Fields sum(const Fields& a, const Fields& b) {
  return {a.effective_stress + b.effective_stress, a.pore_pressure + b.pore_pressure,
          a.solid_velocity + b.solid_velocity, a.fluid_velocity + b.fluid_velocity};
}

}  // namespace porowave::verification::wave_fixtures
