#include "solver/regular_step.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "solver/transfer_fixtures.hpp"

BOOST_AUTO_TEST_SUITE(regular_step)

using namespace porowave::solver;

namespace {

constexpr std::size_t eights = 3;
constexpr std::size_t count = 8 * eights;
constexpr std::size_t margin = 8;  // more than any stencil below reaches
constexpr double untouched = 7.25;
constexpr double solid_beyond = 0.3;
constexpr double fluid_beyond = -0.4;

struct Phase {
  std::vector<double> q, e, new_q, new_e;

  explicit Phase(unsigned seed)
      : q(test::noise(count + 2 * margin, seed)),
        e(test::noise(count + 2 * margin, seed + 1)),
        new_q(q.size(), untouched),
        new_e(q.size(), untouched) {}
};

RegularStencil some_stencil(std::size_t velocities, std::size_t forces) {
  return {test::noise(velocities, 3), test::noise(forces, 4), {0.3, -0.7, 0.2}, {-0.1, 0.4, 0.6}};
}

// As the header says it, value by value, at index i of the arrays.
double velocity(const RegularStencil& stencil, const Phase& phase, std::size_t i) {
  double v = stencil.velocity[0] * phase.q[i];
  for (std::size_t k = 1; k < stencil.velocity.size(); ++k) {
    v += stencil.velocity[k] * phase.q[i + k] + stencil.velocity[k] * phase.q[i - k];
  }
  return v;
}

double force(const RegularStencil& stencil, const Phase& phase, std::size_t i) {
  double f = 0.0;
  for (std::size_t k = 0; k < stencil.force.size(); ++k) {
    f += stencil.force[k] * phase.e[i + k] - stencil.force[k] * phase.e[i - 1 - k];
  }
  return f;
}

double change(const RegularStencil::Change& by, double relative, double effective,
              double pressure) {
  return by.relative * relative + by.effective * effective + by.pressure * pressure;
}

void check_velocities(const RegularVelocities& found, const std::vector<double>& expected) {
  double squares = 0.0;
  for (std::size_t k = 0; k < count; ++k) squares += expected[k] * expected[k];
  BOOST_TEST(std::abs(found.first - expected[0]) < 1e-14);
  BOOST_TEST(std::abs(found.last - expected[count - 1]) < 1e-14);
  BOOST_TEST(std::abs(found.squares - squares) < 1e-13 * squares);
}

void check_step(const RegularStencil& stencil, const RegularFactors& by) {
  Phase solid(10);
  Phase fluid(20);
  const auto at = [](std::vector<double>& values) { return values.data() + margin; };
  const RegularResult result =
      step_regular(stencil, by,
                   {at(solid.q), at(fluid.q), at(solid.e), at(fluid.e), at(solid.new_q),
                    at(fluid.new_q), at(solid.new_e), at(fluid.new_e)},
                   eights, solid_beyond, fluid_beyond);
  Phase solid_expected(10);
  Phase fluid_expected(20);
  std::vector<double> vs, vf;
  for (std::size_t i = margin; i < margin + count; ++i) {
    const double before_s = velocity(stencil, solid, i);
    const double before_f = velocity(stencil, fluid, i);
    const double relative = before_f - before_s;
    const double effective = force(stencil, solid, i);
    const double pressure = force(stencil, fluid, i);
    vs.push_back(before_s + change(stencil.solid, relative, effective, pressure));
    vf.push_back(vs.back() + relative + change(stencil.lag, relative, effective, pressure));
    solid_expected.new_q[i] = by.flip * (solid.q[i] - before_s) + vs.back();
    fluid_expected.new_q[i] = by.flip * (fluid.q[i] - before_f) + vf.back();
  }
  vs.push_back(solid_beyond);
  vf.push_back(fluid_beyond);
  for (std::size_t k = 0; k < count; ++k) {
    const double solid_rise = vs[k + 1] - vs[k];
    const double fluid_rise = vf[k + 1] - vf[k];
    const std::size_t c = margin + k;
    solid_expected.new_e[c] = solid.e[c] + by.effective * solid_rise;
    fluid_expected.new_e[c] =
        fluid.e[c] + by.pressure_solid * solid_rise + by.pressure_fluid * fluid_rise;
  }
  // The values around those of the nodes stay as they were.
  BOOST_TEST(test::largest_difference(solid.new_q, solid_expected.new_q) < 2e-14);
  BOOST_TEST(test::largest_difference(fluid.new_q, fluid_expected.new_q) < 2e-14);
  BOOST_TEST(test::largest_difference(solid.new_e, solid_expected.new_e) < 2e-14);
  BOOST_TEST(test::largest_difference(fluid.new_e, fluid_expected.new_e) < 2e-14);
  check_velocities(result.solid, vs);
  check_velocities(result.fluid, vf);
}

}  // namespace

BOOST_AUTO_TEST_CASE(is_what_its_definition_says) {
  for (std::size_t velocities = 1; velocities <= 7; ++velocities) {
    for (std::size_t forces = 1; forces <= 7; ++forces) {
      for (const double flip : {1.0, 0.9, 0.0}) {
        BOOST_TEST_CONTEXT(velocities << " and " << forces << " weights, flip " << flip) {
          check_step(some_stencil(velocities, forces), {flip, 0.8, -0.3, 0.5});
        }
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
