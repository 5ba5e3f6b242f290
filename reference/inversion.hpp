#pragma once

#include <span>
#include <vector>

#include "reference/contour.hpp"
#include "reference/load_transform.hpp"
#include "reference/rays.hpp"

namespace porowave::reference {

using FourSums = std::array<double, 4>;

/// A part of the load that has arrived with a ray: one event, the whole settled load, or the
/// passing part of a load without events.
struct Arrival {
  enum class Part { event, settled, passing };
  Ray ray;
  Part part;
  std::size_t event;  ///< for Part::event
  double since;       ///< s travelled since this part arrived
};

struct Inverted {
  FourSums value{};
  FourSums error{};  ///< bounds; infinity where the sum could not be resolved
  long nodes = 0;    ///< evaluations of the transform that it took
};

/// Inverts the transform of a group of arrivals with similar `since`: closed contour integral round
/// all singularities by the trapezoidal rule.
///
/// The contour is an ellipse; its right end is put as far out as the integrand on the real axis
/// stays of the size of the load, which is near the saddle point where waves are damped. Nodes are
/// doubled until two sums agree to their rounding. Where the integrand has decayed below 1e-18 of
/// the load no nodes are spent, so stiff drag (a contour very long compared with 1/t) costs little.
class Inversion {
 public:
  Inversion(const Problem& problem, const WaveModes& modes, const LoadTransform& load, double t);

  Inverted invert(std::span<const Arrival> arrivals) const;

 private:
  const Problem& problem_;
  const WaveModes& modes_;
  const LoadTransform& load_;
  double t_;
};

/// Fields of a full wave per unit of load: what errors and cancellations are measured by.
FourSums unit_fields(const Problem& problem);

}  // namespace porowave::reference
