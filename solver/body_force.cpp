#include "solver/body_force.hpp"

namespace porowave::solver {

void add_body_force(const BodyForce& force, double t, double share, const Material& material,
                    const Grid<1>& grid, const FilledVolumes& volumes, IndexRange nodes,
                    double* effective, double* pressure) {
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const std::size_t i = nodes.first + k;
    const PhaseForces b = force(grid.node_position(static_cast<int>(i))[0], t);
    const double as_pressure = share * b.fluid * volumes.fluid[i] / material.porosity;
    effective[k] += share * b.solid * volumes.solid[i] - material.solid_fraction() * as_pressure;
    pressure[k] -= as_pressure;
  }
}

}  // namespace porowave::solver
