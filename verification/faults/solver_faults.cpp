// Wrong solvers. Each is run through a part of the study pull_request and judged by its baseline.

#include <algorithm>

#include "verification/faults/fault.hpp"
#include "verification/faults/plain_column.hpp"
#include "verification/faults/study_slice.hpp"

namespace porowave::verification::faults {

using solver::PhaseNodes;
using solver::StepLoad;

namespace {

/// A solver with some of its pieces exchanged.
Fault in_solver(const std::string& what, const std::string& named,
                const std::function<void(ColumnParts&)>& exchange,
                Until until = Until::first_passage) {
  ColumnParts parts;
  exchange(parts);
  return {"solver", what, named, [parts, until] {
            return caught_by_study(
                [&](const solver::Case& scene, const reference::Profile& exact) {
                  return run_plain(scene, exact, parts);
                },
                until);
          }};
}

/// A solver that believes in another material.
Fault with_material(const std::string& what, const std::function<void(Material&)>& change,
                    const std::string& named = "fail") {
  return in_solver(what, named, [change](ColumnParts& parts) {
    parts.scene = [change](solver::Case& scene) { change(scene.problem.material); };
  });
}

/// A nodal update that believes in another problem.
auto updated_as(const std::function<void(Problem&)>& change) {
  return [change](const Problem& problem, const StepLoad& load, double dt, PhaseNodes& solid,
                  PhaseNodes& fluid) {
    Problem other = problem;
    change(other);
    solver::update_nodes(other, load, dt, solid, fluid);
  };
}

void momentum_faults(std::vector<Fault>& all) {
  const auto drag = [](double factor) {
    return [factor](ColumnParts& parts) {
      parts.nodal_update =
          updated_as([factor](Problem& p) { p.material.intrinsic_permeability /= factor; });
    };
  };
  all.push_back(in_solver("drag has the wrong sign", "fail", drag(-1.0)));
  all.push_back(in_solver("drag is left out", "fail", drag(1e-9)));
  all.push_back(in_solver("drag acts twice", "fail", drag(2.0)));
  all.push_back(in_solver("drag with n_f instead of n_f²", "fail", drag(1.0 / 0.4)));
  all.push_back(in_solver("drag acts on the fluid only", "fail", [](ColumnParts& parts) {
    parts.nodal_update = [](const Problem& problem, const StepLoad& load, double dt, PhaseNodes& s,
                            PhaseNodes& f) {
      Problem free = problem;
      free.material.intrinsic_permeability *= 1e9;
      PhaseNodes solid_alone = s;
      PhaseNodes fluid_alone = f;
      solver::update_nodes(free, load, dt, solid_alone, fluid_alone);
      solver::update_nodes(problem, load, dt, s, f);
      s.new_velocity = solid_alone.new_velocity;
    };
  }));
  all.push_back(in_solver("pressure force missing on the solid", "fail", [](ColumnParts& parts) {
    parts.forces = [](const Material& m, const Values& effective, const Values& pressure,
                      PhaseNodes& solid, PhaseNodes& fluid) {
      ColumnParts::right_forces(m, effective, pressure, solid, fluid);
      solid.force = effective;
    };
  }));
  all.push_back(in_solver(
      "porosity and its complement exchanged in the forces", "fail", [](ColumnParts& parts) {
        parts.forces = [](const Material& m, const Values& effective, const Values& pressure,
                          PhaseNodes& solid, PhaseNodes& fluid) {
          Material other = m;
          other.porosity = m.solid_fraction();
          ColumnParts::right_forces(other, effective, pressure, solid, fluid);
        };
      }));
  all.push_back(in_solver("mass of the boundary node halved", "fail", [](ColumnParts& parts) {
    parts.masses = [](PhaseNodes& s, PhaseNodes& f) {
      s.mass.front() *= 0.5;
      f.mass.front() *= 0.5;
    };
  }));
  all.push_back(in_solver("mass of the boundary node doubled", "fail", [](ColumnParts& parts) {
    parts.masses = [](PhaseNodes& s, PhaseNodes& f) {
      s.mass.front() *= 2.0;
      f.mass.front() *= 2.0;
    };
  }));
}

void end_faults(std::vector<Fault>& all) {
  all.push_back(in_solver("the load comes one step late", "fail", [](ColumnParts& parts) {
    parts.load = [](const Load& load, double t0, double t1) {
      const double late = t1 - t0;
      return StepLoad{load.mean(t0 - late, t1 - late), load.value(t0 - late), load.value(t0)};
    };
  }));
  all.push_back(in_solver("the load of the beginning of a step", "fail", [](ColumnParts& parts) {
    parts.load = [](const Load& load, double t0, double t1) {
      return StepLoad{load.value(t0), load.value(t0), load.value(t1)};
    };
  }));
  all.push_back(in_solver("the load pulls", "fail", [](ColumnParts& parts) {
    parts.load = [](const Load& load, double t0, double t1) {
      return StepLoad{-load.mean(t0, t1), -load.value(t0), -load.value(t1)};
    };
  }));
  const auto ends = [](NearEnd near) {
    return [near](ColumnParts& parts) {
      parts.nodal_update = updated_as([near](Problem& p) { p.column.near = near; });
    };
  };
  all.push_back(
      in_solver("the loaded end is sealed, not drained", "fail", ends(NearEnd::sealed_traction)));
  all.push_back(
      in_solver("the fluid carries its share of the load", "fail", ends(NearEnd::fluid_pressure)));
  all.push_back(in_solver(
      "the far end is free, not held", "fail",
      [](ColumnParts& parts) {
        parts.nodal_update = updated_as([](Problem& p) { p.column.far = FarEnd::free_drained; });
      },
      Until::return_of_the_wave));
}

void transfer_faults(std::vector<Fault>& all) {
  const auto scaled = [](double factor) {
    return [factor](Values& values) {
      for (double& v : values) v *= factor;
    };
  };
  all.push_back(in_solver("kernel not normalised: velocities at the nodes 1 % too large", "fail",
                          [&](ColumnParts& p) { p.nodal_velocity = scaled(1.01); }));
  all.push_back(in_solver("kernel not normalised: stresses at the cells 1 % too small", "fail",
                          [&](ColumnParts& p) { p.quadrature = scaled(0.99); }));
  all.push_back(in_solver("the stress of the cell to the left", "fail", [](ColumnParts& parts) {
    parts.quadrature = [](Values& s) { std::rotate(s.begin(), s.end() - 1, s.end()); };
  }));
  all.push_back(in_solver(
      "derivative of a wider shape function", "fail: effective_stress", [](ColumnParts& parts) {
        parts.strain_rates = [](StrainRates& rates) {
          for (Values* rate : {&rates.solid, &rates.solid_at_fluid, &rates.fluid}) {
            const Values narrow = *rate;
            for (std::size_t p = 4; p + 4 < narrow.size(); ++p) {
              (*rate)[p] = 0.25 * narrow[p - 4] + 0.5 * narrow[p] + 0.25 * narrow[p + 4];
            }
          }
        };
      }));
  all.push_back(in_solver("PIC where FLIP is asked for", "fail",
                          [](ColumnParts& parts) { parts.flip = [](double) { return 0.0; }; }));
  all.push_back(in_solver("1 % of PIC in every step", "fail", [](ColumnParts& parts) {
    parts.flip = [](double flip) { return 0.99 * flip; };
  }));
  all.push_back(in_solver("points moved by half a cell", "fail", [](ColumnParts& parts) {
    parts.points = [](PlacedPhases& placed) {
      const double shift = placed.solid.x.back()[0] / static_cast<double>(placed.solid.x.size());
      for (solver::PointSet<1>* points : {&placed.solid, &placed.fluid}) {
        for (std::size_t p = 0; p + 4 < points->x.size(); ++p) points->x[p][0] += 2.0 * shift;
      }
    };
  }));
}

void constitutive_faults(std::vector<Fault>& all) {
  all.push_back(with_material("Young's modulus instead of the constrained one (Poisson 0.3)",
                              [](Material& m) { m.constrained_modulus *= 0.743; }));
  all.push_back(with_material("density of the grains instead of the partial one",
                              [](Material& m) { m.grain_density /= m.solid_fraction(); }));
  all.push_back(
      with_material("viscosity 1 % too large", [](Material& m) { m.fluid_viscosity *= 1.01; }));
  all.push_back(
      in_solver("pressure stiffness K_f instead of K_f/n_f", "fail", [](ColumnParts& parts) {
        parts.pressure_rate = [](const Material& m, double solid, double fluid) {
          return -m.fluid_bulk_modulus * (m.solid_fraction() * solid + m.porosity * fluid);
        };
      }));
  all.push_back(in_solver(
      "porosity and its complement exchanged in the mass balance", "fail", [](ColumnParts& parts) {
        parts.pressure_rate = [](const Material& m, double solid, double fluid) {
          return -m.storage_modulus() * (m.porosity * solid + m.solid_fraction() * fluid);
        };
      }));
  all.push_back(in_solver("the solid does not squeeze the pores", "fail", [](ColumnParts& parts) {
    parts.pressure_rate = [](const Material& m, double, double fluid) {
      return -m.storage_modulus() * m.porosity * fluid;
    };
  }));
  all.push_back(in_solver("pore pressure has the wrong sign", "fail", [](ColumnParts& parts) {
    parts.pressure_rate = [](const Material& m, double solid, double fluid) {
      return m.storage_modulus() * (m.solid_fraction() * solid + m.porosity * fluid);
    };
  }));
}

void time_faults(std::vector<Fault>& all) {
  all.push_back(
      in_solver("stress a step late: strain of the old velocity", "fail", [](ColumnParts& parts) {
        parts.strain_velocity = [](const PhaseNodes& nodes) -> const Values& {
          return nodes.velocity;
        };
      }));
  all.push_back(in_solver("velocities put out half a step before the stresses", "fail",
                          [](ColumnParts& parts) { parts.synchronised = 0.0; }));
  all.push_back(in_solver("one step missing at the end", "fail",
                          [](ColumnParts& parts) { parts.extra_steps = -1; }));
}

}  // namespace

std::vector<Fault> solver_faults() {
  std::vector<Fault> all;
  momentum_faults(all);
  end_faults(all);
  transfer_faults(all);
  constitutive_faults(all);
  time_faults(all);
  return all;
}

}  // namespace porowave::verification::faults
