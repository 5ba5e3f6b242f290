#pragma once

#include <span>

#include "reference/arrivals.hpp"
#include "reference/node_table.hpp"

namespace porowave::reference {

using FourSums = std::array<double, 4>;

/// Fields of a full wave per unit of load: what errors and cancellations are measured by.
FourSums unit_fields(const Problem& problem);

/// What one node adds to the inverse: Re(weight * transform), with bounds for its own rounding.
struct NodeSum {
  FourSums value{};
  FourSums rounding{};  ///< in units of epsilon
  double size = 0.0;    ///< largest |weight * transform| over what a full wave under the load has

  bool finite() const;
};

/// The transform of a group of arrivals, times e^(s t): what is to be summed over a contour.
class Integrand {
 public:
  Integrand(const Problem& problem, const LoadTransform& load, std::vector<Arrival> arrivals);
  // The sum over rays refers to those of this object.
  Integrand(const Integrand&) = delete;
  Integrand& operator=(const Integrand&) = delete;

  /// What a node adds; also adds to the rates.
  NodeSum at(const Node& node);
  /// Residue of a pole of the load on the imaginary axis, and of its conjugate.
  NodeSum residue(std::size_t arrival, const ImaginaryPole& pole, const WaveState& state);
  /// Poles of the load for an arrival.
  std::vector<ImaginaryPole> poles(std::size_t arrival) const;

  /// Sum over the arrivals of |d/dt of their part|, over the nodes so far: by it, rounding of the
  /// times of arrival enters the values.
  FourSums rates() const;
  void reset_rates();

  /// Largest real part of the exponents at s.
  double largest_exponent(Complex s, const ModeState& modes) const;

  const std::vector<Arrival>& arrivals() const { return arrivals_; }
  double longest_age() const;
  const FourSums& full_wave() const { return full_; }

 private:
  ScaledTransform part(const Arrival& a, Complex s) const;

  const LoadTransform& load_;
  std::vector<Arrival> arrivals_;  ///< by their crossings, as the sum over rays wants them
  std::vector<Ray> rays_;
  FourSums unit_;
  FourSums full_;  ///< fields of a full wave under the whole load
  FourSums per_full_;
  RaySum sum_;
  std::vector<FourSums> rates_;
};

}  // namespace porowave::reference
