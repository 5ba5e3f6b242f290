#include "reference/load_transform.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/test/unit_test.hpp>
#include <numbers>

BOOST_AUTO_TEST_SUITE(load_transform)

using porowave::Load;
using porowave::LoadShape;
using porowave::reference::LoadTransform;
using porowave::reference::TimeIntegral;
using Complex = std::complex<double>;

namespace {

Complex unscaled(const porowave::reference::ScaledTransform& t) {
  return t.value * std::exp(t.exponent);
}

const std::vector<Load> loads = {Load(LoadShape::step, 3.0),
                                 Load(LoadShape::smooth_ramp, 3.0, 2.0),
                                 Load(LoadShape::sin4_pulse, 3.0, 2.0),
                                 Load(LoadShape::block, 3.0, 2.0),
                                 Load(LoadShape::ricker, 3.0, 2.0),
                                 Load(3.0, {0.2, 0.5, 0.5, 1.5}, {1.0, 2.0, -1.0, 0.25})};

Complex integral(const Load& load, Complex s, double tau) {
  using Rule = boost::math::quadrature::gauss<double, 30>;
  std::vector<double> breaks = {0.0, 0.2, 0.5, 1.0, 1.5, 2.0, tau};
  std::sort(breaks.begin(), breaks.end());
  Complex sum = 0.0;
  for (std::size_t i = 0; i + 1 < breaks.size() && breaks[i + 1] <= tau; ++i) {
    for (int panel = 0; panel < 12; ++panel) {
      const double width = (breaks[i + 1] - breaks[i]) / 12;
      const double start = breaks[i] + panel * width;
      const auto f = [&](double t) { return load.value(t) * std::exp(s * (tau - t)); };
      sum += Complex(Rule::integrate([&](double t) { return f(t).real(); }, start, start + width),
                     Rule::integrate([&](double t) { return f(t).imag(); }, start, start + width));
    }
  }
  return sum;
}

/// (1/2 pi i) times the integral of f round a circle about 0.
template <class Function>
double inverse(double radius, Function&& f) {
  constexpr int nodes = 400;
  Complex sum = 0.0;
  for (int i = 0; i < nodes; ++i) {
    const Complex s = std::polar(radius, 2.0 * std::numbers::pi * (i + 0.5) / nodes);
    sum += f(s) * s;
  }
  return sum.real() / nodes;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_events_together_are_the_load) {
  // Inverted by themselves, the events that have happened add up to q.
  for (std::size_t i = 0; i < 2 * loads.size(); ++i) {
    const Load& load = loads[i / 2];
    const LoadTransform transform(load, i % 2 == 0 ? TimeIntegral::none : TimeIntegral::once, 2.4);
    if (transform.always_whole()) continue;
    for (const double tau : {0.05, 0.3, 1.1, 1.9, 2.4}) {
      double q = 0.0;
      for (std::size_t e = 0; e < transform.event_times().size(); ++e) {
        const double since = tau - transform.event_times()[e];
        if (since < 0.0) continue;
        q += inverse(8.0, [&](Complex s) { return unscaled(transform.event(e, s, since)); });
      }
      BOOST_TEST_CONTEXT(name(load.shape()) << " at " << tau) {
        BOOST_TEST(transform.value(tau) == (i % 2 == 0 ? load.value(tau) : load.impulse(tau)));
        BOOST_TEST(std::abs(q - transform.value(tau)) < 1e-14 * std::exp(8.0 * tau));
        BOOST_TEST(std::abs(transform.value(tau)) <= transform.peak());
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(poles_outside_of_a_contour_are_given_with_their_residues) {
  const double tau = 0.7;
  for (const TimeIntegral integral : {TimeIntegral::none, TimeIntegral::once}) {
    const LoadTransform transform(loads[2], integral, tau);
    const double inside =
        inverse(1.0, [&](Complex s) { return unscaled(transform.event(0, s, tau)); });
    double at_poles = 0.0;
    for (const auto& pole : transform.event_poles(0)) {
      at_poles += 2.0 * (pole.residue * std::polar(1.0, pole.frequency * tau)).real();
    }
    BOOST_TEST(std::abs(inside + at_poles - transform.value(tau)) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(once_settled_it_is_the_transform_of_the_whole_load) {
  for (const Load& load : loads) {
    const LoadTransform transform(load);
    for (const double tau : {2.0, 2.6, 5.0}) {
      for (const Complex s :
           {Complex(0.5, 1e-3), Complex(1, 3), Complex(0.01, 2 * 3.141592), Complex(0.2, 30)}) {
        // Beyond the end the load stays: the rest of the integral is q_end e^(s (tau - end))/s.
        const double end = transform.end();
        const Complex expected =
            std::exp(s * (tau - end)) * (integral(load, s, end) + load.value(tau + 10.0) / s);
        auto settled = transform.settled(s);
        settled.exponent += s * (tau - end);
        const double size = settled.size * std::exp(settled.exponent.real());
        const double of_integral = load.peak() * end * std::exp(s.real() * tau);
        BOOST_TEST_CONTEXT(name(load.shape()) << ", tau = " << tau << ", s = " << s) {
          BOOST_TEST(std::abs(unscaled(settled) - expected) < 1e-14 * (size + of_integral));
          BOOST_TEST(std::abs(unscaled(settled)) <= size * (1.0 + 1e-14));
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_integral_of_the_load_has_its_transform_over_s) {
  const Complex s(0.4, 7.0);
  for (const Load& load : loads) {
    const auto of_load = LoadTransform(load).settled(s);
    const auto of_integral = LoadTransform(load, TimeIntegral::once, 3.0).settled(s);
    BOOST_TEST(std::abs(unscaled(of_load) / s - unscaled(of_integral)) <
               1e-15 * of_integral.size * std::exp(of_integral.exponent.real()));
    BOOST_TEST(LoadTransform(load, TimeIntegral::once, 3.0).jumps().empty());
  }
}

BOOST_AUTO_TEST_CASE(far_out_the_settled_load_does_not_cancel) {
  // Left of the poles only the last event is felt: minus what would follow a smooth end.
  const auto last_event = [](const LoadTransform& transform, Complex s) {
    return unscaled(transform.event(transform.event_times().size() - 1, s, 0.0));
  };
  for (const Load& load : {loads[1], loads[2]}) {
    const LoadTransform transform(load);
    for (const Complex s : {Complex(-60, 10), Complex(-500, 500), Complex(-1e6, 1e3)}) {
      const Complex expected = last_event(transform, s);
      BOOST_TEST(std::abs(unscaled(transform.settled(s)) - expected) < 1e-14 * std::abs(expected));
    }
  }
}

BOOST_AUTO_TEST_CASE(jumps_are_those_of_the_load) {
  for (const Load& load : loads) {
    const LoadTransform transform(load);
    for (const auto& [time, size] : transform.jumps()) {
      const double before = load.value(time - 1e-12);
      const bool doubled = load.shape() == LoadShape::table && time == 0.5 && size == 0.0;
      if (!doubled) BOOST_TEST(std::abs(load.value(time) - before - size) < 1e-9);
    }
  }
  BOOST_TEST(LoadTransform(loads[0]).jumps().size() == 1u);
  BOOST_TEST(LoadTransform(loads[1]).jumps().empty());
  BOOST_TEST(LoadTransform(loads[3]).jumps().size() == 2u);
}

BOOST_AUTO_TEST_SUITE_END()
