// Wrong kernels, small types of the same form as those in solver/kernels/.

#include "solver/kernels/bspline1.hpp"
#include "solver/kernels/bspline2.hpp"
#include "solver/kernels/bspline3.hpp"
#include "solver/kernels/wendland_c2.hpp"
#include "solver/kernels/wendland_c4.hpp"
#include "verification/faults/kernel_check.hpp"

namespace porowave::verification::faults {

namespace {

using solver::BSpline1;
using solver::BSpline2;
using solver::BSpline3;
using solver::WendlandC2;
using solver::WendlandC4;

struct DerivativeOfAnother : WendlandC2 {
  static constexpr double derivative(double q) { return WendlandC4::derivative(q); }
};

struct DerivativeOfTheDistance : BSpline2 {
  // d value / dt instead of d value / dq
  static constexpr double derivative(double q) { return BSpline2::derivative(q) / natural_radius; }
};

struct NotNormalised : BSpline3 {
  static constexpr double value(double q) { return 1.5 * BSpline3::value(q); }
  static constexpr double derivative(double q) { return 1.5 * BSpline3::derivative(q); }
};

struct PiecesApart : BSpline2 {
  // The outer piece begins where the inner one has not ended.
  static constexpr double value(double q) {
    const double t = natural_radius * q;
    return t <= 0.5 ? 0.75 - t * t : t < 1.5 ? 0.5 * (1.5 - t) * (1.5 - t) + 0.01 : 0.0;
  }
};

struct BeyondItsSupport : BSpline1 {
  static constexpr double value(double q) { return 1.0 - q; }
  static constexpr double derivative(double) { return -1.0; }
};

struct NegativeLobe : WendlandC2 {
  static constexpr double value(double q) {
    return q < 1.0 ? WendlandC2::value(q) - 0.05 * (1.0 - q) : 0.0;
  }
  static constexpr double derivative(double q) {
    return q < 1.0 ? WendlandC2::derivative(q) + 0.05 : 0.0;
  }
};

}  // namespace

std::vector<Fault> kernel_faults() {
  return {
      {"kernel", "the derivative of another kernel", "derivative is that of the value",
       caught_by_kernel_facts<DerivativeOfAnother>},
      {"kernel", "derivative by the distance, not by its share of the radius",
       "derivative is that of the value", caught_by_kernel_facts<DerivativeOfTheDistance>},
      {"kernel", "a B-spline that is not normalised", "sum up to 1",
       caught_by_kernel_facts<NotNormalised>},
      {"kernel", "pieces of a B-spline that do not join", "zero at the support's end",
       caught_by_kernel_facts<PiecesApart>},
      {"kernel", "a kernel that goes on beyond its support", "zero outside",
       caught_by_kernel_facts<BeyondItsSupport>},
      {"kernel", "a kernel with a negative lobe", "positive inside",
       caught_by_kernel_facts<NegativeLobe>},
  };
}

}  // namespace porowave::verification::faults
