#include "verification/cost/cost_model.hpp"

#include <boost/test/unit_test.hpp>
#include <functional>

#include "verification/paper_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(cost_model)

using namespace porowave;
using namespace porowave::verification;

namespace {

using Change = std::function<void(solver::Case&)>;

solver::Case changed(const Change& change) {
  solver::Case scene = studies::papers_case(100);
  change(scene);
  return scene;
}

}  // namespace

BOOST_AUTO_TEST_CASE(terms_are_points_and_visits) {
  const solver::Case scene = studies::papers_case(100);
  const CaseCost cost = case_cost(scene);
  const double length = solver::ColumnSolver::grid_length(scene);
  const double travel = wave_speeds(scene.problem.material).p1 * 4e-5 / length;
  BOOST_TEST_REQUIRE(travel < 1.0);  // so half of what is reached in the end is so in the mean
  const double visits = 100 * (travel * 100 / 0.5) * travel / 2;
  const double radius = scene.discretization.support_radius;
  BOOST_TEST(cost.points == 800.0);
  const CostTerms expected = {1.0, 800.0, 800.0 * radius, visits, visits * radius, 0.0};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    BOOST_TEST(cost.terms[i] == expected[i], boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(twice_the_elements_are_four_times_the_visits_and_twice_the_points) {
  for (const Change& change : std::initializer_list<Change>{
           [](solver::Case&) {}, [](solver::Case& s) { s.time.xpic_order = 3; },
           [](solver::Case& s) { s.discretization.scheme = solver::Scheme::staggered4; }}) {
    const CaseCost one = case_cost(changed(change));
    const CaseCost two = case_cost(changed([&](solver::Case& scene) {
      change(scene);
      scene.discretization.elements *= 2;
    }));
    for (std::size_t i = 0; i < cost_term_count; ++i) {
      const double factor = i == 0 ? 1.0 : i < 3 ? 2.0 : 4.0;
      BOOST_TEST(two.terms[i] == factor * one.terms[i], boost::test_tools::tolerance(1e-12));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_whole_column_is_stepped_once_the_wave_has_crossed_it) {
  // From t = T on, the crossing, every further second costs the same: of all elements.
  const double crossing = solver::ColumnSolver::grid_length(changed([](solver::Case&) {})) /
                          wave_speeds(changed([](solver::Case&) {}).problem.material).p1;
  const auto visits = [&](double crossings) {
    return case_cost(changed([&](solver::Case& s) { s.time.end = crossings * crossing; })).terms[3];
  };
  const double whole = 100.0 * 100.0 / 0.5;
  BOOST_TEST(visits(1.0) == whole / 2, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(visits(2.0) - visits(1.0) == whole, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(visits(5.0) - visits(4.0) == whole, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_family_is_how_steps_are_made) {
  using solver::TransferName;
  const auto family = [](const Change& change) { return case_cost(changed(change)).family; };
  BOOST_TEST((family([](auto&) {}) == CostFamily::frozen));
  BOOST_TEST(
      (family([](auto& s) { s.time.path = solver::StepPath::points; }) == CostFamily::points));
  BOOST_TEST((family([](auto& s) { s.time.xpic_order = 2; }) == CostFamily::general));
  BOOST_TEST((family([](auto& s) {
                s.discretization.transfer = TransferName::shape;
                s.discretization.shape = *solver::shape_from_name("bspline2");
              }) == CostFamily::general));
  BOOST_TEST((family([](auto& s) { s.discretization.transfer = TransferName::shape; }) ==
              CostFamily::frozen));
  BOOST_TEST((family([](auto& s) { s.discretization.transfer = TransferName::apic; }) ==
              CostFamily::affine));
  BOOST_TEST((family([](auto& s) { s.discretization.scheme = solver::Scheme::staggered4; }) ==
              CostFamily::staggered));
}

BOOST_AUTO_TEST_CASE(every_family_is_predicted_to_cost_something_and_more_on_a_finer_grid) {
  for (const Change& change : std::initializer_list<Change>{
           [](solver::Case&) {}, [](solver::Case& s) { s.time.path = solver::StepPath::points; },
           [](solver::Case& s) { s.time.xpic_order = 3; },
           [](solver::Case& s) { s.discretization.transfer = solver::TransferName::apic; },
           [](solver::Case& s) { s.discretization.scheme = solver::Scheme::staggered4; }}) {
    double last = 0.0;
    for (const int elements : {1, 10, 100, 1000}) {
      const solver::Case scene = changed([&](solver::Case& s) {
        change(s);
        s.discretization.elements = elements;
      });
      BOOST_TEST(predicted_solver_seconds(scene) > last);
      BOOST_TEST(predicted_seconds(scene) > predicted_solver_seconds(scene));
      last = predicted_solver_seconds(scene);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
