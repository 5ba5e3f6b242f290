#pragma once

// The support of a moving least squares evaluation, fixed or adaptive.
//
// Adaptive (proposed in the outlook of Chmelnizkij 2023): every evaluation point by itself starts
// from `radius` and enlarges it by `support_growth` until the points within reach carry the basis
// at its full order with a condition (moment_matrix.hpp) of at most `well_conditioned`, or until
// `largest`. If nothing up to there is good, the radius with the highest order and then the
// smallest condition counts: the order falls only where nothing else is left.
//
// The condition says more than whether M can be inverted: it is that of an extrapolation. Points on
// one side of x and next to it (the end of a column) give about 3 for the linear basis, points on
// one side and a gap of h away tens to hundreds. The limits below let the first pass and make the
// second reach across the gap.

#include <algorithm>

#include "solver/mls.hpp"

namespace porowave::solver {

// Fine enough that a gap is bridged by the support that it needs and little more.
inline constexpr double support_growth = 1.2;
// Enough for a hole of eight or nine elements between well filled ones.
inline constexpr double largest_adaptive_radius = 5.0;  // in element lengths

// For the condition of an adaptive support: 1, 10, 100 for orders 0, 1, 2. Smaller limits (4 for
// order 1) enlarge at the ends of the column in vain, much larger ones (1e4) let a gap of three
// elements be extrapolated from one side: measured in verification/adaptive_support_test.cpp.
constexpr double well_conditioned_limit(int basis_order) {
  double limit = 1.0;
  for (int order = 0; order < basis_order; ++order) limit *= 10.0;
  return limit;
}

struct Support {
  double radius;                  // > 0, in the unit of the coordinates
  double largest;                 // >= radius; equal to it: a fixed support
  double well_conditioned = 1.0;  // >= 1; without effect on a fixed support

  Support(double fixed) : radius(fixed), largest(fixed) {}  // NOLINT: a radius is a support
  Support(double radius_, double largest_, double well_conditioned_)
      : radius(radius_), largest(largest_), well_conditioned(well_conditioned_) {}
};

// Calls evaluate(radius), which gives an MlsResult, for growing radii. Gives the first good radius,
// or else the best one; the last call is always the one at the radius given.
template <class F>
double grow_support(const Support& support, int order, F&& evaluate) {
  MlsResult best;
  double best_radius = support.radius;
  for (double radius = support.radius;;
       radius = std::min(radius * support_growth, support.largest)) {
    const MlsResult result = evaluate(radius);
    const bool is_full = result.order_used == order;
    if (is_full && result.condition <= support.well_conditioned) return radius;
    if (result.order_used > best.order_used ||
        (result.order_used == best.order_used && result.condition < best.condition)) {
      best = result;
      best_radius = radius;
    }
    if (radius >= support.largest) {
      if (best_radius < radius) evaluate(best_radius);
      return best_radius;
    }
  }
}

}  // namespace porowave::solver
