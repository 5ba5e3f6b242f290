#include "reference/problem/load.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/test/unit_test.hpp>

#include "reference/problem/errors.hpp"

BOOST_AUTO_TEST_SUITE(load)

using namespace porowave;
namespace tt = boost::test_tools;

namespace {

std::vector<Load> every_load() {
  return {Load(LoadShape::step, 3.0),
          Load(LoadShape::smooth_ramp, 3.0, 2.0),
          Load(LoadShape::sin4_pulse, 3.0, 2.0),
          Load(LoadShape::block, 3.0, 2.0),
          Load(LoadShape::ricker, 3.0, 2.0),
          Load(3.0, {0.0, 0.5, 0.5, 1.5}, {1.0, 2.0, -1.0, 0.25})};
}

}  // namespace

BOOST_AUTO_TEST_CASE(shapes_at_known_times) {
  BOOST_TEST(Load(LoadShape::step, 3.0).value(0.0) == 3.0);
  BOOST_TEST(Load(LoadShape::smooth_ramp, 1.0, 2.0).value(1.0) == 0.5);
  BOOST_TEST(Load(LoadShape::smooth_ramp, 1.0, 2.0).value(2.5) == 1.0);
  BOOST_TEST(Load(LoadShape::sin4_pulse, 1.0, 2.0).value(1.0) == 1.0);
  BOOST_TEST(Load(LoadShape::sin4_pulse, 1.0, 2.0).value(0.5) == 0.25, tt::tolerance(1e-14));
  BOOST_TEST(Load(LoadShape::block, 1.0, 2.0).value(1.999) == 1.0);
  BOOST_TEST(Load(LoadShape::block, 1.0, 2.0).value(2.0) == 0.0);
  BOOST_TEST(Load(LoadShape::ricker, 1.0, 2.0).value(1.0) == 1.0);
  const Load table = every_load().back();
  BOOST_TEST(table.value(0.25) == 4.5);
  BOOST_TEST(table.value(0.5) == -3.0);
  BOOST_TEST(table.value(9.0) == 0.75);
}

BOOST_AUTO_TEST_CASE(nothing_acts_before_time_zero) {
  for (const Load& load : every_load()) {
    BOOST_TEST(load.value(-1e-9) == 0.0);
    BOOST_TEST(load.impulse(-1.0) == 0.0);
  }
}

BOOST_AUTO_TEST_CASE(smooth_loads_start_and_end_smoothly) {
  // smooth_ramp has two, sin4_pulse three vanishing derivatives at its ends.
  const double h = 1e-3;
  BOOST_TEST(Load(LoadShape::smooth_ramp, 1.0, 1.0).value(h) <= 11.0 * h * h * h);
  BOOST_TEST(1.0 - Load(LoadShape::smooth_ramp, 1.0, 1.0).value(1.0 - h) <= 11.0 * h * h * h);
  BOOST_TEST(Load(LoadShape::sin4_pulse, 1.0, 1.0).value(h) <= 98.0 * h * h * h * h);
  BOOST_TEST(std::abs(Load(LoadShape::ricker, 1.0, 1.0).value(0.0)) < 1e-16);
}

BOOST_AUTO_TEST_CASE(impulse_is_the_integral_of_the_load) {
  using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
  const std::vector<double> breaks = {0.0, 0.5, 1.5, 2.0, 3.0};
  for (const Load& load : every_load()) {
    for (const double end : {0.3, 0.5, 1.2, 1.9, 2.7}) {
      double integral = 0.0;
      for (std::size_t i = 0; i + 1 < breaks.size() && breaks[i] < end; ++i) {
        integral += Rule::integrate([&](double t) { return load.value(t); }, breaks[i],
                                    std::min(breaks[i + 1], end), 10, 1e-13);
      }
      BOOST_TEST_CONTEXT(name(load.shape()) << " to " << end) {
        BOOST_TEST(std::abs(load.impulse(end) - integral) < 1e-12);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(peak_is_reached_and_never_passed) {
  for (const Load& load : every_load()) {
    double largest = 0.0;
    for (int i = 0; i <= 4000; ++i) largest = std::max(largest, std::abs(load.value(1e-3 * i)));
    BOOST_TEST_CONTEXT(name(load.shape())) {
      BOOST_TEST(largest <= load.peak());
      BOOST_TEST(largest >= 0.99 * load.peak());
    }
  }
}

BOOST_AUTO_TEST_CASE(loads_without_sense_are_refused) {
  BOOST_CHECK_THROW(Load(LoadShape::block, 1.0, 0.0), InputError);
  BOOST_CHECK_THROW(Load(LoadShape::ricker, 1.0, -1.0), InputError);
  BOOST_CHECK_THROW(Load(1.0, {}, {}), InputError);
  BOOST_CHECK_THROW(Load(1.0, {1.0, 0.0}, {1.0, 1.0}), InputError);
  BOOST_CHECK_THROW(Load(1.0, {0.0, 1.0}, {1.0}), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
