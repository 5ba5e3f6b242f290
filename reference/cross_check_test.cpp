#include "reference/cross_check.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "reference/problem/errors.hpp"
#include "reference/problem/problem_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(cross_check)

using namespace porowave;
using namespace porowave::reference;
namespace tt = boost::test_tools;

namespace {

const std::vector<double> points = {0.0, 0.013, 0.05, 0.0777, 0.1};
const std::vector<double> times = {1.1e-5, 5.3e-5};

Problem smooth_problem() {
  return fixtures::paper_problem(Load(LoadShape::smooth_ramp, 2.0, 2e-5));
}

using Change = std::function<void(double x, double t, BoundedFields&)>;

/// The main route with something done to its values.
Route changed(const Problem& problem, Change change) {
  Route result = route(Method::contour, problem);
  result.name = "changed";
  result.fields = [original = result.fields, change](const std::vector<double>& x, double t) {
    auto fields = original(x, t);
    for (std::size_t i = 0; i < x.size(); ++i) change(x[i], t, fields[i]);
    return fields;
  };
  return result;
}

RouteCheck check_changed(const Change& change) {
  const Problem problem = smooth_problem();
  const std::vector<Route> others = {changed(problem, change)};
  return compare_routes(problem, route(Method::contour, problem), others, points, times)
      .routes.front();
}

}  // namespace

BOOST_AUTO_TEST_CASE(three_routes_agree_on_a_smooth_load) {
  const CrossCheck check = compare_routes(smooth_problem(), points, times);
  BOOST_REQUIRE(check.routes.size() == 2u);
  BOOST_TEST(check.agree());
  BOOST_TEST(check.routes[0].route == "bromwich");
  BOOST_TEST(check.routes[0].worst.difference < 1e-9);
  BOOST_TEST(check.routes[1].route == "modal");
  BOOST_TEST(check.routes[1].worst.difference < 1e-11);
  for (const RouteCheck& route : check.routes) {
    BOOST_TEST(route.obstacle == "");
    BOOST_TEST(route.compared == 40u);
    BOOST_TEST(route.too_inaccurate == 0u);
  }
  BOOST_TEST(check.compared() == 80u);
}

BOOST_AUTO_TEST_CASE(a_route_that_cannot_do_the_problem_says_why) {
  const CrossCheck check = compare_routes(fixtures::paper_problem(), points, times);
  BOOST_TEST(check.agree());
  BOOST_TEST(check.routes[0].compared == 40u);
  BOOST_TEST(check.routes[1].compared == 0u);
  BOOST_TEST(check.routes[1].obstacle.find("load shape = \"step\"") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_wrong_value_is_found_and_named) {
  const RouteCheck check = check_changed([](double x, double t, BoundedFields& fields) {
    if (x == 0.05 && t == 5.3e-5) fields.value.pore_pressure += 1e-9;
    if (x == 0.1 && t == 1.1e-5) fields.value.effective_stress += 1e-10;
  });
  BOOST_TEST(!check.agrees);
  BOOST_TEST(check.compared == 40u);
  BOOST_TEST(check.worst.field == "pore_pressure");
  BOOST_TEST(check.worst.x == 0.05);
  BOOST_TEST(check.worst.t == 5.3e-5);
  BOOST_TEST(check.worst.difference == 0.5e-9, tt::tolerance(1e-4));  // the load is 2 Pa
  BOOST_TEST(check.worst.other - check.worst.main == 1e-9, tt::tolerance(1e-4));
}

BOOST_AUTO_TEST_CASE(a_difference_within_the_stated_errors_is_allowed) {
  const auto with_error = [](double error) {
    return check_changed([error](double, double, BoundedFields& fields) {
      fields.value.effective_stress += 1e-9;
      fields.error.effective_stress += error;
    });
  };
  BOOST_TEST(with_error(1.1e-9).agrees);
  BOOST_TEST(!with_error(0.9e-9).agrees);
}

BOOST_AUTO_TEST_CASE(a_value_without_accuracy_does_not_count_as_agreement) {
  const RouteCheck unresolved = check_changed([](double, double, BoundedFields& fields) {
    fields.value.pore_pressure = std::numeric_limits<double>::quiet_NaN();
    fields.error.pore_pressure = std::numeric_limits<double>::infinity();
    fields.error.solid_velocity = 1.0;
  });
  BOOST_TEST(unresolved.agrees);
  BOOST_TEST(unresolved.compared == 20u);
  BOOST_TEST(unresolved.too_inaccurate == 20u);
  // NaN that claims to be accurate is wrong.
  const RouteCheck wrong = check_changed([](double, double, BoundedFields& fields) {
    fields.value.pore_pressure = std::numeric_limits<double>::quiet_NaN();
  });
  BOOST_TEST(!wrong.agrees);
  BOOST_TEST(wrong.worst.field == "pore_pressure");
}

BOOST_AUTO_TEST_CASE(points_outside_of_the_column_are_refused) {
  BOOST_CHECK_THROW(compare_routes(smooth_problem(), {0.2}, {1e-5}), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
