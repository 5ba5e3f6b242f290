#include "solver/stability/staggered_step.hpp"

#include <cmath>

#include "solver/staggered/staggered_solver.hpp"

namespace porowave::solver {

namespace {

// Whose grid is that of the case, whatever its end.
Case without_load(Case scene) {
  scene.problem.column.length = ColumnSolver::grid_length(scene);
  scene.problem.load = Load(LoadShape::step, 0.0);
  return scene;
}

}  // namespace

StaggeredStep::StaggeredStep(const Case& scene)
    : scene_(without_load(scene)),
      cells_(static_cast<std::size_t>(scene.discretization.elements)),
      spacing_(ColumnSolver::grid_length(scene_) / scene.discretization.elements) {
  const Material& m = scene.problem.material;
  scale_.assign(cells_ + 1, 1.0 / std::sqrt(m.solid_partial_density()));
  scale_.insert(scale_.end(), cells_ + 1, 1.0 / std::sqrt(m.fluid_partial_density()));
  scale_.insert(scale_.end(), cells_, std::sqrt(m.constrained_modulus));
  scale_.insert(scale_.end(), cells_, std::sqrt(m.storage_modulus()));
  if (scene.time.order != 4) return;
  // Rates of forces as the shortest waves have them.
  const double rate = wave_speeds(m).p1 / spacing_;
  for (const double density : {m.solid_partial_density(), m.fluid_partial_density()}) {
    scale_.insert(scale_.end(), cells_ + 1, rate * rate * std::sqrt(density));
  }
}

std::vector<double> StaggeredStep::physical(std::span<const double> state) const {
  std::vector<double> values(state.begin(), state.end());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] *= scale_[i];
  return values;
}

LinearMap StaggeredStep::at(double time_step) const {
  Case one_step = scene_;
  one_step.time.end = time_step;
  one_step.time.courant = 1.001 * time_step * wave_speeds(scene_.problem.material).p1 / spacing_;
  auto self = std::make_shared<const StaggeredStep>(*this);
  auto solver = std::make_shared<StaggeredSolver>(one_step);
  return {size(), [self, solver](std::span<const double> in, std::span<double> out) {
            solver->set_state(self->physical(in));
            solver->step();
            const std::vector<double> next = solver->state();
            for (std::size_t i = 0; i < next.size(); ++i) out[i] = next[i] / self->scale_[i];
          }};
}

CarriedFields StaggeredStep::fields(std::span<const double> state) const {
  const std::vector<double> values = physical(state);
  const auto part = [&](std::size_t first, std::size_t count) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
    return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(count));
  };
  CarriedFields fields;
  fields.solid_velocity = part(0, cells_ + 1);
  fields.fluid_velocity = part(cells_ + 1, cells_ + 1);
  fields.effective_stress = part(2 * cells_ + 2, cells_);
  fields.pore_pressure = part(3 * cells_ + 2, cells_);
  for (std::size_t i = 0; i <= cells_; ++i) {
    fields.node_x.push_back(spacing_ * static_cast<double>(i));
    if (i < cells_) fields.cell_x.push_back(spacing_ * (static_cast<double>(i) + 0.5));
  }
  return fields;
}

}  // namespace porowave::solver
