#include "solver/regular_step.hpp"

#include <algorithm>
#include <array>

#include "solver/simd.hpp"

namespace porowave::solver {

namespace {

// Copies, if their number is known: what is written could not change them, so they can stay in
// registers. Number 0 stands for one that is known only at run time.
template <std::size_t Number>
class Weights {
 public:
  POROWAVE_INLINE explicit Weights(const std::vector<double>& from)
      : all_(from.data()), number_(Number > 0 ? Number : from.size()) {
    std::copy_n(all_, Number, own_.begin());
  }
  POROWAVE_INLINE std::size_t size() const { return Number > 0 ? Number : number_; }
  POROWAVE_INLINE double operator[](std::size_t k) const { return Number > 0 ? own_[k] : all_[k]; }

 private:
  const double* all_;
  std::size_t number_;
  std::array<double, Number + 1> own_{};
};

// Σ_k weights_k (in_k + in_(−k)), in_0 once.
template <std::size_t Number>
POROWAVE_INLINE void sum_of_both_sides(const Weights<Number>& weights, const double* in,
                                       Eight& sum) {
  Eight after, before;
  read(in, after);
  sum = weights[0] * after;
  for (std::size_t k = 1; k < weights.size(); ++k) {
    read(in + k, after);
    read(in - k, before);
    sum += weights[k] * (after + before);
  }
}

// Σ_k weights_k (in_k − in_(−1−k))
template <std::size_t Number>
POROWAVE_INLINE void difference_of_sides(const Weights<Number>& weights, const double* in,
                                         Eight& sum) {
  Eight after, before;
  read(in, after);
  read(in - 1, before);
  sum = weights[0] * (after - before);
  for (std::size_t k = 1; k < weights.size(); ++k) {
    read(in + k, after);
    read(in - 1 - k, before);
    sum += weights[k] * (after - before);
  }
}

POROWAVE_INLINE void change(const RegularStencil::Change& by, const Eight& relative,
                            const Eight& effective, const Eight& pressure, Eight& sum) {
  sum = by.relative * relative + (by.effective * effective + by.pressure * pressure);
}

// v' = v + change, without a product where it would be by one.
POROWAVE_INLINE void update_q(double flip, const double* q, const Eight& v, const Eight& change,
                              double* new_q) {
  Eight value;
  read(q, value);
  if (flip == 1.0) {
    write(value + change, new_q);
  } else {
    write(flip * (value - v) + (v + change), new_q);
  }
}

// What lies behind eight values of `here`.
POROWAVE_INLINE void rise_behind(const Eight& here, const Eight& later, Eight& rise) {
  rise = __builtin_shufflevector(here, later, 1, 2, 3, 4, 5, 6, 7, 8) - here;
}

POROWAVE_INLINE double sum_of(const Eight& values) {
  double sum = 0.0;
  for (int k = 0; k < 8; ++k) sum += values[k];
  return sum;
}

// Backwards, because cells need the new velocity of the node behind them.
template <std::size_t Velocities, std::size_t Forces>
POROWAVE_INLINE RegularResult step_eights(const RegularStencil& stencil, RegularFactors by,
                                          RegularFields at, std::size_t eights, double solid_beyond,
                                          double fluid_beyond) {
  const Weights<Velocities> velocity(stencil.velocity);
  const Weights<Forces> force(stencil.force);
  const RegularStencil::Change of_solid = stencil.solid;
  const RegularStencil::Change of_lag = stencil.lag;
  Eight later_vs = {solid_beyond};
  Eight later_vf = {fluid_beyond};
  Eight solid_squares = {};
  Eight fluid_squares = {};
  RegularResult result;
  for (std::size_t i = 8 * eights; i > 0;) {
    i -= 8;
    Eight vs, vf, effective, pressure, solid_change, fluid_change, solid_rise, fluid_rise, value;
    sum_of_both_sides(velocity, at.solid_q + i, vs);
    sum_of_both_sides(velocity, at.fluid_q + i, vf);
    difference_of_sides(force, at.solid_e + i, effective);
    difference_of_sides(force, at.fluid_e + i, pressure);
    const Eight relative = vf - vs;
    change(of_solid, relative, effective, pressure, solid_change);
    change(of_lag, relative, effective, pressure, fluid_change);
    fluid_change += solid_change;
    update_q(by.flip, at.solid_q + i, vs, solid_change, at.new_solid_q + i);
    update_q(by.flip, at.fluid_q + i, vf, fluid_change, at.new_fluid_q + i);
    vs += solid_change;
    vf += fluid_change;
    solid_squares += vs * vs;
    fluid_squares += vf * vf;
    rise_behind(vs, later_vs, solid_rise);
    rise_behind(vf, later_vf, fluid_rise);
    read(at.solid_e + i, value);
    write(value + by.effective * solid_rise, at.new_solid_e + i);
    read(at.fluid_e + i, value);
    write(value + (by.pressure_solid * solid_rise + by.pressure_fluid * fluid_rise),
          at.new_fluid_e + i);
    if (i + 8 == 8 * eights) {
      result.solid.last = vs[7];
      result.fluid.last = vf[7];
    }
    later_vs = vs;
    later_vf = vf;
  }
  result.solid.first = later_vs[0];
  result.fluid.first = later_vf[0];
  result.solid.squares = sum_of(solid_squares);
  result.fluid.squares = sum_of(fluid_squares);
  return result;
}

}  // namespace

POROWAVE_VECTORISED RegularResult step_regular(const RegularStencil& stencil,
                                               const RegularFactors& factors,
                                               const RegularFields& fields, std::size_t eights,
                                               double solid_beyond, double fluid_beyond) {
  // bspline1, bspline2, and bspline3 or recovered strains; the first one is the shape transfer.
  switch (10 * stencil.velocity.size() + stencil.force.size()) {
    case 21:
      return step_eights<2, 1>(stencil, factors, fields, eights, solid_beyond, fluid_beyond);
    case 22:
      return step_eights<2, 2>(stencil, factors, fields, eights, solid_beyond, fluid_beyond);
    case 32:
      return step_eights<3, 2>(stencil, factors, fields, eights, solid_beyond, fluid_beyond);
    case 33:
      return step_eights<3, 3>(stencil, factors, fields, eights, solid_beyond, fluid_beyond);
    default:
      return step_eights<0, 0>(stencil, factors, fields, eights, solid_beyond, fluid_beyond);
  }
}

}  // namespace porowave::solver
