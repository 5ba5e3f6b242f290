#include "solver/stability/galerkin_step.hpp"

#include <algorithm>
#include <cmath>

namespace porowave::solver {

namespace {

using Eigen::Map;
using Eigen::VectorXd;

Case visiting_points(Case scene) {
  scene.time.path = StepPath::points;
  return scene;
}

// The one index of every `period` that is `k` modulo it, next to `row`.
std::ptrdiff_t probed_near(std::size_t row, std::size_t k, std::size_t period) {
  const auto away = static_cast<std::ptrdiff_t>((k + period - row % period) % period);
  const auto p = static_cast<std::ptrdiff_t>(period);
  return static_cast<std::ptrdiff_t>(row) + (2 * away > p ? away - p : away);
}

}  // namespace

struct GalerkinStep::Scratch {
  PreparedUpdate update;
  PhaseNodes solid, fluid;
  VectorXd solid_velocity, fluid_velocity, effective_stress, pore_pressure;  // the state
  VectorXd effective_force, pressure_force;
};

GalerkinStep::GalerkinStep(const Case& scene)
    : scene_(scene),
      cells_(static_cast<std::size_t>(scene.discretization.elements)),
      spacing_(ColumnSolver::grid_length(scene) / scene.discretization.elements),
      offset_{cells_ + 1, 2 * cells_ + 2, 3 * cells_ + 2} {
  const ColumnSolver solver(visiting_points(scene));
  const bool affine = scene.discretization.transfer == TransferName::apic;
  const ColumnOperators& of_solid = solver.operators(Phase::solid);
  const ColumnOperators& of_fluid = solver.operators(Phase::fluid);
  solid_ = probe(of_solid, cells_, affine);
  fluid_ = &of_solid == &of_fluid ? solid_ : probe(of_fluid, cells_, affine);
  solid_nodes_ = solver.nodes(Phase::solid);
  fluid_nodes_ = solver.nodes(Phase::fluid);
  const Material& m = scene.problem.material;
  scale_ = {1.0 / std::sqrt(m.solid_partial_density()), 1.0 / std::sqrt(m.fluid_partial_density()),
            spacing_ * std::sqrt(m.constrained_modulus), spacing_ * std::sqrt(m.storage_modulus())};
}

// Nodes (and cells) farther apart than a step reaches are probed together.
GalerkinStep::PhaseRows GalerkinStep::probe(const ColumnOperators& operators, std::size_t cells,
                                            bool affine) {
  const std::size_t nodes = cells + 1;
  const std::size_t period = std::min(2 * operators.reach() + 4, nodes);
  const std::size_t points = operators.points_of({0, cells}).last;
  const std::vector<double> none(nodes, 0.0);
  std::vector<double> peaks(nodes), stairs(nodes), velocity(nodes), force(nodes);
  std::vector<Eigen::Triplet<double>> of_velocity, of_force;
  for (std::size_t k = 0; k < period; ++k) {
    for (std::size_t i = 0; i < nodes; ++i) {
      peaks[i] = i % period == k ? 1.0 : 0.0;
      stairs[i] = i == 0 ? 0.0 : stairs[i - 1] + peaks[i - 1];
    }
    PointValues values{std::vector<double>(points), std::vector<double>(points), {}};
    if (affine) values.velocity_gradient.assign(points, 0.0);
    operators.scatter({0.0, none.data(), peaks.data(), stairs.data(), 1.0}, {0, cells}, values);
    operators.gather(values, {0, nodes}, velocity.data(), force.data());
    for (std::size_t row = 0; row < nodes; ++row) {
      const auto column =
          period == nodes ? static_cast<std::ptrdiff_t>(k) : probed_near(row, k, period);
      if (column < 0) continue;
      const auto enter = [&](double value, std::size_t columns, auto& entries) {
        if (value == 0.0 || column >= static_cast<std::ptrdiff_t>(columns)) return;
        entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
      };
      enter(velocity[row], nodes, of_velocity);
      enter(force[row], cells, of_force);
    }
  }
  const auto rows = static_cast<Eigen::Index>(nodes);
  PhaseRows found{Rows(rows, rows), Rows(rows, static_cast<Eigen::Index>(cells))};
  found.velocity.setFromTriplets(of_velocity.begin(), of_velocity.end());
  found.force.setFromTriplets(of_force.begin(), of_force.end());
  return found;
}

void GalerkinStep::update_velocities(const Rows& rows, const std::vector<double>& before,
                                     const std::vector<double>& after, VectorXd& q) const {
  const Map<const VectorXd> v(before.data(), q.size());
  const Map<const VectorXd> v_new(after.data(), q.size());
  if (scene_.time.xpic_order == 0) {
    q = scene_.time.flip * (q - v) + v_new;
    return;
  }
  VectorXd noise = q - v;
  for (int k = 1; k < scene_.time.xpic_order; ++k) noise -= VectorXd(rows * noise);
  q += v_new - v - noise;
}

void GalerkinStep::step(std::span<const double> in, const StepLoad& load, Scratch& at,
                        std::span<double> out) const {
  const auto nodes = static_cast<Eigen::Index>(cells_ + 1);
  const auto cells = static_cast<Eigen::Index>(cells_);
  const auto part = [&](std::size_t offset, Eigen::Index length) {
    return Map<const VectorXd>(in.data() + offset, length);
  };
  at.solid_velocity = scale_.solid_velocity * part(0, nodes);
  at.fluid_velocity = scale_.fluid_velocity * part(offset_.fluid_velocity, nodes);
  at.effective_stress = scale_.effective_stress * part(offset_.effective_stress, cells);
  at.pore_pressure = scale_.pore_pressure * part(offset_.pore_pressure, cells);

  Map<VectorXd>(at.solid.velocity.data(), nodes) = solid_.velocity * at.solid_velocity;
  Map<VectorXd>(at.fluid.velocity.data(), nodes) = fluid_.velocity * at.fluid_velocity;
  at.effective_force = solid_.force * at.effective_stress;
  at.pressure_force = fluid_.force * at.pore_pressure;
  at.update.apply(scene_.problem, load, {0, cells_ + 1},
                  {at.effective_force.data(), at.pressure_force.data()}, at.solid, at.fluid);
  update_velocities(solid_.velocity, at.solid.velocity, at.solid.new_velocity, at.solid_velocity);
  update_velocities(fluid_.velocity, at.fluid.velocity, at.fluid.new_velocity, at.fluid_velocity);

  const Material& m = scene_.problem.material;
  const double dt = at.update.time_step();
  const auto rise = [&](const std::vector<double>& v) {
    const Map<const VectorXd> values(v.data(), nodes);
    return (values.tail(cells) - values.head(cells)).eval();
  };
  const VectorXd solid_rise = rise(at.solid.new_velocity);
  const VectorXd mixture_rise =
      m.solid_fraction() * solid_rise + m.porosity * rise(at.fluid.new_velocity);
  at.effective_stress += dt * m.constrained_modulus * solid_rise;
  at.pore_pressure -= dt * m.storage_modulus() * mixture_rise;

  const auto store = [&](const VectorXd& values, std::size_t offset, double scale) {
    Map<VectorXd>(out.data() + offset, values.size()) = values / scale;
  };
  store(at.solid_velocity, 0, scale_.solid_velocity);
  store(at.fluid_velocity, offset_.fluid_velocity, scale_.fluid_velocity);
  store(at.effective_stress, offset_.effective_stress, scale_.effective_stress);
  store(at.pore_pressure, offset_.pore_pressure, scale_.pore_pressure);
}

std::function<void(std::span<const double>, const StepLoad&, std::span<double>)>
GalerkinStep::loaded(double time_step) const {
  auto self = std::make_shared<const GalerkinStep>(*this);
  auto scratch = std::make_shared<Scratch>();
  scratch->solid = solid_nodes_;
  scratch->fluid = fluid_nodes_;
  scratch->update = PreparedUpdate(scene_.problem, time_step, solid_nodes_, fluid_nodes_);
  return [self, scratch](std::span<const double> in, const StepLoad& load, std::span<double> out) {
    self->step(in, load, *scratch, out);
  };
}

LinearMap GalerkinStep::at(double time_step) const {
  return {size(), [step = loaded(time_step)](std::span<const double> in, std::span<double> out) {
            step(in, {0.0, 0.0, 0.0}, out);
          }};
}

CarriedFields GalerkinStep::fields(std::span<const double> state) const {
  CarriedFields fields;
  for (std::size_t i = 0; i <= cells_; ++i) {
    fields.node_x.push_back(spacing_ * static_cast<double>(i));
    fields.solid_velocity.push_back(scale_.solid_velocity * state[i]);
    fields.fluid_velocity.push_back(scale_.fluid_velocity * state[offset_.fluid_velocity + i]);
  }
  for (std::size_t c = 0; c < cells_; ++c) {
    fields.cell_x.push_back(spacing_ * (static_cast<double>(c) + 0.5));
    fields.effective_stress.push_back(scale_.effective_stress / spacing_ *
                                      state[offset_.effective_stress + c]);
    fields.pore_pressure.push_back(scale_.pore_pressure / spacing_ *
                                   state[offset_.pore_pressure + c]);
  }
  return fields;
}

}  // namespace porowave::solver
