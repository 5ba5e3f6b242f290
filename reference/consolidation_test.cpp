#include "reference/consolidation.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <numbers>

#include "reference/field_fixtures.hpp"
#include "reference/limits_fixtures.hpp"
#include "reference/problem/errors.hpp"
#include "reference/problem/problem_fixtures.hpp"
#include "reference/waves.hpp"

BOOST_AUTO_TEST_SUITE(consolidation)

using namespace porowave;
using namespace porowave::reference;
using namespace porowave::fixtures;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double length = 0.1;
constexpr std::array<NearEnd, 2> near_ends = {NearEnd::drained_traction, NearEnd::fluid_pressure};

Problem problem_of(const Material& m, NearEnd near, const Load& load) {
  return {m, {length, near, FarEnd::rigid_sealed}, load};
}

/// dq/dt of a load of magnitude 1.
double unit_rate(LoadShape shape, double t, double T) {
  const double z = t / T;
  if (shape == LoadShape::smooth_ramp) return 30.0 / T * z * z * (1 - z) * (1 - z);
  const double sine = std::sin(pi * z);
  return 4.0 * pi / T * sine * sine * sine * std::cos(pi * z);
}

/// L^2/c_v
double consolidation_time(const Material& m) {
  return length * length / wave_scales(m).consolidation;
}

}  // namespace

BOOST_AUTO_TEST_CASE(early_under_a_step_the_column_is_a_half_space) {
  // p = K/(E + K) q erf(x/(2 sqrt(c_v t))) as long as the far end does not know.
  const Problem problem =
      problem_of(paper_material(), NearEnd::drained_traction, Load(LoadShape::step, 3.0));
  const double undrained = 3.0 * 5.5e9 / 10.5e9;
  for (const double time : {1e-6, 1e-4, 1e-3}) {
    const double t = time * consolidation_time(problem.material);
    for (const double depth : {0.0, 0.3, 1.0, 3.0, 8.0}) {
      const double x = depth * 2.0 * std::sqrt(time) * length;
      const Fields fields = consolidating(problem, x, t);
      BOOST_TEST(std::abs(fields.pore_pressure - undrained * std::erf(depth)) < 1e-12);
      BOOST_TEST(std::abs(fields.effective_stress - (fields.pore_pressure - 3.0)) < 1e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(in_the_end_the_skeleton_carries_the_load) {
  for (const NearEnd near : near_ends) {
    const Problem problem = problem_of(paper_material(), near, Load(LoadShape::step, 3.0));
    const Fields end = consolidating(problem, 0.07, 30.0 * consolidation_time(problem.material));
    const double held = near == NearEnd::fluid_pressure ? 3.0 : 0.0;
    BOOST_TEST(std::abs(end.pore_pressure - held) < 1e-14);
    BOOST_TEST(std::abs(end.effective_stress - (held - 3.0)) < 1e-14);
    BOOST_TEST(std::abs(end.solid_velocity) < 1e-24);
    BOOST_TEST(std::abs(end.fluid_velocity) < 1e-24);
  }
}

BOOST_AUTO_TEST_CASE(loads_superpose_from_steps) {
  // Duhamel's integral of the step's pressures, by Gauss-Legendre panels.
  using Rule = boost::math::quadrature::gauss<double, 30>;
  const double T = 0.4 * consolidation_time(paper_material());
  const double x = 0.6 * length;
  for (const NearEnd near : near_ends) {
    const Problem step = problem_of(paper_material(), near, Load(LoadShape::step, 1.0));
    for (const LoadShape shape : {LoadShape::smooth_ramp, LoadShape::sin4_pulse}) {
      const Problem problem = problem_of(paper_material(), near, Load(shape, 3.0, T));
      for (const double t : {0.3 * T, 0.8 * T, 1.5 * T}) {
        const auto integrand = [&](double when) {
          return 3.0 * unit_rate(shape, when, T) * consolidating(step, x, t - when).pore_pressure;
        };
        constexpr int panels = 20;
        const double width = std::min(t, T) / panels;
        double pressure = 0.0;
        for (int i = 0; i < panels; ++i) {
          pressure += Rule::integrate(integrand, i * width, (i + 1) * width);
        }
        BOOST_TEST(std::abs(consolidating(problem, x, t).pore_pressure - pressure) < 1e-11);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(mass_is_kept_and_the_fluid_obeys_darcy) {
  // dsigma'/dt = E v_s', dp/dt = -K (n_s v_s' + n_f v_f'), n_f (v_f - v_s) = -kappa/mu p', and
  // nothing moves at the far end. Difference quotients of fourth order.
  const Material m = paper_material();
  const double T = 0.4 * consolidation_time(m);
  for (const NearEnd near : near_ends) {
    for (const LoadShape shape : {LoadShape::smooth_ramp, LoadShape::sin4_pulse}) {
      const Problem problem = problem_of(m, near, Load(shape, 1.0, T));
      for (const double t : {0.3 * T, 0.8 * T, 1.5 * T}) {
        const double x = 0.37 * length;
        const Four by_x =
            derivative([&](double dx) { return consolidating(problem, x + dx, t); }, 1e-3 * length);
        const Four by_t =
            derivative([&](double dt) { return consolidating(problem, x, t + dt); }, 1e-3 * T);
        const Fields here = consolidating(problem, x, t);
        const double mixture = m.solid_fraction() * by_x[solid] + m.porosity * by_x[fluid];
        const double flow = m.porosity * (here.fluid_velocity - here.solid_velocity);
        BOOST_TEST(std::abs(by_t[stress] - m.constrained_modulus * by_x[solid]) < 1e-7 / T);
        BOOST_TEST(std::abs(by_t[pressure] + m.storage_modulus() * mixture) < 1e-7 / T);
        const double mobility = m.intrinsic_permeability / m.fluid_viscosity;
        BOOST_TEST(std::abs(flow + mobility * by_x[pressure]) < 1e-7 * mobility / length);
        const Fields end = consolidating(problem, length, t);
        BOOST_TEST(std::abs(end.solid_velocity) + std::abs(end.fluid_velocity) <
                   1e-10 * std::abs(flow));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(slow_loading_is_consolidation) {
  // With c_v T/L^2 fixed, inertia is (L/(c T))^2 of the forces, c the undrained speed, as is
  // 1/(theta T): second order in L/(c T). Velocities are themselves O(L/(c T)): third order.
  const Material m = paper_material();
  for (const NearEnd near : near_ends) {
    const Fall fall({0.1, 0.05, 0.02, 0.01}, [&](double crossing_over_duration) {
      const double T = length / m.undrained_speed() / crossing_over_duration;
      Problem problem = problem_of(m, near, Load(LoadShape::sin4_pulse, 3.0, T));
      problem.material.intrinsic_permeability *= 0.5 * consolidation_time(m) / T;
      const double x = 0.4 * length;
      return deviation(problem, consolidating(problem, x, 0.4 * T), x, 0.4 * T);
    });
    BOOST_TEST_MESSAGE("slow loading, " << name(near) << ": orders" << fall.orders());
    for (const std::size_t f : {stress, pressure}) {
      BOOST_TEST(std::abs(fall.order(1, f) - 2.0) < 0.1);
      BOOST_TEST(std::abs(fall.order(f) - 2.0) < 0.03);
      BOOST_TEST(fall.smallest(f) < 1e-3);
    }
    for (const std::size_t f : {solid, fluid}) {
      BOOST_TEST(std::abs(fall.order(1, f) - 3.0) < 0.2);
      BOOST_TEST(std::abs(fall.order(f) - 3.0) < 0.06);
      BOOST_TEST(fall.smallest(f) < 2e-4);
    }
  }
}

BOOST_AUTO_TEST_CASE(long_after_a_step_on_soft_soil_there_is_only_consolidation) {
  // In a soil this soft the undrained wave has long been damped when consolidation is under way.
  // What is left falls as 1/(theta t), for velocities times their own O((theta t)^-1/2).
  Material m = paper_material();
  m.constrained_modulus = 1e7;
  const WaveScales scales = wave_scales(m);
  const Fall fall({1.0 / 20, 1.0 / 50, 1.0 / 100, 1.0 / 200}, [&](double inverse_drag) {
    // c_v theta does not depend on permeability; c_v t/L^2 is kept at 0.2.
    const double invariant = scales.consolidation * scales.relaxation_rate;
    const double t = length * std::sqrt(0.2 / (invariant * inverse_drag));
    const Problem problem = problem_of(with_drag(m, 1.0 / inverse_drag, t),
                                       NearEnd::drained_traction, Load(LoadShape::step, 3.0));
    return deviation(problem, consolidating(problem, 0.04, t), 0.04, t);
  });
  BOOST_TEST_MESSAGE("long after a step: orders" << fall.orders());
  for (const std::size_t f : {stress, pressure}) BOOST_TEST(std::abs(fall.order(f) - 1.0) < 0.06);
  for (const std::size_t f : {solid, fluid}) BOOST_TEST(std::abs(fall.order(f) - 1.5) < 0.06);
}

BOOST_AUTO_TEST_CASE(what_does_not_consolidate_is_refused) {
  const auto refused = [](NearEnd near, FarEnd far, const Load& load) {
    const Problem problem{paper_material(), {length, near, far}, load};
    BOOST_CHECK_THROW(consolidating(problem, 0.05, 1e-3), InputError);
  };
  const Load step(LoadShape::step, 1.0);
  refused(NearEnd::velocity, FarEnd::rigid_sealed, step);
  refused(NearEnd::sealed_traction, FarEnd::rigid_sealed, step);
  refused(NearEnd::drained_traction, FarEnd::free_drained, step);
  refused(NearEnd::drained_traction, FarEnd::rigid_sealed, Load(LoadShape::ricker, 1.0, 1.0));
}

BOOST_AUTO_TEST_SUITE_END()
