#pragma once

#include <array>
#include <complex>

namespace porowave::reference {

/// phi_0 ... phi_Order at z: phi_0 = e^z, phi_n(z) = sum_k z^k/(k + n)!, so that
/// integral_0^1 e^((1-u)z) u^(n-1)/(n-1)! du = phi_n(z) for n >= 1. Entire functions.
/// Relative accuracy about 1e-15 for Re z > -700 (phi_0 underflows beyond); overflow above 700.
/// Source: Higham, Functions of Matrices (2008), section 10.7.4.
template <int Order>
std::array<std::complex<double>, Order + 1> phi_functions(std::complex<double> z) {
  std::array<std::complex<double>, Order + 1> phi;
  double factorial = 1.0;
  phi[0] = std::exp(z);
  // Upwards the recurrence divides by z and loses digits for small z; there a series for the
  // highest function and the recurrence downwards lose none.
  constexpr double series_radius = 4.0;
  if (!(std::norm(z) <= series_radius * series_radius)) {  // NaN, too: its series would not end
    for (std::size_t n = 1; n <= Order; ++n) {
      phi[n] = (phi[n - 1] - 1.0 / factorial) / z;
      factorial *= static_cast<double>(n);
    }
    return phi;
  }
  for (int n = 2; n <= Order; ++n) factorial *= n;
  std::complex<double> term = 1.0 / factorial;
  std::complex<double> sum = term;
  const double size = std::abs(z);
  double bound = 1.0;
  for (int k = 1; bound > 1e-18; ++k) {
    term *= z / static_cast<double>(k + Order);
    bound *= size / static_cast<double>(k + Order);
    sum += term;
  }
  phi[Order] = sum;
  for (int n = Order - 1; n >= 1; --n) {
    factorial /= n + 1;
    phi[static_cast<std::size_t>(n)] = z * phi[static_cast<std::size_t>(n) + 1] + 1.0 / factorial;
  }
  return phi;
}

}  // namespace porowave::reference
