#include "reference/fourier_integral.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

BOOST_AUTO_TEST_SUITE(fourier_integral)

using namespace porowave::reference;
namespace tt = boost::test_tools;

BOOST_AUTO_TEST_CASE(integrals_known_in_closed_form) {
  using Weight = FourierIntegral::Weight;
  FourierIntegral quadrature;
  const auto check = [](const Integral& integral, double exact) {
    BOOST_TEST(std::abs(integral.value - exact) < 1e-12);
    BOOST_TEST(std::abs(integral.value - exact) <= integral.error + 1e-14);
    BOOST_TEST(integral.error < 1e-10);
  };
  const auto decay = [](double y) { return std::exp(-y); };
  const auto rational = [](double y) { return 1.0 / (1.0 + y * y); };
  check(quadrature.to_infinity(decay, 0.0, Weight::cosine, 1e-13), 0.5);
  check(quadrature.to_infinity(decay, 0.0, Weight::sine, 1e-13), 0.5);
  check(quadrature.to_infinity(rational, 0.0, Weight::cosine, 1e-13),
        0.5 * std::numbers::pi * std::exp(-1.0));
  check(quadrature.to_infinity(decay, 1.0, Weight::cosine, 1e-13),
        0.5 * std::exp(-1.0) * (std::cos(1.0) - std::sin(1.0)));
  check(quadrature.between(rational, -1.0, 1.0, 1e-13), 0.5 * std::numbers::pi);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_integrated_says_so_and_ends_nothing) {
  FourierIntegral quadrature;
  const auto cosine = [&](const FourierIntegral::Function& f) {
    return quadrature.to_infinity(f, 0.0, FourierIntegral::Weight::cosine, 1e-10);
  };
  const auto pole = [](double y) { return 1.0 / ((y - 0.3) * (y - 0.3)); };
  const auto useless = [](const Integral& integral) {
    return !(integral.error < std::abs(integral.value));
  };
  BOOST_TEST(useless(cosine(pole)));
  BOOST_TEST(useless(cosine([](double y) { return std::sin(1e9 * y * y); })));
  BOOST_TEST(useless(quadrature.between(pole, 0.0, 1.0, 1e-10)));
  const Integral undefined = cosine([](double y) { return std::log(1.0 - y); });
  BOOST_TEST(std::isnan(undefined.value));
  BOOST_TEST(std::isinf(undefined.error));
}

BOOST_AUTO_TEST_SUITE_END()
