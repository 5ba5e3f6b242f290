// Three ways to the exact solution on many random problems; routes_tests -- 1000 takes that many
// instead of the few of the test suite.

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <ctime>
#include <limits>
#include <sstream>
#include <string>

#include "reference/bromwich.hpp"
#include "reference/column_solution.hpp"
#include "reference/field_fixtures.hpp"
#include "reference/modal.hpp"
#include "reference/random_problems.hpp"

BOOST_AUTO_TEST_SUITE(routes)

using namespace porowave;
using namespace porowave::reference;

namespace {

double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Point {
  Problem problem;
  double x;
  double t;
};

std::ostream& operator<<(std::ostream& out, const Point& point) {
  const Problem& p = point.problem;
  return out << name(p.column.near) << ", " << name(p.column.far) << ", " << name(p.load.shape())
             << ", drag rate * t = " << p.material.relaxation_rate() * point.t
             << ", x = " << point.x << ", t = " << point.t;
}

/// What was seen of one route against the contour.
struct Tally {
  int compared = 0;
  int skipped = 0;        ///< the contour's bound is too large
  int beyond = 0;         ///< differences larger than the goal
  int beyond_errors = 0;  ///< differences larger than both stated errors
  double worst = 0.0;
  double seconds = 0.0;
  std::string where = "none";

  void see(const Point& point, const BoundedFields& contour, const BoundedFields& other,
           double goal) {
    ++compared;
    const double size = fixtures::distance(point.problem, contour.value, other.value);
    const double errors = fixtures::largest_share(point.problem, contour.error) +
                          fixtures::largest_share(point.problem, other.error);
    if (!(size <= goal)) ++beyond;
    if (!(size <= errors + 1e-13)) ++beyond_errors;
    if (size <= worst) return;
    worst = size;
    std::ostringstream text;
    text << point;
    where = text.str();
  }
};

std::ostream& operator<<(std::ostream& out, const Tally& tally) {
  return out << tally.compared << " problems, " << tally.skipped << " skipped; worst difference "
             << tally.worst << " of the load (" << tally.where << "); "
             << 1e3 * tally.seconds / tally.compared << " ms CPU a value";
}

Point random_point(fixtures::RandomProblems& random, const Problem& problem) {
  const double length = problem.column.length.value_or(1.0);
  const double crossing = length / wave_speeds(problem.material).p1;
  return {problem, length * random.uniform(0.0, 1.0), crossing * random.uniform(0.1, 4.0)};
}

double duration(fixtures::RandomProblems& random, const Problem& problem) {
  return problem.column.length.value_or(1.0) / wave_speeds(problem.material).p1 *
         random.log_uniform(0.3, 3.0);
}

/// Problems that all routes can do.
Point smooth_point(fixtures::RandomProblems& random) {
  const NearEnd near = random.index(2) == 0 ? NearEnd::drained_traction : NearEnd::fluid_pressure;
  Problem problem = random.next(random.log_uniform(0.1, 50.0), Load(), near, FarEnd::rigid_sealed);
  const std::array<LoadShape, 3> shapes = {LoadShape::smooth_ramp, LoadShape::sin4_pulse,
                                           LoadShape::ricker};
  problem.load =
      Load(shapes[static_cast<std::size_t>(random.index(3))], 1.0, duration(random, problem));
  return random_point(random, problem);
}

/// All ends and loads.
Point any_point(fixtures::RandomProblems& random) {
  Problem problem =
      random.next(random.log_uniform(0.1, 50.0), Load(), static_cast<NearEnd>(random.index(4)),
                  static_cast<FarEnd>(random.index(4)));
  const auto shape = static_cast<LoadShape>(random.index(6));
  const double time = duration(random, problem);
  problem.load =
      shape == LoadShape::table
          ? Load(2.5, {0.0, 0.3 * time, 0.5 * time, 0.5 * time, time}, {0.5, 1, -0.5, 0.2, 0.7})
          : Load(shape, 1.0, time);
  return random_point(random, problem);
}

int problems_wanted() {
  const auto& suite = boost::unit_test::framework::master_test_suite();
  return suite.argc > 1 ? std::stoi(suite.argv[1]) : 300;
}

}  // namespace

BOOST_AUTO_TEST_CASE(smooth_problems_agree_between_contour_and_modes_to_1e_10) {
  const int problems = problems_wanted();
  fixtures::RandomProblems random(101);
  Tally tally;
  for (int trial = 0; trial < problems; ++trial) {
    const Point point = smooth_point(random);
    const BoundedFields contour = ColumnSolution(point.problem).at(point.x, point.t);
    const double start = cpu_seconds();
    const BoundedFields sum = ModalSolution(point.problem, point.t, 5e-11).at(point.x);
    tally.seconds += cpu_seconds() - start;
    tally.see(point, contour, sum, 1e-10);
  }
  BOOST_TEST_MESSAGE("contour and modal sum: " << tally);
  BOOST_TEST(tally.beyond == 0);
  BOOST_TEST(tally.beyond_errors == 0);
}

BOOST_AUTO_TEST_CASE(problems_agree_between_contour_and_bromwich_integral_to_1e_8) {
  const int problems = problems_wanted();
  fixtures::RandomProblems random(102);
  Tally tally;
  for (int trial = 0; trial < problems; ++trial) {
    const Point point = any_point(random);
    const BoundedFields contour = ColumnSolution(point.problem).at(point.x, point.t);
    if (!(fixtures::largest_share(point.problem, contour.error) <= 1e-10)) {
      ++tally.skipped;
      continue;
    }
    const double start = cpu_seconds();
    const BoundedFields integral = BromwichSolution(point.problem).at(point.x, point.t);
    tally.seconds += cpu_seconds() - start;
    tally.see(point, contour, integral, 1e-8);
  }
  BOOST_TEST_MESSAGE("contour and Bromwich integral: " << tally);
  BOOST_TEST(tally.beyond == 0);
  BOOST_TEST(tally.beyond_errors == 0);
  BOOST_TEST(tally.skipped <= problems / 50);
}

BOOST_AUTO_TEST_SUITE_END()
