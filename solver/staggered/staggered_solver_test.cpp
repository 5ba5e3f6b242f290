#include "solver/staggered/staggered_solver.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstring>

#include "reference/problem/errors.hpp"
#include "reference/problem/problem_fixtures.hpp"

namespace porowave::solver {

BOOST_AUTO_TEST_SUITE(staggered_solver)

namespace {

Case papers_case(const Load& load, int elements = 100) {
  Case scene;
  scene.problem = fixtures::paper_problem(load);
  scene.discretization.scheme = Scheme::staggered4;
  scene.discretization.elements = elements;
  scene.discretization.kernel = kernel_name<WendlandC2>;
  scene.discretization.support_radius = 2.0;
  scene.discretization.basis_order = 2;
  scene.discretization.placement = Placement::stratified;
  scene.time.end = 4e-5;
  return scene;
}

const Load smooth(LoadShape::smooth_ramp, 1.0, 1e-5);

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

double largest(const std::vector<double>& values) {
  double result = 0.0;
  for (const double v : values) result = std::max(result, std::abs(v));
  return result;
}

BOOST_AUTO_TEST_CASE(results_scale_with_the_load) {
  StaggeredSolver one(papers_case(smooth));
  StaggeredSolver two(papers_case(Load(LoadShape::smooth_ramp, 2.0, 1e-5)));
  BOOST_REQUIRE(!one.run());
  BOOST_REQUIRE(!two.run());
  const Snapshot a = one.snapshot();
  const Snapshot b = two.snapshot();
  for (std::size_t p = 0; p < a.solid.x.size(); ++p) {
    BOOST_TEST(std::abs(b.solid.stress[p] - 2.0 * a.solid.stress[p]) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(the_same_case_gives_the_same_bits_whether_watched_or_not) {
  StaggeredSolver watched(papers_case(smooth));
  StaggeredSolver alone(papers_case(smooth));
  for (int i = 0; i < 100; ++i) {
    watched.step();
    BOOST_TEST(watched.snapshot().time == watched.time());
    alone.step();
  }
  BOOST_TEST(same_bits(watched.snapshot().solid.stress, alone.snapshot().solid.stress));
  BOOST_TEST(same_bits(watched.snapshot().fluid.velocity, alone.snapshot().fluid.velocity));
}

BOOST_AUTO_TEST_CASE(a_run_ends_exactly_at_its_end_within_the_courant_number) {
  for (const double courant : {0.13, 0.5}) {
    Case scene = papers_case(smooth);
    scene.time.courant = courant;
    StaggeredSolver solver(scene);
    const double limit = courant * 1e-3 / wave_speeds(scene.problem.material).p1;
    BOOST_TEST(solver.time_step() <= limit * (1.0 + 1e-12));
    BOOST_TEST(static_cast<double>(solver.planned_steps() - 1) * limit < scene.time.end);
    BOOST_TEST(!solver.run());
    BOOST_TEST(solver.time() == scene.time.end, boost::test_tools::tolerance(1e-14));
  }
}

// Only a window is stepped: it must be wide enough to follow the front, and no wider than need be.
BOOST_AUTO_TEST_CASE(nothing_moves_far_ahead_of_the_front_and_everything_behind_it) {
  const Case scene = papers_case(smooth, 800);
  StaggeredSolver solver(scene);
  BOOST_REQUIRE(!solver.run());
  const Snapshot s = solver.snapshot();
  const double front = wave_speeds(scene.problem.material).p1 * scene.time.end;
  for (std::size_t i = 0; i < s.node_x.size(); ++i) {
    const double size = std::abs(s.solid_velocity[i]) / scene.problem.velocity_scale();
    if (s.node_x[i] > front + 0.01) BOOST_TEST(size < 1e-12);
    if (s.node_x[i] < front - 0.02) BOOST_TEST(size > 0.01);
  }
}

// How much the fields of one grid change from courant 0.8 to 0.1: the error of the time step.
double error_of_time_step(Case scene) {
  std::array<Snapshot, 2> runs;
  for (std::size_t k = 0; k < 2; ++k) {
    scene.time.courant = k == 0 ? 0.8 : 0.1;
    StaggeredSolver solver(scene);
    BOOST_REQUIRE(!solver.run());
    runs[k] = solver.snapshot();
  }
  const auto distance = [](const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sum;
  };
  const double impedance = 1e6;  // Pa s/m, to add velocities to stresses
  return std::sqrt(distance(runs[0].effective_stress, runs[1].effective_stress) +
                   distance(runs[0].pore_pressure, runs[1].pore_pressure)) +
         impedance * std::sqrt(distance(runs[0].solid_velocity, runs[1].solid_velocity) +
                               distance(runs[0].fluid_velocity, runs[1].fluid_velocity));
}

BOOST_AUTO_TEST_CASE(the_corrected_time_step_has_nearly_no_error) {
  // The order itself shows against the reference only (verification/staggered_test.cpp): what the
  // points do not see of an increment is an error of order one in time, though of four in space.
  for (const double permeability : {1e-8, 1e-11, 1e-12}) {
    for (const auto& [near, far] : {std::pair(NearEnd::drained_traction, FarEnd::rigid_sealed),
                                    std::pair(NearEnd::sealed_traction, FarEnd::rigid_drained),
                                    std::pair(NearEnd::fluid_pressure, FarEnd::free_drained),
                                    std::pair(NearEnd::velocity, FarEnd::rigid_sealed)}) {
      const double size = near == NearEnd::velocity ? 1e-6 : 1.0;
      Case scene = papers_case(Load(LoadShape::sin4_pulse, size, 3e-5), 200);
      scene.discretization.placement = Placement::uniform;
      scene.discretization.basis_order = 3;
      scene.problem.column.near = near;
      scene.problem.column.far = far;
      scene.problem.material.intrinsic_permeability = permeability;
      scene.time.end = 6e-5;
      const double plain = error_of_time_step(scene);
      scene.time.order = 4;
      const double corrected = error_of_time_step(scene);
      BOOST_TEST_MESSAGE(name(near) << ", permeability " << permeability << ": " << plain << ", "
                                    << corrected << " corrected");
      BOOST_TEST(corrected < 0.02 * plain);
    }
  }
}

BOOST_AUTO_TEST_CASE(drag_never_limits_the_time_step) {
  // θ Δt from 1e-5 to 1e7. The stiffest limit is one wave: both phases move together.
  for (const auto& [permeability, order] :
       {std::pair(1e-8, 2), std::pair(1e-11, 2), std::pair(1e-14, 2), std::pair(1e-17, 2),
        std::pair(1e-20, 2), std::pair(1e-8, 4), std::pair(1e-13, 4), std::pair(1e-14, 4),
        std::pair(1e-17, 4), std::pair(1e-20, 4)}) {
    Case scene = papers_case(smooth);
    scene.time.order = order;
    scene.problem.material.intrinsic_permeability = permeability;
    scene.time.end = 2e-4;
    StaggeredSolver solver(scene);
    BOOST_TEST(!solver.run());
    const Snapshot s = solver.snapshot();
    BOOST_TEST(largest(s.effective_stress) < 3.0);
    if (permeability > 1e-16) continue;
    for (std::size_t i = 0; i < s.node_x.size(); ++i) {
      BOOST_TEST(std::abs(s.fluid_velocity[i] - s.solid_velocity[i]) <
                 1e-3 * scene.problem.velocity_scale());
    }
  }
}

BOOST_AUTO_TEST_CASE(nothing_moves_without_a_load) {
  Case scene = papers_case(Load(1.0, {3e-5, 5e-5}, {0.0, 1.0}));
  scene.time.end = 2.9e-5;
  StaggeredSolver solver(scene);
  solver.run();
  const Snapshot s = solver.snapshot();
  BOOST_TEST(largest(s.solid.velocity) == 0.0);
  BOOST_TEST(same_bits(s.solid.x, StaggeredSolver(scene).snapshot().solid.x));
}

BOOST_AUTO_TEST_CASE(a_column_with_no_points_in_reach_is_refused) {
  Case scene = papers_case(smooth, 60);
  for (int c = 0; c < 55; ++c) scene.discretization.empty_elements.push_back((c + 0.5) / 600.0);
  BOOST_CHECK_THROW(StaggeredSolver solver(scene), BreakdownError);
}

BOOST_AUTO_TEST_CASE(an_explosion_is_reported_with_step_quantity_and_place) {
  Case scene = papers_case(smooth);
  scene.time.courant = 1.0;  // above 6/7, the limit of the staggered differences
  StaggeredSolver solver(scene);
  const auto breakdown = solver.run();
  BOOST_REQUIRE(breakdown);
  BOOST_TEST(breakdown->step < solver.planned_steps());
  BOOST_TEST(breakdown->reason.find("step ") == 0u);
  BOOST_TEST(breakdown->reason.find("at x = ") != std::string::npos);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()

}  // namespace porowave::solver
