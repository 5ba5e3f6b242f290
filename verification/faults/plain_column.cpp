#include "verification/faults/plain_column.hpp"

#include <algorithm>
#include <cmath>

namespace porowave::verification::faults {

using solver::Case;
using solver::Grid;
using solver::PhaseNodes;
using solver::PointSet;
using solver::Vector;

namespace {

struct PlainPhase {
  PlainPhase(PointSet<1> placed, const Grid<1>& grid, const solver::Discretization& choice)
      : points(std::move(placed)),
        transfer(points, grid, choice),
        velocity(points.x.size()),
        stress(points.x.size()) {
    nodes.resize(static_cast<std::size_t>(grid.node_count()));
    nodes.mass = transfer.nodal_mass();
    nodes.volume = transfer.nodal_volume();
  }

  PointSet<1> points;
  solver::Transfer<1> transfer;
  Values velocity;
  Values stress;
  PhaseNodes nodes;
};

PointSet<1> point_set(const solver::Discretization& choice, double spacing, solver::Phase phase,
                      double density) {
  const solver::PlacedPoints placed = solver::place_points(choice, spacing, phase);
  std::vector<std::size_t> order(placed.x.size());
  for (std::size_t p = 0; p < order.size(); ++p) order[p] = p;
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return placed.x[a] < placed.x[b]; });
  PointSet<1> points;
  for (const std::size_t p : order) {
    points.x.emplace_back(placed.x[p]);
    points.volume.push_back(placed.volume[p]);
    points.mass.push_back(density * placed.volume[p]);
  }
  return points;
}

class PlainColumn {
 public:
  PlainColumn(const Case& scene, const ColumnParts& parts)
      : scene_(believed(scene, parts)),
        parts_(parts),
        material_(scene_.problem.material),
        grid_{Vector<1>(0.0),
              solver::ColumnSolver::grid_length(scene_) / scene_.discretization.elements,
              solver::CellIndex<1>(scene_.discretization.elements)},
        placed_(placed_points()),
        solid_(placed_.solid, grid_, scene_.discretization),
        fluid_(placed_.fluid, grid_, scene_.discretization) {
    parts_.masses(solid_.nodes, fluid_.nodes);
    const double stable = scene.time.courant * grid_.spacing / wave_speeds(material_).p1;
    steps_ = std::lround(std::ceil(scene.time.end / stable * (1.0 - 1e-12)));
    dt_ = scene.time.end / static_cast<double>(steps_);
  }

  std::optional<solver::Breakdown> run() {
    const double limit = 1e6 * scene_.problem.stress_scale();
    for (long n = 0; n < steps_ + parts_.extra_steps; ++n) {
      step(n);
      const auto bad = [&](double s) { return !(std::abs(s) < limit); };
      if (std::any_of(solid_.stress.begin(), solid_.stress.end(), bad) ||
          std::any_of(fluid_.stress.begin(), fluid_.stress.end(), bad)) {
        return solver::Breakdown{n + 1, "a stress has grown beyond 1e6 times the load"};
      }
    }
    return std::nullopt;
  }

  /// The case's own end is the time of the snapshot, whatever the solver believes.
  solver::Snapshot snapshot(double end) {
    const double t = static_cast<double>(steps_) * dt_;
    const double forward = parts_.synchronised * dt_;
    gather();
    parts_.nodal_update(scene_.problem, parts_.load(scene_.problem.load, t - 0.5 * dt_, t), forward,
                        solid_.nodes, fluid_.nodes);
    solver::Snapshot result;
    result.time = end;
    for (PlainPhase* phase : {&solid_, &fluid_}) {
      move(*phase, 1.0);
      solver::PhasePoints& points = phase == &solid_ ? result.solid : result.fluid;
      for (const Vector<1>& x : phase->points.x) points.x.push_back(x[0]);
      points.volume = phase->points.volume;
      points.velocity = phase->velocity;
      points.stress = phase->stress;
    }
    result.effective_stress = solid_.transfer.at_cell_centres(solid_.stress);
    result.pore_pressure = fluid_.transfer.at_cell_centres(fluid_.stress);
    result.solid_velocity = solid_.nodes.new_velocity;
    result.fluid_velocity = fluid_.nodes.new_velocity;
    for (int c = 0; c < grid_.cell_count(); ++c) result.cell_x.push_back(grid_.cell_centre(c)[0]);
    for (int i = 0; i < grid_.node_count(); ++i) result.node_x.push_back(grid_.node_position(i)[0]);
    return result;
  }

  long steps() const { return steps_; }
  double time_step() const { return dt_; }
  std::size_t points() const { return solid_.points.x.size() + fluid_.points.x.size(); }

 private:
  static Case believed(Case scene, const ColumnParts& parts) {
    parts.scene(scene);
    return scene;
  }

  PlacedPhases placed_points() const {
    PlacedPhases placed{point_set(scene_.discretization, grid_.spacing, solver::Phase::solid,
                                  material_.solid_partial_density()),
                        point_set(scene_.discretization, grid_.spacing, solver::Phase::fluid,
                                  material_.fluid_partial_density())};
    parts_.points(placed);
    return placed;
  }

  Values stress_force(const PlainPhase& phase) const {
    Values at_quadrature;
    phase.transfer.to_quadrature(phase.stress, at_quadrature);
    parts_.quadrature(at_quadrature);
    Values force(phase.nodes.mass.size());
    phase.transfer.add_divergence(at_quadrature, -1.0, 0, force);
    return force;
  }

  void gather() {
    for (PlainPhase* phase : {&solid_, &fluid_}) {
      phase->transfer.to_nodes(phase->velocity, phase->nodes.velocity);
      parts_.nodal_velocity(phase->nodes.velocity);
    }
    parts_.forces(material_, stress_force(solid_), stress_force(fluid_), solid_.nodes,
                  fluid_.nodes);
  }

  /// v_p ← flip v_p + Σ N_i (v_i' − flip v_i)
  static void move(PlainPhase& phase, double flip) {
    Values change = phase.nodes.new_velocity;
    for (std::size_t i = 0; i < change.size(); ++i) change[i] -= flip * phase.nodes.velocity[i];
    Values at_points(phase.velocity.size());
    phase.transfer.to_points(change, at_points);
    for (std::size_t p = 0; p < at_points.size(); ++p) {
      phase.velocity[p] = flip * phase.velocity[p] + at_points[p];
    }
  }

  void strain() {
    const Values& vs = parts_.strain_velocity(solid_.nodes);
    const Values& vf = parts_.strain_velocity(fluid_.nodes);
    StrainRates rates{Values(solid_.stress.size()), Values(fluid_.stress.size()),
                      Values(fluid_.stress.size())};
    solid_.transfer.gradient_at_points(vs, 0, rates.solid);
    fluid_.transfer.gradient_at_points(vs, 0, rates.solid_at_fluid);
    fluid_.transfer.gradient_at_points(vf, 0, rates.fluid);
    parts_.strain_rates(rates);
    for (std::size_t p = 0; p < solid_.stress.size(); ++p) {
      solid_.stress[p] += dt_ * parts_.stress_rate(material_, rates.solid[p]);
    }
    for (std::size_t p = 0; p < fluid_.stress.size(); ++p) {
      fluid_.stress[p] +=
          dt_ * parts_.pressure_rate(material_, rates.solid_at_fluid[p], rates.fluid[p]);
    }
  }

  void step(long n) {
    const double t = static_cast<double>(n) * dt_;
    gather();
    parts_.nodal_update(scene_.problem,
                        parts_.load(scene_.problem.load, t - 0.5 * dt_, t + 0.5 * dt_), dt_,
                        solid_.nodes, fluid_.nodes);
    const double flip = parts_.flip(scene_.time.flip);
    move(solid_, flip);
    move(fluid_, flip);
    strain();
  }

  Case scene_;
  const ColumnParts& parts_;
  const Material& material_;
  Grid<1> grid_;
  PlacedPhases placed_;
  PlainPhase solid_;
  PlainPhase fluid_;
  long steps_ = 0;
  double dt_ = 0.0;
};

}  // namespace

/// f_s = −∫ ∂N (σ′ − n_s p), f_f = −∫ ∂N (−n_f p)
void ColumnParts::right_forces(const Material& m, const Values& effective, const Values& pressure,
                               PhaseNodes& solid, PhaseNodes& fluid) {
  for (std::size_t i = 0; i < effective.size(); ++i) {
    solid.force[i] = effective[i] - m.solid_fraction() * pressure[i];
    fluid.force[i] = -m.porosity * pressure[i];
  }
}

RunResult run_plain(const Case& scene, const reference::Profile& profile,
                    const ColumnParts& parts) {
  PlainColumn column(scene, parts);
  RunResult result;
  result.breakdown = column.run();
  result.snapshot = column.snapshot(scene.time.end);
  result.steps = column.steps();
  result.time_step = column.time_step();
  result.points = column.points();
  result.reference_error = profile.error();
  if (!result.breakdown)
    result.errors = field_errors(result.snapshot, reference_values(result.snapshot, profile));
  return result;
}

}  // namespace porowave::verification::faults
