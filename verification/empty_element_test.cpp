// The paper's empty element: linear shape functions reflect, wide weightings let the wave pass.

#include <boost/test/unit_test.hpp>

#include "reference/problem/problem_fixtures.hpp"
#include "verification/run.hpp"

BOOST_AUTO_TEST_SUITE(empty_element)

using namespace porowave;
using namespace porowave::verification;
using solver::Case;

namespace {

Case papers_case(const Load& load, double end) {
  Case scene;
  scene.problem = fixtures::paper_problem(load);
  scene.discretization.elements = 101;
  scene.time.end = end;
  return scene;
}

Case with_gap(Case scene) {
  scene.discretization.empty_elements = {0.05};
  return scene;
}

/// True if nothing at all has happened to the points right of x.
bool at_rest_behind(const solver::Snapshot& s, double x) {
  for (const auto& points : {s.solid, s.fluid}) {
    for (std::size_t p = 0; p < points.x.size(); ++p) {
      if (points.x[p] > x && (points.velocity[p] != 0.0 || points.stress[p] != 0.0)) return false;
    }
  }
  return true;
}

}  // namespace

BOOST_AUTO_TEST_CASE(nothing_arrives_behind_it_with_linear_shape_functions) {
  for (const LoadShape shape : {LoadShape::step, LoadShape::smooth_ramp}) {
    for (const int points : {1, 2, 4}) {
      Case scene = papers_case(Load(shape, 1.0, 1e-5), 6e-5);
      scene.discretization.transfer = solver::TransferName::shape;
      scene.discretization.kernel = solver::kernel_name<solver::BSpline1>;
      scene.discretization.support_radius = 1.0;
      scene.discretization.basis_order = 0;
      scene.discretization.points_per_element = points;
      const auto profile = reference_profile(scene);
      BOOST_TEST(at_rest_behind(run_case(with_gap(scene), *profile).snapshot, 0.05));
      BOOST_TEST(!at_rest_behind(run_case(scene, *profile).snapshot, 0.05));
    }
  }
}

BOOST_AUTO_TEST_CASE(nothing_arrives_behind_it_with_linear_weighting_and_one_point_per_cell) {
  for (const int order : {0, 1}) {
    Case scene = papers_case(Load(LoadShape::step, 1.0), 4e-5);
    scene.discretization.kernel = solver::kernel_name<solver::BSpline1>;
    scene.discretization.support_radius = 1.0;
    scene.discretization.basis_order = order;
    scene.discretization.points_per_element = 1;
    const auto profile = reference_profile(scene);
    const RunResult gap = run_case(with_gap(scene), *profile);
    BOOST_TEST(at_rest_behind(gap.snapshot, 0.05));
    BOOST_TEST(gap.errors[0].field.l2 > 0.5);
  }
}

BOOST_AUTO_TEST_CASE(the_reflected_wave_has_the_full_size_of_a_free_end) {
  // Behind the reflection from a free drained end at the gap the stresses of the P1 wave vanish.
  Case scene = with_gap(papers_case(Load(LoadShape::smooth_ramp, 1.0, 1e-5), 3.4e-5));
  scene.discretization.kernel = solver::kernel_name<solver::BSpline1>;
  scene.discretization.support_radius = 1.0;
  scene.discretization.points_per_element = 1;
  const RunResult gap = run_case(scene, *reference_profile(scene));
  Case cut = scene;
  cut.discretization.empty_elements.clear();
  cut.problem.column.length = 0.1 * 50 / 101;
  cut.problem.column.far = FarEnd::free_drained;
  const auto free_end = reference_profile(cut);
  double worst = 0.0;
  for (std::size_t p = 0; p < gap.snapshot.solid.x.size(); ++p) {
    const double x = gap.snapshot.solid.x[p];
    if (x > 0.045) break;
    worst =
        std::max(worst, std::abs(gap.snapshot.solid.stress[p] - free_end->at(x).effective_stress));
  }
  BOOST_TEST_MESSAGE("largest difference to a free end: " << worst << " of the load");
  BOOST_TEST(worst < 0.1);
}

BOOST_AUTO_TEST_CASE(it_costs_at_most_a_tenth_with_wendland_of_radius_5) {
  for (const LoadShape shape : {LoadShape::step, LoadShape::smooth_ramp}) {
    for (const int order : {0, 1, 2}) {
      Case scene = papers_case(Load(shape, 1.0, 1e-5), 4e-5);
      scene.discretization.kernel = solver::kernel_name<solver::WendlandC2>;
      scene.discretization.support_radius = 5.0;
      scene.discretization.basis_order = order;
      const auto profile = reference_profile(scene);
      const double without = run_case(scene, *profile).errors[0].field.l2;
      const double with = run_case(with_gap(scene), *profile).errors[0].field.l2;
      BOOST_TEST_MESSAGE(name(shape) << ", order " << order << ": error of effective stress "
                                     << without << " without, " << with << " with the gap");
      BOOST_TEST(with <= 1.1 * without);
      BOOST_TEST(without < 0.13);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
