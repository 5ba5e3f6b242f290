#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "reference/bounded_fields.hpp"

namespace porowave::reference {

/// The saturated column at one time as a sum of its eigenfunctions, as a check of ColumnSolution,
/// with which it shares the statement of the problem only; no Laplace transform is inverted.
///
/// With stresses given at x = 0 and a rigid, sealed end at x = L, stresses are sums of sin(k_n x)
/// and velocities of cos(k_n x), k_n = (n + 1/2) pi/L. Every mode is a 4x4 linear system in time,
/// solved exactly (modal_modes.hpp), whatever the drag. What the load does near x = 0 is taken out
/// of the modes as layers in closed form, and added to their sum.
///
/// Ends: near drained_traction or fluid_pressure, far rigid_sealed. Loads: smooth_ramp, sin4_pulse,
/// ricker; of others the sum over modes converges too slowly. Accuracy: mostly 1e-12 of the load;
/// modes are added until their tail is below `tolerance`, at most 131,072 of them, which short
/// ramps on a slow second wave may not get by with (the error says so).
class ModalSolution {
 public:
  /// tolerance: wanted size of the tail relative to the load, in (0, 1). Throws InputError for
  /// problems that this route cannot do, and for a time or tolerance out of range.
  ModalSolution(const Problem& problem, double t, double tolerance = 1e-12);
  ~ModalSolution();
  ModalSolution(ModalSolution&&) noexcept;
  ModalSolution& operator=(ModalSolution&&) noexcept;

  /// Why this route cannot do a problem, naming what it can; empty if it can.
  static std::string obstacle(const Problem& problem);

  /// Fields at 0 <= x <= length by the sum over all modes, each with an estimate of its error: tail
  /// and rounding. Throws InputError for other x.
  BoundedFields at(double x) const;
  /// Fields at x = j length/intervals, j = 0 ... intervals (at least 1), by FFTW.
  std::vector<BoundedFields> on_grid(int intervals) const;

  std::size_t modes() const;

 private:
  struct State;
  std::unique_ptr<const State> state_;
};

}  // namespace porowave::reference
