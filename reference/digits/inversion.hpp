#pragma once

#include "reference/digits/contours.hpp"

namespace porowave::fixtures::digits {

/// The four fields at a point, for a load of unit magnitude.
using FourReals = std::array<Real50, 4>;

/// Sum of a group of arrivals by the midpoint rule on its contour, in the numbers R, with
/// `refinement` times the nodes that were planned.
template <class R>
FourReals invert(const Point& point, const Group& group, double refinement);

extern template FourReals invert<Real50>(const Point&, const Group&, double);
extern template FourReals invert<Real100>(const Point&, const Group&, double);

/// The fields of a ricker load: the transform of the whole column on a vertical line, where the
/// trapezoidal rule of spacing 2 pi/period gives the sum over all k of
/// e^(-k shift period) fields(t + k period); all but k = 0 are negligible.
FourReals invert_ricker(const Point& point, int variant);

}  // namespace porowave::fixtures::digits
