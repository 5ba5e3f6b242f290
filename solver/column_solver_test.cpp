#include "solver/column_solver.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstring>
#include <numeric>

#include "reference/problem/errors.hpp"
#include "reference/problem/problem_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(column_solver)

using namespace porowave;
using namespace porowave::solver;

namespace {

Case papers_case(const Load& load, int elements = 60) {
  Case scene;
  scene.problem = fixtures::paper_problem(load);
  scene.discretization.elements = elements;
  scene.time.end = 4e-5;
  return scene;
}

double total(const std::vector<double>& weights, const std::vector<double>& values) {
  return std::inner_product(weights.begin(), weights.end(), values.begin(), 0.0);
}

/// Momentum of both phases at the points, per unit area.
double momentum(const Snapshot& s, const Material& m) {
  return m.solid_partial_density() * total(s.solid.volume, s.solid.velocity) +
         m.fluid_partial_density() * total(s.fluid.volume, s.fluid.velocity);
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_impulse_of_the_load_becomes_momentum) {
  // Until the far end is reached nothing else acts from outside. Drag and pressure are internal.
  for (const TransferName transfer : {TransferName::shape, TransferName::mls}) {
    for (const NearEnd near :
         {NearEnd::drained_traction, NearEnd::sealed_traction, NearEnd::fluid_pressure}) {
      Case scene = papers_case(Load(LoadShape::sin4_pulse, 3.0, 1e-5));
      scene.problem.column.near = near;
      scene.discretization.transfer = transfer;
      scene.discretization.kernel = kernel_name<BSpline1>;
      scene.discretization.support_radius = 1.0;
      scene.time.end = 2.5e-5;
      ColumnSolver solver(scene);
      BOOST_REQUIRE(!solver.run());
      const double impulse = scene.problem.load.impulse(scene.time.end);
      BOOST_TEST(std::abs(momentum(solver.snapshot(), scene.problem.material) - impulse) <
                 1e-6 * impulse);
    }
  }
}

BOOST_AUTO_TEST_CASE(results_scale_with_the_load) {
  // Small strains: twice the load, twice the fields; the weights have not changed.
  ColumnSolver one(papers_case(Load(LoadShape::smooth_ramp, 1.0, 1e-5)));
  ColumnSolver two(papers_case(Load(LoadShape::smooth_ramp, 2.0, 1e-5)));
  one.run();
  two.run();
  const Snapshot a = one.snapshot();
  const Snapshot b = two.snapshot();
  for (std::size_t p = 0; p < a.solid.x.size(); ++p) {
    BOOST_TEST(std::abs(b.solid.stress[p] - 2.0 * a.solid.stress[p]) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(the_same_case_gives_the_same_bits) {
  Case scene = papers_case(Load(LoadShape::step, 1.0));
  scene.discretization.placement = Placement::random;
  ColumnSolver first(scene);
  ColumnSolver second(scene);
  first.run();
  second.run();
  BOOST_TEST(same_bits(first.snapshot().solid.stress, second.snapshot().solid.stress));
  BOOST_TEST(same_bits(first.snapshot().fluid.velocity, second.snapshot().fluid.velocity));
}

BOOST_AUTO_TEST_CASE(looking_at_a_run_does_not_change_it) {
  const Case scene = papers_case(Load(LoadShape::step, 1.0));
  ColumnSolver watched(scene);
  ColumnSolver alone(scene);
  for (int i = 0; i < 40; ++i) {
    watched.step();
    BOOST_TEST(watched.snapshot().time == watched.time());
    alone.step();
  }
  BOOST_TEST(same_bits(watched.snapshot().solid.stress, alone.snapshot().solid.stress));
  BOOST_TEST(same_bits(watched.snapshot().solid.velocity, alone.snapshot().solid.velocity));
}

BOOST_AUTO_TEST_CASE(a_run_ends_exactly_at_its_end_within_the_courant_number) {
  for (const double courant : {0.13, 0.5, 1.0}) {
    Case scene = papers_case(Load(LoadShape::step, 1.0));
    scene.time.courant = courant;
    ColumnSolver solver(scene);
    const double h = 0.1 / 60;
    const double limit = courant * h / wave_speeds(scene.problem.material).p1;
    BOOST_TEST(solver.time_step() <= limit * (1.0 + 1e-12));
    BOOST_TEST(solver.time_step() * static_cast<double>(solver.planned_steps()) == scene.time.end,
               boost::test_tools::tolerance(1e-14));
    BOOST_TEST(static_cast<double>(solver.planned_steps() - 1) * limit < scene.time.end);
  }
}

BOOST_AUTO_TEST_CASE(points_that_move_get_new_weights_without_a_jump) {
  // A load that moves points by several thousandths of h: still small strains, so the fields stay
  // those of the scaled small load, to the size of the strain.
  const double large = 2.5e6;
  ColumnSolver still(papers_case(Load(LoadShape::smooth_ramp, 1.0, 1e-5)));
  ColumnSolver moving(papers_case(Load(LoadShape::smooth_ramp, large, 1e-5)));
  still.run();
  moving.run();
  const Snapshot a = still.snapshot();
  const Snapshot b = moving.snapshot();
  double moved = 0.0;
  double difference = 0.0;
  for (std::size_t p = 0; p < a.solid.x.size(); ++p) {
    moved = std::max(moved, std::abs(b.solid.x[p] - a.solid.x[p]));
    difference = std::max(difference, std::abs(b.solid.stress[p] / large - a.solid.stress[p]));
  }
  const double h = 0.1 / 60;
  BOOST_TEST(moved > 2 * reweight_share * h);
  BOOST_TEST(difference < 0.02);
}

BOOST_AUTO_TEST_CASE(pic_damps_what_flip_keeps) {
  Case scene = papers_case(Load(LoadShape::sin4_pulse, 1.0, 5e-6));
  const auto kinetic = [&](double flip) {
    scene.time.flip = flip;
    ColumnSolver solver(scene);
    solver.run();
    const Snapshot s = solver.snapshot();
    double sum = 0.0;
    for (std::size_t p = 0; p < s.solid.x.size(); ++p) {
      sum += s.solid.volume[p] * s.solid.velocity[p] * s.solid.velocity[p];
    }
    return sum;
  };
  BOOST_TEST(kinetic(0.9) < kinetic(1.0));
  BOOST_TEST(kinetic(0.0) < 0.8 * kinetic(1.0));
}

BOOST_AUTO_TEST_CASE(drag_never_limits_the_time_step) {
  // θ Δt from 1e-4 to 1e9. The stiffest limit is one wave: both phases move together.
  for (const double permeability : {1e-8, 1e-11, 1e-14, 1e-17, 1e-20}) {
    Case scene = papers_case(Load(LoadShape::smooth_ramp, 1.0, 1e-5));
    scene.problem.material.intrinsic_permeability = permeability;
    scene.time.end = 2e-4;
    ColumnSolver solver(scene);
    BOOST_TEST(!solver.run());
    const Snapshot s = solver.snapshot();
    double relative = 0.0;
    for (std::size_t i = 0; i < s.node_x.size(); ++i) {
      relative = std::max(relative, std::abs(s.fluid_velocity[i] - s.solid_velocity[i]));
    }
    for (const double stress : s.effective_stress) BOOST_TEST(std::abs(stress) < 3.0);
    if (permeability < 1e-16) BOOST_TEST(relative < 1e-3 * scene.problem.velocity_scale());
  }
}

BOOST_AUTO_TEST_CASE(a_half_space_sends_nothing_back) {
  // The same points in a column that is long enough: the fields near the load are the same.
  Case open = papers_case(Load(LoadShape::sin4_pulse, 1.0, 5e-6), 105);
  open.problem.column = {std::nullopt, NearEnd::drained_traction, FarEnd::half_space};
  const double reach = wave_speeds(open.problem.material).p1 * open.time.end;
  BOOST_TEST(ColumnSolver::grid_length(open) > reach);
  Case closed = open;
  closed.problem.column = {2.0 * ColumnSolver::grid_length(open), NearEnd::drained_traction,
                           FarEnd::rigid_sealed};
  closed.discretization.elements = 210;
  ColumnSolver a(open);
  ColumnSolver b(closed);
  a.run();
  b.run();
  const Snapshot short_grid = a.snapshot();
  const Snapshot long_grid = b.snapshot();
  for (std::size_t c = 0; c < 90; ++c) {
    BOOST_TEST(std::abs(short_grid.effective_stress[c] - long_grid.effective_stress[c]) < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(nothing_moves_without_a_load) {
  Case scene = papers_case(Load(1.0, {3e-5, 5e-5}, {0.0, 1.0}));
  scene.time.end = 2.9e-5;
  ColumnSolver solver(scene);
  solver.run();
  const Snapshot s = solver.snapshot();
  BOOST_TEST(total(s.solid.volume, s.solid.velocity) == 0.0);
  BOOST_TEST(s.solid.x[7] == ColumnSolver(scene).snapshot().solid.x[7]);
}

BOOST_AUTO_TEST_CASE(a_loaded_end_without_points_is_refused) {
  Case scene = papers_case(Load(LoadShape::step, 1.0));
  scene.discretization.kernel = kernel_name<BSpline1>;
  scene.discretization.support_radius = 1.0;
  scene.discretization.empty_elements = {0.0};
  BOOST_CHECK_THROW(ColumnSolver solver(scene), BreakdownError);
}

BOOST_AUTO_TEST_SUITE_END()
