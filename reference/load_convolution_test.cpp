#include "reference/load_convolution.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/test/unit_test.hpp>

using porowave::Load;
using porowave::LoadShape;
using porowave::reference::LoadConvolution;
using Complex = std::complex<double>;

namespace {

const std::vector<Load> loads = {Load(LoadShape::step, 3.0),
                                 Load(LoadShape::smooth_ramp, 3.0, 2.0),
                                 Load(LoadShape::sin4_pulse, 3.0, 2.0),
                                 Load(LoadShape::block, 3.0, 2.0),
                                 Load(LoadShape::ricker, 3.0, 2.0),
                                 Load(3.0, {0.2, 0.5, 0.5, 1.5}, {1.0, 2.0, -1.0, 0.25})};

Complex by_quadrature(const Load& load, Complex s, double tau) {
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

}  // namespace

BOOST_AUTO_TEST_SUITE(load_convolution)

BOOST_AUTO_TEST_CASE(closed_forms_agree_with_quadrature) {
  for (const Load& load : loads) {
    const LoadConvolution convolution(load);
    for (const double tau : {1e-3, 0.3, 1.1, 2.0, 5.0}) {
      for (const Complex s : {Complex(1e-6, 0), Complex(-3, 0.5), Complex(2, 3), Complex(-20, 12),
                              Complex(0.01, 2 * 3.141592), Complex(0, 30)}) {
        const double scale = 3.0 * tau * std::max(1.0, std::exp(s.real() * tau));
        BOOST_TEST_CONTEXT(name(load.shape()) << ", tau = " << tau << ", s = " << s) {
          BOOST_TEST(std::abs(convolution(s, tau) - by_quadrature(load, s, tau)) < 4e-14 * scale);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(jumps_are_those_of_the_load) {
  for (const Load& load : loads) {
    const LoadConvolution convolution(load);
    for (const auto& [time, size] : convolution.jumps()) {
      BOOST_TEST(std::abs(load.value(time) - load.value(time - 1e-12) - size) < 1e-9);
    }
  }
  BOOST_TEST(LoadConvolution(loads[0]).jumps().size() == 1u);
  BOOST_TEST(LoadConvolution(loads[1]).jumps().empty());
  BOOST_TEST(LoadConvolution(loads[3]).jumps().size() == 2u);
  BOOST_TEST(LoadConvolution(loads[5]).jumps().size() == 2u);
}

BOOST_AUTO_TEST_SUITE_END()
