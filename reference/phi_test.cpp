#include "reference/phi.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <limits>

BOOST_AUTO_TEST_SUITE(phi)

using Complex = std::complex<double>;
using porowave::reference::phi_functions;

BOOST_AUTO_TEST_CASE(agrees_with_its_integral) {
  using Rule = boost::math::quadrature::gauss<double, 60>;
  for (const double size : {1e-9, 0.01, 1.0, 3.9, 4.1, 7.0, 15.0}) {
    for (int direction = 0; direction < 12; ++direction) {
      const Complex z = std::polar(size, 0.1 + direction * 0.5);
      const auto phi = phi_functions<6>(z);
      double factorial = 1.0;
      for (std::size_t n = 1; n <= 6; ++n) {
        const auto integrand = [&](double u) {
          return std::exp((1.0 - u) * z) * std::pow(u, n - 1) / factorial;
        };
        const double real = Rule::integrate([&](double u) { return integrand(u).real(); }, 0., 1.);
        const double imag = Rule::integrate([&](double u) { return integrand(u).imag(); }, 0., 1.);
        const double scale = std::max(1.0, std::exp(z.real())) / factorial;
        BOOST_TEST_CONTEXT("z = " << z << ", n = " << n) {
          BOOST_TEST(std::abs(phi[n] - Complex(real, imag)) < 2e-14 * scale);
        }
        factorial *= static_cast<double>(n);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(at_zero_they_are_inverse_factorials) {
  const auto phi = phi_functions<6>(0.0);
  double factorial = 1.0;
  for (std::size_t n = 0; n <= 6; ++n) {
    BOOST_TEST(phi[n].real() == 1.0 / factorial);
    factorial *= static_cast<double>(n + 1);
  }
}

BOOST_AUTO_TEST_CASE(series_and_recurrence_meet) {
  for (int direction = 0; direction < 16; ++direction) {
    const Complex inside = std::polar(4.0 * (1.0 - 1e-12), 0.4 * direction);
    const Complex outside = std::polar(4.0 * (1.0 + 1e-12), 0.4 * direction);
    for (std::size_t n = 1; n <= 6; ++n) {
      const Complex difference = phi_functions<6>(inside)[n] - phi_functions<6>(outside)[n];
      BOOST_TEST(std::abs(difference) < 3e-11 * std::abs(phi_functions<6>(inside)[n]));
    }
  }
}

// exp(-inf) and what follows from it are 0; the part without a meaning must not keep it going.
BOOST_AUTO_TEST_CASE(an_overflow_to_minus_infinity_gives_nothing_and_ends) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(std::abs(phi_functions<6>({-inf, none})[6]) == 0.0);
  BOOST_TEST(!std::isfinite(std::abs(phi_functions<6>({none, none})[6])));
}

BOOST_AUTO_TEST_SUITE_END()
