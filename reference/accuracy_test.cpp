// The main route against the 50-digit one at random points of the whole range. The number of points
// can be given: digits_tests --run_test=accuracy -- 2000 [first seed]

#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <mutex>
#include <thread>

#include "reference/field_fixtures.hpp"
#include "reference/fifty_digits.hpp"
#include "reference/random_points.hpp"
#include "reference/waves.hpp"

BOOST_AUTO_TEST_SUITE(accuracy)

using namespace porowave;
using fixtures::shares;
using fixtures::Worst;

namespace {

struct Tally {
  std::mutex lock;
  Worst error;     ///< share of the load; where the bound holds no jump
  Worst moderate;  ///< the same, of values below 100 times the load
  Worst relative;  ///< share of the value, where that is more than 100 times the load
  Worst ratio;     ///< error over bound
  Worst slack;     ///< bound over error, of errors above 1e-13
  int points = 0;
  int moving = 0;      ///< where a wave has arrived
  int on_front = 0;    ///< where the bound holds a jump
  int unresolved = 0;  ///< by the main route
  int unknown = 0;     ///< by the 50-digit route
  int large = 0;       ///< errors above 1e-13
  int loose = 0;       ///< of these, with a bound more than 100 times as large
};

std::string description(int number, const fixtures::RandomPoint& p) {
  std::ostringstream text;
  const Material& m = p.problem.material;
  text << '#' << number << ' ' << p.place << ", " << name(p.problem.column.near) << ", "
       << name(p.problem.column.far) << ", " << name(p.problem.load.shape()) << ", porosity "
       << m.porosity << ", E/K_f " << m.constrained_modulus / m.fluid_bulk_modulus
       << ", permeability " << m.intrinsic_permeability << ", drag rate * t "
       << m.relaxation_rate() * p.t << ", crossings "
       << p.t * wave_speeds(m).p1 / p.problem.column.length.value_or(HUGE_VAL);
  return text.str();
}

void compare(int number, const fixtures::RandomPoint& point, Tally& tally) {
  // Above this a bound holds a jump: the point lies on a front to rounding.
  constexpr double jump = 1e-7;
  const auto main = reference::ColumnSolution(point.problem).at(point.x, point.t);
  const auto exact = fixtures::fifty_digits(point.problem, point.x, point.t);
  const auto value = shares(point.problem, main.value);
  const auto bound = shares(point.problem, main.error);
  const auto truth = shares(point.problem, exact.value);
  const bool ricker = point.problem.load.shape() == LoadShape::ricker;
  // The Ricker wavelet starts and ends with a jump of 3.7e-17, which both routes leave out.
  const double cut = ricker ? 4e-17 * reference::slow_wave_factor(point.problem.material) : 0.0;
  const std::string where = description(number, point);
  const std::lock_guard<std::mutex> guard(tally.lock);
  ++tally.points;
  if (!(exact.agreement < 1e-15)) ++tally.unknown;
  if (!(bound[0] < HUGE_VAL)) ++tally.unresolved;
  if (!(exact.agreement < 1e-15) || !(bound[0] < HUGE_VAL)) return;
  if (bound[0] + bound[1] + bound[2] + bound[3] > 0.0) ++tally.moving;
  const bool on_front = std::max({bound[0], bound[1], bound[2], bound[3]}) > jump;
  if (on_front) ++tally.on_front;
  for (std::size_t f = 0; f < 4; ++f) {
    const double error = std::max(0.0, std::abs(value[f] - truth[f]) - exact.agreement - cut);
    tally.error.see(error, where);
    const double size = std::abs(truth[f]);
    if (size < 100.0) tally.moderate.see(error, where);
    if (size >= 100.0) tally.relative.see(error / size, where);
    if (error > 0.0) tally.ratio.see(error / bound[f], where);
    if (!(error > 1e-13) || on_front) continue;
    ++tally.large;
    tally.slack.see(bound[f] / error, where);
    if (bound[f] > 100.0 * error) ++tally.loose;
  }
}

long argument(int index, long otherwise) {
  const auto& suite = boost::unit_test::framework::master_test_suite();
  return suite.argc > index ? std::atol(suite.argv[index]) : otherwise;
}

}  // namespace

BOOST_AUTO_TEST_CASE(random_points_of_the_whole_range_are_right_to_1e_12_and_within_their_bounds) {
  const long count = argument(1, 100);
  const auto seed = static_cast<unsigned>(argument(2, 1));
  BOOST_REQUIRE(count > 0);
  Tally tally;
  const auto work = [&](int share, int shares_of_work) {
    fixtures::RandomPoints random(seed);
    for (int i = 0; i < count; ++i) {
      const auto point = random.next();
      if (i % shares_of_work == share) compare(i, point, tally);
    }
  };
  const int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  std::vector<std::thread> pool;
  for (int i = 0; i < threads; ++i) pool.emplace_back(work, i, threads);
  for (std::thread& thread : pool) thread.join();

  BOOST_TEST(tally.points == count);
  BOOST_TEST(tally.unresolved == 0);
  BOOST_TEST(tally.unknown <= count / 200);
  BOOST_TEST(tally.moving > count / 2);
  // On a very soft skeleton velocities are thousands of times the scale that errors are judged by:
  // doubles themselves are then more than 1e-12 of it apart.
  BOOST_TEST(tally.moderate.size <= 1e-12);
  BOOST_TEST(tally.relative.size <= 1e-14);
  BOOST_TEST(tally.ratio.size < 1.0);
  // Seldom: a tenth of such values, of which there are few in a short run.
  BOOST_TEST(10 * tally.loose <= tally.large + 20);
  BOOST_TEST_MESSAGE(tally.points << " random points (" << tally.moving << " reached by a wave, "
                                  << tally.on_front << " on a front), " << tally.unresolved
                                  << " unresolved, " << tally.unknown << " not known to 15 digits");
  BOOST_TEST_MESSAGE("worst error " << tally.error.size << " of the load: " << tally.error.where);
  BOOST_TEST_MESSAGE("of values below 100 times the load " << tally.moderate.size << ": "
                                                           << tally.moderate.where);
  BOOST_TEST_MESSAGE("of larger values, relative to the value " << tally.relative.size << ": "
                                                                << tally.relative.where);
  BOOST_TEST_MESSAGE("worst error/bound " << tally.ratio.size << ": " << tally.ratio.where);
  BOOST_TEST_MESSAGE("errors above 1e-13: " << tally.large << " values, bound more than 100 times "
                                            << "above " << tally.loose << " of them; worst "
                                            << tally.slack.size << ": " << tally.slack.where);
}

BOOST_AUTO_TEST_SUITE_END()
