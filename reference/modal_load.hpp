#pragma once

#include <complex>
#include <vector>

#include "reference/problem/load.hpp"

namespace porowave::reference::quarter_wave {

/// Highest derivative of a load that is asked for.
inline constexpr int most_derivatives = 18;

/// True for the loads that this route can do: those with two continuous derivatives.
bool is_smooth(const Load& load);

/// A smooth load up to a time t: its derivatives there, and what it has done to an oscillator.
class SmoothLoad {
 public:
  /// t > 0; the load is smooth.
  SmoothLoad(const Load& load, double t);

  /// q^(order)(t), 0 <= order <= most_derivatives; after the end of the load 0, or q itself. At its
  /// end, the value before it: that is what the response there contains.
  double derivative(int order) const;
  /// integral_0^t e^(s (t - tau)) q'(tau) dtau, exact to rounding. Re s t must not be large.
  std::complex<double> response(std::complex<double> s) const;

 private:
  using Complex = std::complex<double>;
  /// Nodes and weights times q' of a Gauss rule on panels of [0, end].
  struct Rule {
    double reach;  ///< the |s| end up to which it is exact
    std::vector<double> before_end;
    std::vector<double> weight;
  };

  double derivative_at(int order, double time) const;
  Rule rule(int panels) const;
  Complex by_rule(const Rule& rule, Complex s) const;
  /// The same integral up to `end`, for |s| end beyond the reach of the rules.
  Complex by_parts(Complex s) const;
  Complex sines(Complex s) const;

  Load load_;
  double t_;
  double end_;  ///< the earlier of t and the end of the load
  std::vector<Rule> rules_;
};

}  // namespace porowave::reference::quarter_wave
