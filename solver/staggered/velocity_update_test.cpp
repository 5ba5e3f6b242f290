#include "solver/staggered/velocity_update.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/problem/problem_fixtures.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(velocity_update)

namespace {

constexpr std::size_t nodes = 6;

struct Motion {
  std::vector<double> solid;
  std::vector<double> fluid;
  BothPhases forces;
  BothPhases increments;
};

// Any velocities and forces.
Motion start() {
  Motion m;
  m.forces.assign(nodes);
  m.increments.assign(nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    const double x = static_cast<double>(i);
    m.solid.push_back(std::sin(1.0 + x));
    m.fluid.push_back(std::cos(2.0 * x));
    m.forces.solid[i] = 1e9 * std::cos(x);
    m.forces.fluid[i] = 1e9 * std::sin(3.0 * x);
  }
  return m;
}

Problem free_problem(double permeability) {
  Problem problem = fixtures::paper_problem();
  problem.material.intrinsic_permeability = permeability;
  problem.column.far = FarEnd::free_drained;
  return problem;
}

BOOST_AUTO_TEST_CASE(free_nodes_move_as_in_the_nodal_update) {
  // One node of unit volume after the other, with forces that hold their share of the load.
  for (const double permeability : {1.0, 1e-11, 1e-14, 1e-20}) {
    const Problem problem = free_problem(permeability);
    const double dt = 1e-7;
    Motion m = start();
    const VelocityUpdate update(problem, dt);
    update.find_increments(m.forces, {0.0, 0.0, 0.0}, nodes, m.solid, m.fluid, m.increments);
    PhaseNodes s;
    PhaseNodes f;
    s.resize(nodes);
    f.resize(nodes);
    s.mass.assign(nodes, problem.material.solid_partial_density());
    f.mass.assign(nodes, problem.material.fluid_partial_density());
    s.volume.assign(nodes, 1.0);
    f.volume.assign(nodes, 1.0);
    s.velocity = m.solid;
    f.velocity = m.fluid;
    s.force = m.forces.solid;
    f.force = m.forces.fluid;
    update_nodes(problem, {0.0, 0.0, 0.0}, dt, s, f);
    for (std::size_t i = 0; i < nodes; ++i) {
      BOOST_TEST(std::abs(m.solid[i] + m.increments.solid[i] - s.new_velocity[i]) < 1e-13);
      BOOST_TEST(std::abs(m.fluid[i] + m.increments.fluid[i] - f.new_velocity[i]) < 1e-13);
    }
  }
}

BOOST_AUTO_TEST_CASE(momentum_is_that_of_the_forces_and_stiff_drag_ends_the_relative_velocity) {
  const Problem problem = free_problem(1e-20);
  Motion m = start();
  VelocityUpdate(problem, 1e-7)
      .find_increments(m.forces, {0.0, 0.0, 0.0}, nodes, m.solid, m.fluid, m.increments);
  const double rho_s = problem.material.solid_partial_density();
  const double rho_f = problem.material.fluid_partial_density();
  for (std::size_t i = 0; i < nodes; ++i) {
    const double gained = rho_s * m.increments.solid[i] + rho_f * m.increments.fluid[i];
    BOOST_TEST(std::abs(gained - 1e-7 * (m.forces.solid[i] + m.forces.fluid[i])) < 1e-9);
    const double relative = m.fluid[i] + m.increments.fluid[i] - m.solid[i] - m.increments.solid[i];
    BOOST_TEST(std::abs(relative) < 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(ends_are_prescribed) {
  Problem problem = fixtures::paper_problem();
  problem.column.near = NearEnd::velocity;
  Motion m = start();
  VelocityUpdate(problem, 1e-7)
      .find_increments(m.forces, {0.0, 0.5, 0.75}, nodes, m.solid, m.fluid, m.increments);
  for (const auto& [velocity, increment] :
       {std::pair(&m.solid, &m.increments.solid), std::pair(&m.fluid, &m.increments.fluid)}) {
    BOOST_TEST(velocity->front() == 0.5);
    BOOST_TEST(increment->front() == 0.25);
    BOOST_TEST(velocity->back() == 0.0);
    BOOST_TEST(increment->back() == 0.0);
  }
}

BOOST_AUTO_TEST_CASE(nodes_beyond_the_window_are_left_alone) {
  Motion m = start();
  m.increments.solid.assign(nodes, 7.0);
  VelocityUpdate(fixtures::paper_problem(), 1e-7)
      .find_increments(m.forces, {0.0, 0.0, 0.0}, 3, m.solid, m.fluid, m.increments);
  BOOST_TEST(m.increments.solid[2] != 7.0);
  BOOST_TEST(m.increments.solid[3] == 7.0);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
