#include "solver/moving/constitutive_law.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(constitutive_law)

using namespace porowave::solver;

namespace {

const std::array<double, 5> stretches{0.4, 0.8, 1.0, 1.3, 2.0};

/// ψ = μ/2 (F² − 1 − 2 ln J) + λ/2 (ln J)², per undeformed volume; P = ∂ψ/∂F = J σ/F = σ.
double neo_hookean_energy(const NeoHookean& law, double stretch) {
  const double log = std::log(stretch);
  return 0.5 * law.shear_modulus * (stretch * stretch - 1.0 - 2.0 * log) +
         0.5 * law.lame_modulus * log * log;
}

template <class F>
double slope(F&& f, double at) {
  const double e = 1e-4 * at;
  return (8.0 * (f(at + e) - f(at - e)) - (f(at + 2 * e) - f(at - 2 * e))) / (12.0 * e);
}

}  // namespace

BOOST_AUTO_TEST_CASE(neo_hookean_stress_is_the_slope_of_its_energy) {
  const NeoHookean law{3e5, 7e5};
  for (const double stretch : stretches) {
    const double expected = slope([&](double f) { return neo_hookean_energy(law, f); }, stretch);
    BOOST_TEST(std::abs(law.stress(stretch) - expected) < 1e-8 * 1e6);
  }
}

BOOST_AUTO_TEST_CASE(stress_slopes_are_those_of_the_stress) {
  for (const ConstitutiveLaw& law :
       {ConstitutiveLaw(NeoHookean{3e5, 7e5}), ConstitutiveLaw(LinearElastic{1.3e6})}) {
    for (const double stretch : stretches) {
      const double expected = slope([&](double f) { return stress(law, f); }, stretch);
      BOOST_TEST(stress_slope(law, stretch) == expected, boost::test_tools::tolerance(1e-9));
    }
  }
}

BOOST_AUTO_TEST_CASE(both_laws_have_the_constrained_modulus_at_rest) {
  const NeoHookean finite{3e5, 7e5};
  const LinearElastic small{1.3e6};
  BOOST_TEST(finite.stress(1.0) == 0.0);
  BOOST_TEST(small.stress(1.0) == 0.0);
  BOOST_TEST(finite.stress_slope(1.0) == small.stress_slope(1.0));
  // The difference is of second order in the strain.
  BOOST_TEST(std::abs(finite.stress(1.0 + 1e-6) - small.stress(1.0 + 1e-6)) < 1e-11 * 1.3e6);
}

BOOST_AUTO_TEST_CASE(stretch_makes_waves_pass_the_grid_faster) {
  // Fixed material speed c: the same wave passes F times as much of the grid.
  const ConstitutiveLaw law = LinearElastic{4e6};
  BOOST_TEST(wave_speed(law, 1.0, 1000.0) == std::sqrt(4e3));
  BOOST_TEST(wave_speed(law, 1.5, 1000.0) == 1.5 * std::sqrt(4e3));
}

BOOST_AUTO_TEST_SUITE_END()
