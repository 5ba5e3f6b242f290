#include "solver/nodal_update.hpp"

#include <algorithm>
#include <cmath>

namespace porowave::solver {

namespace {

// (1 − e^−z)/z for z >= 0
double phi_1(double z) {
  return z > 1e-8 ? -std::expm1(-z) / z : 1.0 - 0.5 * z;
}

// Both phases free, or only one there.
void move_free_node(double drag, double dt, std::size_t i, PhaseNodes& s, PhaseNodes& f) {
  const double ms = s.mass[i];
  const double mf = f.mass[i];
  if (ms > 0.0 && mf > 0.0) {
    const Drag over_step = drag_over(drag, dt, s, f, i);
    const double mean = (ms * s.velocity[i] + mf * f.velocity[i]) / (ms + mf);
    const double new_mean = mean + dt * (s.force[i] + f.force[i]) / (ms + mf);
    const double relative = f.velocity[i] - s.velocity[i];
    const double driving = f.force[i] / mf - s.force[i] / ms;
    const double new_relative = relative * over_step.decay + driving * over_step.effective_time;
    s.new_velocity[i] = new_mean - mf / (ms + mf) * new_relative;
    f.new_velocity[i] = new_mean + ms / (ms + mf) * new_relative;
  } else if (ms > 0.0) {
    s.new_velocity[i] = s.velocity[i] + dt * s.force[i] / ms;
    f.velocity[i] = s.velocity[i];
    f.new_velocity[i] = s.new_velocity[i];
  } else if (mf > 0.0) {
    f.new_velocity[i] = f.velocity[i] + dt * f.force[i] / mf;
    s.velocity[i] = f.velocity[i];
    s.new_velocity[i] = f.new_velocity[i];
  } else {
    s.new_velocity[i] = f.new_velocity[i] = 0.0;
  }
}

void prescribe(std::size_t i, double before, double after, PhaseNodes& s, PhaseNodes& f) {
  s.velocity[i] = f.velocity[i] = before;
  s.new_velocity[i] = f.new_velocity[i] = after;
}

// v_s = v_f: one body.
void move_tied_node(double dt, std::size_t i, PhaseNodes& s, PhaseNodes& f) {
  const double mass = s.mass[i] + f.mass[i];
  if (mass == 0.0) return prescribe(i, 0.0, 0.0, s, f);
  const double common = (s.mass[i] * s.velocity[i] + f.mass[i] * f.velocity[i]) / mass;
  const double moved = common + dt * (s.force[i] + f.force[i]) / mass;
  s.velocity[i] = f.velocity[i] = common;
  s.new_velocity[i] = f.new_velocity[i] = moved;
}

// Solid held, fluid free to leave: drag against a body at rest.
void move_drained_wall(double drag, double dt, std::size_t i, PhaseNodes& s, PhaseNodes& f) {
  if (f.mass[i] == 0.0) return prescribe(i, 0.0, 0.0, s, f);
  s.velocity[i] = s.new_velocity[i] = 0.0;
  const double theta = s.mass[i] > 0.0 ? drag * f.volume[i] / f.mass[i] : 0.0;
  f.new_velocity[i] =
      f.velocity[i] * std::exp(-theta * dt) + dt * f.force[i] / f.mass[i] * phi_1(theta * dt);
}

void move_near_end(const Problem& problem, const StepLoad& load, double dt, PhaseNodes& s,
                   PhaseNodes& f) {
  const double drag = problem.material.drag();
  switch (problem.column.near) {
    case NearEnd::drained_traction:
      s.force[0] += load.mean;
      move_free_node(drag, dt, 0, s, f);
      break;
    case NearEnd::fluid_pressure:  // p acts on both phases by their share of the area
      s.force[0] += problem.material.solid_fraction() * load.mean;
      f.force[0] += problem.material.porosity * load.mean;
      move_free_node(drag, dt, 0, s, f);
      break;
    case NearEnd::sealed_traction:
      s.force[0] += load.mean;
      move_tied_node(dt, 0, s, f);
      break;
    case NearEnd::velocity:
      prescribe(0, load.before, load.after, s, f);
      break;
  }
}

void move_far_end(const Problem& problem, double dt, PhaseNodes& s, PhaseNodes& f) {
  const double drag = problem.material.drag();
  const std::size_t last = s.mass.size() - 1;
  switch (problem.column.far) {
    case FarEnd::rigid_sealed:
    case FarEnd::half_space:  // the grid ends where no wave arrives in time
      prescribe(last, 0.0, 0.0, s, f);
      break;
    case FarEnd::rigid_drained:
      move_drained_wall(drag, dt, last, s, f);
      break;
    case FarEnd::free_drained:
      move_free_node(drag, dt, last, s, f);
      break;
  }
}

}  // namespace

void PhaseNodes::resize(std::size_t nodes) {
  for (auto* values : {&mass, &volume, &velocity, &force, &new_velocity}) values->resize(nodes);
}

Drag drag_over(double drag, double dt, const PhaseNodes& s, const PhaseNodes& f, std::size_t i) {
  const double theta =
      drag * std::min(s.volume[i], f.volume[i]) * (1.0 / s.mass[i] + 1.0 / f.mass[i]);
  return {std::exp(-theta * dt), dt * phi_1(theta * dt)};
}

void update_node(const Problem& problem, const StepLoad& load, double dt, std::size_t i,
                 PhaseNodes& solid, PhaseNodes& fluid) {
  if (i == 0) {
    move_near_end(problem, load, dt, solid, fluid);
  } else if (i + 1 == solid.mass.size()) {
    move_far_end(problem, dt, solid, fluid);
  } else {
    move_free_node(problem.material.drag(), dt, i, solid, fluid);
  }
}

void update_nodes(const Problem& problem, const StepLoad& load, double dt, PhaseNodes& solid,
                  PhaseNodes& fluid) {
  for (std::size_t i = 0; i < solid.mass.size(); ++i) {
    update_node(problem, load, dt, i, solid, fluid);
  }
}

}  // namespace porowave::solver
