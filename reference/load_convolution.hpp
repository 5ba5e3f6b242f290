#pragma once

#include <complex>
#include <utility>
#include <vector>

#include "reference/problem/load.hpp"

namespace porowave::reference {

/// W(s, tau) = integral_0^tau q(t') e^(s (tau - t')) dt': what a ray with transform g(s) has to be
/// multiplied with once it has travelled for tau since its arrival.
///
/// W is entire in s, so the load adds no singularity to those of the modes, and it stays bounded
/// by tau max|q| max(1, e^(Re s tau)). Closed form for every load shape except ricker, which is
/// integrated by Gauss-Legendre panels short enough for 1e-16 of its peak.
class LoadConvolution {
 public:
  explicit LoadConvolution(const Load& load);

  std::complex<double> operator()(std::complex<double> s, double tau) const;

  /// Times and sizes of the jumps of q (including the one at t = 0).
  const std::vector<std::pair<double, double>>& jumps() const { return jumps_; }
  double value(double tau) const { return load_.value(tau); }

 private:
  std::complex<double> unit(std::complex<double> s, double tau) const;

  Load load_;
  std::vector<std::pair<double, double>> jumps_;
};

}  // namespace porowave::reference
