#include "reference/arrivals.hpp"

#include <boost/test/unit_test.hpp>

#include "reference/problem/problem_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(arrivals)

using namespace porowave;
using namespace porowave::reference;

namespace {

struct Arrived {
  WaveModes modes;
  LoadTransform load;
  std::vector<Ray> rays;
  ArrivalGroups groups;

  Arrived(const Problem& problem, double x, double t)
      : modes(problem.material),
        load(problem.load),
        rays(rays_until(problem, modes, x, t)),
        groups(arrivals_of(problem, modes, load, rays, t, 1e-15 * t)) {}

  std::size_t count() const {
    std::size_t count = 0;
    for (const auto& group : groups.groups) count += group.arrivals.size();
    return count;
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(every_event_that_has_arrived_is_there_once) {
  // At x = 0.02 P1 arrives after 8.7 us, P2 after 17.5 us; the block ends 10 us later.
  const Problem problem = fixtures::paper_problem(Load(LoadShape::block, 1.0, 1e-5));
  BOOST_TEST(Arrived(problem, 0.02, 8e-6).count() == 0u);
  BOOST_TEST(Arrived(problem, 0.02, 1.2e-5).count() == 1u);
  const Arrived settled(problem, 0.02, 1.95e-5);  // P1 has settled, P2 has begun
  BOOST_TEST(settled.count() == 2u);
  BOOST_REQUIRE(settled.groups.groups.size() == 2u);
  BOOST_TEST((settled.groups.groups[0].arrivals[0].part == Arrival::Part::settled));
  BOOST_TEST((settled.groups.groups[1].arrivals[0].part == Arrival::Part::event));
  BOOST_TEST(settled.groups.groups[1].arrivals[0].since == 1.95e-5 - 0.02 / settled.modes.speed(1),
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_group_holds_parts_of_similar_age_oldest_first) {
  const Arrived arrived(fixtures::paper_problem(), 0.02, 2e-3);
  BOOST_TEST(arrived.count() == arrived.rays.size());
  for (const auto& group : arrived.groups.groups) {
    for (std::size_t i = 1; i < group.arrivals.size(); ++i) {
      BOOST_TEST(group.arrivals[i].age <= group.arrivals[i - 1].age);
    }
    BOOST_TEST(group.arrivals.front().age < 16.0 * group.arrivals.back().age);
  }
}

BOOST_AUTO_TEST_CASE(waves_that_drag_has_used_up_are_left_out_and_counted) {
  Problem problem = fixtures::paper_problem();
  problem.material.intrinsic_permeability = 1e-15;
  const Arrived arrived(problem, 0.02, 4e-5);  // both waves have come; the slow one is dead
  BOOST_REQUIRE(arrived.rays.size() == 2u);
  BOOST_REQUIRE(arrived.count() == 1u);
  BOOST_TEST(arrived.groups.groups[0].arrivals[0].ray.mode == 0);
  BOOST_TEST(arrived.groups.neglected < 1e-18);
}

BOOST_AUTO_TEST_CASE(complete_sets_are_looked_for_where_modes_meet_on_the_right) {
  Problem problem = fixtures::paper_problem();
  // Light grains in much water: the fast wave is the one that drag damps.
  problem.material = {0.97, 2000.0, 1000.0, 2.5e8, 2.0e9, 1e-10, 1e-3};
  problem.column.near = NearEnd::velocity;
  const WaveModes modes(problem.material);
  BOOST_REQUIRE(modes.branch_point().real() > 0.0);
  const double t = 0.03 / modes.speed(1);
  const Arrived both(problem, 0.02, t);
  BOOST_REQUIRE(!both.groups.groups.empty());
  BOOST_TEST(both.groups.groups[0].complete);
  const Arrived one(problem, 0.04, t);
  for (const auto& group : one.groups.groups) BOOST_TEST(!group.complete);
}

BOOST_AUTO_TEST_SUITE_END()
