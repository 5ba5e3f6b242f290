// The manufactured column without any solver: the governing equations by difference quotients of
// its four fields.

#include "verification/manufactured/two_phase_motion.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "reference/problem/problem_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(two_phase_motion)

using namespace porowave;
using namespace porowave::verification;

namespace {

constexpr double length = 0.1;
constexpr double strain = 1e-6;

TwoPhaseMotion motion(NearEnd near, double permeability) {
  Material m = fixtures::paper_material();
  m.intrinsic_permeability = permeability;
  return {m, length, near, strain};
}

/// Central difference quotient of fourth order of one field.
template <class F>
double slope(F&& f, double at, double step, double Fields::*field) {
  return (8.0 * (f(at + step).*field - f(at - step).*field) -
          (f(at + 2 * step).*field - f(at - 2 * step).*field)) /
         (12.0 * step);
}

/// All that the equations are made of, at one place and time.
struct Terms {
  double solid_inertia, fluid_inertia, stress_slope, pressure_slope, drag;
  double solid_strain_rate, fluid_strain_rate, stress_rate, pressure_rate;
  solver::PhaseForces force;
};

Terms terms(const TwoPhaseMotion& motion, double x, double t) {
  const Material& m = motion.problem().material;
  const auto in_time = [&](double s) { return motion.fields(x, s); };
  const auto in_place = [&](double y) { return motion.fields(y, t); };
  const double dx = 1e-3 * length;
  const double dt = 1e-3 * motion.time_scale();
  const Fields now = motion.fields(x, t);
  const double seepage = now.fluid_velocity - now.solid_velocity;
  return {m.solid_partial_density() * slope(in_time, t, dt, &Fields::solid_velocity),
          m.fluid_partial_density() * slope(in_time, t, dt, &Fields::fluid_velocity),
          slope(in_place, x, dx, &Fields::effective_stress),
          slope(in_place, x, dx, &Fields::pore_pressure),
          -m.porosity * m.porosity * m.fluid_viscosity / m.intrinsic_permeability * seepage,
          slope(in_place, x, dx, &Fields::solid_velocity),
          slope(in_place, x, dx, &Fields::fluid_velocity),
          slope(in_time, t, dt, &Fields::effective_stress),
          slope(in_time, t, dt, &Fields::pore_pressure),
          motion.body_force(x, t)};
}

template <class Check>
void for_all(Check&& check) {
  for (const NearEnd near : {NearEnd::velocity, NearEnd::drained_traction}) {
    for (const double permeability : {1e-10, 1e-11, 1e-13, 1e-15}) {
      const TwoPhaseMotion m = motion(near, permeability);
      for (const double x : {0.011, 0.034, 0.052, 0.088}) {
        for (const double t : {0.0, 0.7, 2.1}) {
          BOOST_TEST_CONTEXT(name(near) << ", permeability " << permeability << ", x = " << x) {
            check(m, terms(m, x, t * m.time_scale()));
          }
        }
      }
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(momentum_of_both_phases_is_balanced) {
  for_all([](const TwoPhaseMotion& motion, const Terms& of) {
    const Material& m = motion.problem().material;
    const double ns = 1.0 - m.porosity;
    const double scale = m.constrained_modulus * strain / length;
    const double solid = of.solid_inertia - of.stress_slope + ns * of.pressure_slope + of.drag;
    const double fluid = of.fluid_inertia + m.porosity * of.pressure_slope - of.drag;
    BOOST_TEST(std::abs(solid - of.force.solid) < 1e-8 * scale);
    BOOST_TEST(std::abs(fluid - of.force.fluid) < 1e-8 * scale);
  });
}

BOOST_AUTO_TEST_CASE(stress_and_pressure_follow_the_strain_rates) {
  for_all([](const TwoPhaseMotion& motion, const Terms& of) {
    const Material& m = motion.problem().material;
    const double scale = m.constrained_modulus * strain / motion.time_scale();
    BOOST_TEST(std::abs(of.stress_rate - m.constrained_modulus * of.solid_strain_rate) <
               1e-8 * scale);
    const double squeezed =
        (1.0 - m.porosity) * of.solid_strain_rate + m.porosity * of.fluid_strain_rate;
    BOOST_TEST(std::abs(of.pressure_rate + m.fluid_bulk_modulus / m.porosity * squeezed) <
               1e-8 * scale);
  });
}

BOOST_AUTO_TEST_CASE(every_term_is_at_work) {
  // A mistake in one term is seen only if the term is not small beside the others.
  for (const NearEnd near : {NearEnd::velocity, NearEnd::drained_traction}) {
    for (const double permeability : {1e-11, 1e-13, 1e-15}) {
      const TwoPhaseMotion m = motion(near, permeability);
      std::array<double, 5> largest{};
      for (const double x : {0.011, 0.034, 0.052, 0.088}) {
        for (const double t : {0.0, 0.7, 1.4, 2.1}) {
          const Terms of = terms(m, x, t * m.time_scale());
          const std::array<double, 5> now{of.solid_inertia, of.fluid_inertia, of.stress_slope,
                                          of.pressure_slope, of.drag};
          for (std::size_t k = 0; k < 5; ++k) {
            largest[k] = std::max(largest[k], std::abs(now[k]));
          }
        }
      }
      const double most = *std::max_element(largest.begin(), largest.end());
      for (const double term : largest) BOOST_TEST(term > 0.04 * most);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_ends_are_kept) {
  const TwoPhaseMotion held = motion(NearEnd::velocity, 1e-11);
  const TwoPhaseMotion drained = motion(NearEnd::drained_traction, 1e-11);
  const Fields inside = held.fields(0.3 * length, 0.0);
  const double v = 1e-14 * std::abs(inside.solid_velocity);
  const double s = 1e-13 * std::abs(held.fields(0.1 * length, 0.0).effective_stress);
  for (const double t : {0.0, 1e-5, 3e-5}) {
    for (const double end : {0.0, length}) {
      BOOST_TEST(std::abs(held.fields(end, t).solid_velocity) < 10 * v);
      BOOST_TEST(std::abs(held.fields(end, t).fluid_velocity) < 10 * v);
    }
    BOOST_TEST(std::abs(drained.fields(0.0, t).effective_stress) < s);
    BOOST_TEST(std::abs(drained.fields(0.0, t).pore_pressure) < s);
    BOOST_TEST(std::abs(drained.fields(length, t).solid_velocity) < 10 * v);
    BOOST_TEST(std::abs(drained.fields(length, t).fluid_velocity) < 10 * v);
  }
  BOOST_CHECK_THROW(motion(NearEnd::sealed_traction, 1e-11), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
