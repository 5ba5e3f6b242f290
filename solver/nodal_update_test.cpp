#include "solver/nodal_update.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "reference/problem/problem_fixtures.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(nodal_update)

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr StepLoad no_load{0.0, 0.0, 0.0};

// One phase at one node.
struct At {
  double mass;
  double velocity;
  double force;
};

// A problem with the drag coefficient d in N s/m^4.
Problem problem_with_drag(double drag, NearEnd near = NearEnd::drained_traction,
                          FarEnd far = FarEnd::rigid_sealed) {
  Problem problem = fixtures::paper_problem();
  Material& m = problem.material;
  m.intrinsic_permeability = m.porosity * m.porosity * m.fluid_viscosity / drag;
  problem.column.near = near;
  problem.column.far = far;
  return problem;
}

// Three nodes, all alike; new velocities are NaN so that a node left out is seen.
PhaseNodes three(const At& at, double volume) {
  return {std::vector<double>(3, at.mass), std::vector<double>(3, at.mass > 0.0 ? volume : 0.0),
          std::vector<double>(3, at.velocity), std::vector<double>(3, at.force),
          std::vector<double>(3, nan)};
}

struct Nodes {
  PhaseNodes solid;
  PhaseNodes fluid;

  Nodes(const At& s, const At& f, double volume = 1.0)
      : solid(three(s, volume)), fluid(three(f, volume)) {}

  void update(const Problem& problem, double dt, const StepLoad& load = no_load) {
    update_nodes(problem, load, dt, solid, fluid);
  }
  double relative(std::size_t i) const { return fluid.new_velocity[i] - solid.new_velocity[i]; }
  double momentum(std::size_t i) const {
    return solid.mass[i] * solid.new_velocity[i] + fluid.mass[i] * fluid.new_velocity[i];
  }
  // What the points get.
  double solid_increment(std::size_t i) const { return solid.new_velocity[i] - solid.velocity[i]; }
  double fluid_increment(std::size_t i) const { return fluid.new_velocity[i] - fluid.velocity[i]; }
};

void check_near(double actual, double expected, double relative = 1e-13) {
  BOOST_TEST(std::abs(actual - expected) <= relative * std::abs(expected),
             actual << " is not " << expected);
}

const std::vector<double> many_scales = [] {
  std::vector<double> z;
  for (int exponent = -12; exponent <= 12; ++exponent) {
    for (const double factor : {1.0, 3.0}) z.push_back(factor * std::pow(10.0, exponent));
  }
  return z;
}();

BOOST_AUTO_TEST_CASE(without_drag_each_phase_obeys_newton) {
  const Problem free = problem_with_drag(0.0);
  for (const double dt : {1e-9, 1e-3, 2.0}) {
    Nodes nodes({2.0, 0.5, 3.0}, {0.7, -1.5, -4.0});
    nodes.update(free, dt);
    check_near(nodes.solid.new_velocity[1], 0.5 + dt * 3.0 / 2.0);
    check_near(nodes.fluid.new_velocity[1], -1.5 - dt * 4.0 / 0.7);
  }
}

BOOST_AUTO_TEST_CASE(drag_never_changes_the_momentum) {
  const double dt = 0.01;
  for (const double z : many_scales) {
    Nodes nodes({2.0, 0.5, 3.0}, {0.7, -1.5, -4.0});
    const double before = 2.0 * 0.5 - 0.7 * 1.5;
    nodes.update(problem_with_drag(z), dt);
    BOOST_TEST(std::abs(nodes.momentum(1) - (before - dt * 1.0)) < 1e-14);
  }
}

// w = v_f − v_s obeys dw/dt = −θ w, θ = d V (1/m_s + 1/m_f).
BOOST_AUTO_TEST_CASE(the_relative_velocity_decays_exponentially) {
  const double dt = 1e-3;
  const double volume = 0.25;
  for (const double z : many_scales) {
    // equal masses: the mean velocity is exactly zero, so that w keeps its digits
    const double drag = z / dt / volume / (1.0 / 2.0 + 1.0 / 2.0);
    Nodes nodes({2.0, -0.5, 0.0}, {2.0, 0.5, 0.0}, volume);
    nodes.update(problem_with_drag(drag), dt);
    const double expected = std::exp(-z);
    BOOST_TEST(nodes.relative(1) >= 0.0);
    BOOST_TEST(nodes.relative(1) <= 1.0);
    BOOST_TEST(std::abs(nodes.relative(1) - expected) < 1e-15 + 1e-13 * (1.0 + z) * expected);
    check_near(nodes.fluid.new_velocity[1], -nodes.solid.new_velocity[1]);
  }
  for (const double z : many_scales) {
    const double drag = z / dt / volume / (1.0 / 3.0 + 1.0 / 0.5);
    Nodes nodes({3.0, 1.0, 0.0}, {0.5, -1.0, 0.0}, volume);
    nodes.update(problem_with_drag(drag), dt);
    BOOST_TEST(std::abs(nodes.relative(1) + 2.0 * std::exp(-z)) < 1e-14);
  }
}

// ... and with forces dw/dt = g − θ w, whose solution is w e^−z + g dt (1 − e^−z)/z.
BOOST_AUTO_TEST_CASE(forces_and_drag_together_are_integrated_exactly) {
  const double dt = 1e-3;
  for (const double z : many_scales) {
    const double ms = 2.0;
    const double mf = 0.5;
    const double drag = z / dt / (1.0 / ms + 1.0 / mf);
    // momentum and total force are zero, so that w keeps its digits
    Nodes nodes({ms, -0.25, -6.0}, {mf, 1.0, 6.0});
    nodes.update(problem_with_drag(drag), dt);
    const long double g = 6.0L / mf + 6.0L / ms;
    const long double expected = 1.25L * std::exp(-static_cast<long double>(z)) -
                                 g * dt * std::expm1(-static_cast<long double>(z)) / z;
    check_near(nodes.relative(1), static_cast<double>(expected), 2e-13 * (1.0 + std::min(z, 40.0)));
  }
}

BOOST_AUTO_TEST_CASE(a_steady_force_leads_to_darcys_law) {
  // 6 N drive the fluid against the solid: in the end drag balances them, w = 6/(d V).
  const double drag = 300.0;
  const double volume = 0.1;
  const Problem problem = problem_with_drag(drag);
  const double limit = 6.0 / (drag * volume);
  Nodes one_large_step({2.0, 0.0, -6.0}, {0.5, 0.0, 6.0}, volume);
  one_large_step.update(problem, 10.0);
  check_near(one_large_step.relative(1), limit, 1e-12);

  Nodes many({2.0, 0.0, -6.0}, {0.5, 0.0, 6.0}, volume);
  double last = 0.0;
  for (int step = 0; step < 2000; ++step) {
    many.update(problem, 1e-3);
    BOOST_TEST_REQUIRE(many.relative(1) >= last * (1.0 - 1e-12));  // monotone
    last = many.relative(1);
    many.solid.velocity = many.solid.new_velocity;
    many.fluid.velocity = many.fluid.new_velocity;
  }
  check_near(last, limit, 1e-10);
}

// The exact solution is a semigroup: two half steps are one step.
BOOST_AUTO_TEST_CASE(two_half_steps_are_one_step) {
  const double dt = 0.02;
  for (const NearEnd near :
       {NearEnd::drained_traction, NearEnd::sealed_traction, NearEnd::fluid_pressure}) {
    for (const FarEnd far : {FarEnd::rigid_drained, FarEnd::free_drained}) {
      for (const double drag : {0.0, 1e-6, 1.0, 30.0, 1e3, 1e9}) {
        const Problem problem = problem_with_drag(drag, near, far);
        const StepLoad load{1.5, 0.0, 0.0};
        Nodes one({2.0, 0.5, 3.0}, {0.7, -1.5, -4.0});
        Nodes two = one;
        one.update(problem, dt, load);
        for (int half = 0; half < 2; ++half) {
          two.solid.force.assign(3, 3.0);  // constant, what the load added is taken off
          two.fluid.force.assign(3, -4.0);
          two.update(problem, 0.5 * dt, load);
          two.solid.velocity = two.solid.new_velocity;
          two.fluid.velocity = two.fluid.new_velocity;
        }
        for (std::size_t i = 0; i < 3; ++i) {
          BOOST_TEST(std::abs(one.solid.new_velocity[i] - two.solid.new_velocity[i]) < 1e-14);
          BOOST_TEST(std::abs(one.fluid.new_velocity[i] - two.fluid.new_velocity[i]) < 1e-14);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(small_drag_tends_to_none) {
  const double dt = 0.5;
  Nodes free({2.0, 0.5, 3.0}, {0.7, -1.5, -4.0});
  free.update(problem_with_drag(0.0), dt);
  for (const double drag : {1e-4, 1e-8, 1e-12, 1e-300}) {
    Nodes slow({2.0, 0.5, 3.0}, {0.7, -1.5, -4.0});
    slow.update(problem_with_drag(drag), dt);
    BOOST_TEST(std::abs(slow.relative(1) - free.relative(1)) <= 10.0 * drag + 1e-14);
  }
}

// Where the two volumes differ, drag acts where both phases are.
BOOST_AUTO_TEST_CASE(drag_acts_on_the_volume_that_both_phases_fill) {
  const double dt = 0.1;
  for (const bool solid_is_less : {true, false}) {
    Nodes nodes({1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}, 0.5);
    (solid_is_less ? nodes.solid : nodes.fluid).volume.assign(3, 0.2);
    nodes.update(problem_with_drag(10.0), dt);
    check_near(nodes.relative(1), 2.0 * std::exp(-10.0 * 0.2 * 2.0 * dt));
  }
}

BOOST_AUTO_TEST_CASE(a_node_that_one_phase_does_not_reach_moves_with_the_other) {
  const double dt = 0.1;
  const auto problem = problem_with_drag(50.0, NearEnd::drained_traction, FarEnd::free_drained);
  Nodes dry({2.0, 0.5, 3.0}, {0.0, 0.0, 0.0});
  dry.update(problem, dt);
  Nodes drowned({0.0, 0.0, 0.0}, {0.5, -1.0, 3.0});
  drowned.update(problem, dt);
  for (std::size_t i = 0; i < 3; ++i) {
    check_near(dry.solid.new_velocity[i], 0.5 + dt * 3.0 / 2.0);
    BOOST_TEST(dry.fluid.new_velocity[i] == dry.solid.new_velocity[i]);
    BOOST_TEST(dry.fluid_increment(i) == dry.solid_increment(i));
    BOOST_TEST(dry.solid.velocity[i] == 0.5);
    check_near(drowned.fluid.new_velocity[i], -1.0 + dt * 3.0 / 0.5);
    BOOST_TEST(drowned.solid.new_velocity[i] == drowned.fluid.new_velocity[i]);
    BOOST_TEST(drowned.solid_increment(i) == drowned.fluid_increment(i));
    BOOST_TEST(drowned.fluid.velocity[i] == -1.0);
  }
}

BOOST_AUTO_TEST_CASE(empty_nodes_stay_at_rest_at_every_end) {
  for (const NearEnd near :
       {NearEnd::drained_traction, NearEnd::sealed_traction, NearEnd::fluid_pressure}) {
    for (const FarEnd far :
         {FarEnd::rigid_sealed, FarEnd::rigid_drained, FarEnd::free_drained, FarEnd::half_space}) {
      Nodes nodes({0.0, 0.0, 1.0}, {0.0, 0.0, 1.0});
      nodes.update(problem_with_drag(50.0, near, far), 0.1, {1.0, 1.0, 1.0});
      for (std::size_t i = 0; i < 3; ++i) {
        BOOST_TEST_CONTEXT(name(near) << ", " << name(far) << ", node " << i) {
          BOOST_TEST(nodes.solid.new_velocity[i] == 0.0);
          BOOST_TEST(nodes.fluid.new_velocity[i] == 0.0);
          BOOST_TEST(nodes.solid_increment(i) == 0.0);
          BOOST_TEST(nodes.fluid_increment(i) == 0.0);
        }
      }
    }
  }
}

// ---- the loaded end -----------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(a_drained_traction_pushes_the_solid) {
  const double dt = 0.1;
  const double q = 7.0;
  Nodes nodes({2.0, 0.5, 3.0}, {0.7, -1.5, -4.0});
  nodes.update(problem_with_drag(0.0), dt, {q, 99.0, 99.0});  // only the mean counts
  check_near(nodes.solid.new_velocity[0], 0.5 + dt * (3.0 + q) / 2.0);
  check_near(nodes.fluid.new_velocity[0], -1.5 - dt * 4.0 / 0.7);
  check_near(nodes.solid.new_velocity[1], 0.5 + dt * 3.0 / 2.0);  // nowhere else
  BOOST_TEST(nodes.solid.velocity[0] == 0.5);

  Nodes dragged({2.0, 0.5, 3.0}, {0.7, -1.5, -4.0});
  dragged.update(problem_with_drag(5.0), dt, {q, 99.0, 99.0});
  check_near(dragged.momentum(0), 2.0 * 0.5 - 0.7 * 1.5 + dt * (3.0 - 4.0 + q));
  check_near(dragged.relative(0) + 0.0, -2.0 * std::exp(-5.0 * (0.5 + 1.0 / 0.7) * dt) +
                                            (-4.0 / 0.7 - (3.0 + q) / 2.0) *
                                                (1.0 - std::exp(-5.0 * (0.5 + 1.0 / 0.7) * dt)) /
                                                (5.0 * (0.5 + 1.0 / 0.7)));
}

BOOST_AUTO_TEST_CASE(a_fluid_pressure_pushes_both_phases_by_their_share) {
  const double dt = 0.1;
  const double q = 7.0;
  Nodes nodes({2.0, 0.5, 3.0}, {0.7, -1.5, -4.0});
  nodes.update(problem_with_drag(0.0, NearEnd::fluid_pressure), dt, {q, 99.0, 99.0});
  check_near(nodes.solid.new_velocity[0], 0.5 + dt * (3.0 + 0.6 * q) / 2.0);
  check_near(nodes.fluid.new_velocity[0], -1.5 + dt * (-4.0 + 0.4 * q) / 0.7);
}

BOOST_AUTO_TEST_CASE(a_sealed_traction_pushes_both_phases_as_one_body) {
  const double dt = 0.1;
  const double q = 7.0;
  for (const double drag : {0.0, 1e9}) {  // which plays no part
    Nodes nodes({2.0, 0.5, 3.0}, {0.7, -1.5, -4.0});
    nodes.update(problem_with_drag(drag, NearEnd::sealed_traction), dt, {q, 99.0, 99.0});
    const double before = 2.0 * 0.5 - 0.7 * 1.5;
    BOOST_TEST(nodes.solid.new_velocity[0] == nodes.fluid.new_velocity[0]);
    check_near(nodes.momentum(0), before + dt * (3.0 - 4.0 + q));
    // both start from the common velocity: the points get the increment of the piston
    BOOST_TEST(nodes.solid.velocity[0] == nodes.fluid.velocity[0]);
    check_near(nodes.solid.velocity[0], before / 2.7);
    check_near(nodes.solid_increment(0), dt * (3.0 - 4.0 + q) / 2.7, 1e-12);
  }
  Nodes dry({2.0, 0.5, 3.0}, {0.0, 0.0, 0.0});
  dry.update(problem_with_drag(1.0, NearEnd::sealed_traction), dt, {q, 0.0, 0.0});
  check_near(dry.fluid.new_velocity[0], 0.5 + dt * (3.0 + q) / 2.0);
}

BOOST_AUTO_TEST_CASE(a_prescribed_velocity_is_that_of_both_phases_before_and_after) {
  Nodes nodes({2.0, 0.5, 3.0}, {0.7, -1.5, -4.0});
  nodes.update(problem_with_drag(5.0, NearEnd::velocity), 0.1, {99.0, 0.25, 0.75});
  for (const PhaseNodes* phase : {&nodes.solid, &nodes.fluid}) {
    BOOST_TEST(phase->velocity[0] == 0.25);
    BOOST_TEST(phase->new_velocity[0] == 0.75);
  }
  Nodes empty({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0});
  empty.update(problem_with_drag(5.0, NearEnd::velocity), 0.1, {99.0, 0.25, 0.75});
  BOOST_TEST(empty.solid.new_velocity[0] == 0.75);
  BOOST_TEST(empty.fluid.new_velocity[0] == 0.75);
}

// ---- the far end --------------------------------------------------------------------------------

BOOST_AUTO_TEST_CASE(a_rigid_sealed_end_and_the_end_of_a_half_space_stand_still) {
  for (const FarEnd far : {FarEnd::rigid_sealed, FarEnd::half_space}) {
    Nodes nodes({2.0, 0.5, 3.0}, {0.7, -1.5, -4.0});
    nodes.update(problem_with_drag(5.0, NearEnd::drained_traction, far), 0.1, {7.0, 7.0, 7.0});
    for (const PhaseNodes* phase : {&nodes.solid, &nodes.fluid}) {
      BOOST_TEST(phase->velocity[2] == 0.0);  // the points get no increment from a wall
      BOOST_TEST(phase->new_velocity[2] == 0.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_rigid_drained_end_holds_the_solid_and_drags_the_fluid) {
  const double dt = 0.1;
  const double volume = 0.3;
  for (const double drag : {0.0, 1e-9, 1.0, 20.0, 1e12}) {
    Nodes nodes({2.0, 0.5, 3.0}, {0.7, -1.5, -4.0}, volume);
    nodes.update(problem_with_drag(drag, NearEnd::drained_traction, FarEnd::rigid_drained), dt,
                 {7.0, 7.0, 7.0});
    BOOST_TEST(nodes.solid.velocity[2] == 0.0);
    BOOST_TEST(nodes.solid.new_velocity[2] == 0.0);
    BOOST_TEST(nodes.fluid.velocity[2] == -1.5);
    // against a body at rest: the limit of an infinitely heavy solid
    const double z = drag * volume / 0.7 * dt;
    const double mean_share = z > 0.0 ? -std::expm1(-z) / z : 1.0;
    check_near(nodes.fluid.new_velocity[2], -1.5 * std::exp(-z) - 4.0 / 0.7 * dt * mean_share,
               1e-12);
    Nodes heavy({1e40, 0.0, 0.0}, {0.7, -1.5, -4.0}, volume);
    heavy.update(problem_with_drag(drag), dt);
    check_near(nodes.fluid.new_velocity[2], heavy.fluid.new_velocity[1], 1e-12);
  }
  // no solid, no drag; no fluid, no motion
  const auto wall = problem_with_drag(20.0, NearEnd::drained_traction, FarEnd::rigid_drained);
  Nodes drowned({0.0, 0.0, 0.0}, {0.7, -1.5, -4.0}, volume);
  drowned.update(wall, dt);
  check_near(drowned.fluid.new_velocity[2], -1.5 - 4.0 / 0.7 * dt);
  BOOST_TEST(drowned.solid.new_velocity[2] == 0.0);
  Nodes dry({2.0, 0.5, 3.0}, {0.0, 0.0, 0.0}, volume);
  dry.update(wall, dt);
  BOOST_TEST(dry.solid.new_velocity[2] == 0.0);
  BOOST_TEST(dry.fluid.new_velocity[2] == 0.0);
  BOOST_TEST(dry.fluid_increment(2) == 0.0);
}

BOOST_AUTO_TEST_CASE(a_free_drained_end_is_a_node_like_any_other) {
  Nodes nodes({2.0, 0.5, 3.0}, {0.7, -1.5, -4.0});
  nodes.update(problem_with_drag(5.0, NearEnd::drained_traction, FarEnd::free_drained), 0.1,
               {7.0, 7.0, 7.0});
  BOOST_TEST(nodes.solid.new_velocity[2] == nodes.solid.new_velocity[1]);
  BOOST_TEST(nodes.fluid.new_velocity[2] == nodes.fluid.new_velocity[1]);
  BOOST_TEST(nodes.solid.velocity[2] == 0.5);
  BOOST_TEST(nodes.fluid.velocity[2] == -1.5);
}

// Nodes do not see each other, and every one of a long column is updated.
BOOST_AUTO_TEST_CASE(nodes_are_independent) {
  PhaseNodes solid;
  PhaseNodes fluid;
  solid.resize(50);
  fluid.resize(50);
  for (std::size_t i = 0; i < 50; ++i) {
    const auto k = static_cast<double>(i);
    solid.mass[i] = 1.0 + k;
    fluid.mass[i] = 2.0 + 0.5 * k;
    solid.volume[i] = fluid.volume[i] = 0.1;
    solid.velocity[i] = std::sin(k);
    fluid.velocity[i] = std::cos(k);
    solid.force[i] = k - 20.0;
    fluid.force[i] = 3.0 - k;
    solid.new_velocity[i] = fluid.new_velocity[i] = nan;
  }
  const auto problem = problem_with_drag(5.0, NearEnd::drained_traction, FarEnd::free_drained);
  update_nodes(problem, no_load, 0.1, solid, fluid);
  for (std::size_t i = 0; i < 50; ++i) {
    Nodes one({solid.mass[i], solid.velocity[i], solid.force[i]},
              {fluid.mass[i], fluid.velocity[i], fluid.force[i]}, 0.1);
    one.update(problem, 0.1);
    BOOST_TEST(solid.new_velocity[i] == one.solid.new_velocity[1]);
    BOOST_TEST(fluid.new_velocity[i] == one.fluid.new_velocity[1]);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
