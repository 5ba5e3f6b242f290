// Points that move far: a bar across a thousand cells, and manufactured motions in finite strain.

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <utility>

#include "solver/moving/bar_solver.hpp"
#include "verification/manufactured/bar_motion.hpp"
#include "verification/norms.hpp"

BOOST_AUTO_TEST_SUITE(moving_bar)

using namespace porowave;
using namespace porowave::verification;
using namespace porowave::solver;

namespace {

const NeoHookean rubber{3e5, 4e5};
constexpr double density = 1000.0;

template <class Kernel>
Discretization choice(int elements, Strain strain) {
  Discretization d;
  d.elements = elements;
  d.kernel = kernel_name<Kernel>;
  d.support_radius = Kernel::natural_radius;
  d.strain = strain;
  return d;
}

// ---- manufactured motions -----------------------------------------------------------------------

enum class Ends { held, free };

/// Held: displacements up to 15 % of the length in the middle, stretches 0.57 to 1.43. Free: both
/// ends run across the grid, by 9 % and 32 % of the length, stretches up to 1.33.
BarMotion motion(Ends ends) {
  BarMotion m;
  m.length = 1.0;
  m.density = density;
  m.law = rubber;
  m.duration = m.length / std::sqrt(1e6 / density);  // of the order of the wave's passage
  if (ends == Ends::held) {
    m.bulge = 0.15;
  } else {
    m.shift = 0.2;
    m.wave = -0.1;
    m.stretch = 0.05;
  }
  return m;
}

/// Relative L2 errors.
struct Errors {
  std::array<double, 4> of;
};
constexpr std::array<const char*, 4> names{"stress at points", "velocity at points",
                                           "stress of the field", "velocity of the field"};

Errors errors_of(const BarMotion& m, const BarSnapshot& now) {
  const double t = now.time;
  const auto exact = [&](const std::vector<double>& x, auto&& field) {
    std::vector<double> values;
    for (const double place : x) values.push_back(field(m.undeformed_place(place, t)));
    return values;
  };
  const auto stress = [&](double X) { return m.stress(X, t); };
  const auto velocity = [&](double X) { return m.velocity(X, t); };
  const std::vector<double> equal(now.node_x.size(), 1.0);
  return {{relative_norms(now.stress, exact(now.x, stress), now.volume).l2,
           relative_norms(now.velocity, exact(now.x, velocity), now.volume).l2,
           relative_norms(now.cell_stress, exact(now.cell_x, stress), now.cell_length).l2,
           relative_norms(now.node_velocity, exact(now.node_x, velocity), equal).l2}};
}

/// Courant number 0.5 or a little less, to 0.8 of the duration, where everything moves.
Errors run(const BarMotion& m, Ends ends, const Discretization& d) {
  const double end = 0.8 * m.duration;
  const double longest = 0.5 * m.length / d.elements / m.fastest_wave();
  const long steps = std::lround(std::ceil(end / longest));
  BarSolver solver(m.bar(ends == Ends::held), d, end / static_cast<double>(steps));
  for (long i = 0; i < steps; ++i) solver.step();
  return errors_of(m, solver.snapshot());
}

using Levels = std::array<Errors, 4>;
constexpr std::array<int, 4> elements{100, 200, 400, 800};

Levels refine(Ends ends, Discretization d) {
  Levels levels;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    d.elements = elements[k];
    levels[k] = run(motion(ends), ends, d);
  }
  for (std::size_t f = 0; f < 4; ++f) {
    BOOST_TEST_MESSAGE((ends == Ends::held ? "held, " : "free, ")
                       << to_string(d.kernel) << (d.strain == Strain::cell ? ", cell" : "") << ", "
                       << names[f] << ": errors " << levels[0].of[f] << " " << levels[1].of[f]
                       << " " << levels[2].of[f] << " " << levels[3].of[f] << ", orders "
                       << std::log2(levels[0].of[f] / levels[1].of[f]) << " "
                       << std::log2(levels[1].of[f] / levels[2].of[f]) << " "
                       << std::log2(levels[2].of[f] / levels[3].of[f]));
  }
  return levels;
}

// ---- translation --------------------------------------------------------------------------------

struct Drift {
  double velocity;  ///< largest relative change at points and nodes
  double stress;
  double cells;  ///< by which the bar has moved
};

/// A stretched bar of 40 cells, its ends under the stress that keeps the stretch, flies at a share
/// of its wave speed until it has passed 1,000 cells.
Drift fly(const Discretization& d, double share_of_wave_speed, int xpic_order) {
  const double stretch = 1.1;
  const double c = wave_speed(rubber, stretch, density);
  const double v = share_of_wave_speed * c;
  const double sigma = rubber.stress(stretch);
  Bar bar;
  bar.near = 0.37;
  bar.far = bar.near + d.elements;  // h = 1
  bar.density = density;
  bar.law = rubber;
  bar.near_end.stress = bar.far_end.stress = [=](double) { return sigma; };
  bar.initial_stretch = [=](double) { return stretch; };
  bar.initial_velocity = [=](double, double) { return v; };
  BarSolver solver(bar, d, 0.5 / c, xpic_order);
  const long steps = std::lround(std::ceil(1000.0 / (0.5 * share_of_wave_speed)));
  for (long i = 0; i < steps; ++i) solver.step();
  const BarSnapshot now = solver.snapshot();
  Drift drift{0.0, 0.0, now.near - bar.near};
  const auto largest = [](double& worst, const std::vector<double>& values, double expected) {
    for (const double value : values) {
      const double change = std::abs(value / expected - 1.0);
      if (!(change <= worst)) worst = change;
    }
  };
  largest(drift.velocity, now.velocity, v);
  largest(drift.velocity, now.node_velocity, v);
  largest(drift.stress, now.stress, sigma);
  largest(drift.stress, now.cell_stress, sigma);
  return drift;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_flight_across_a_thousand_cells_keeps_velocity_and_stress) {
  const auto check = [](const char* name, Discretization d, Placement placement, double speed,
                        int xpic_order) {
    d.placement = placement;
    const Drift drift = fly(d, speed, xpic_order);
    BOOST_TEST_MESSAGE(name << ", at " << speed << " of the wave speed: " << drift.cells
                            << " cells, velocity changed by " << drift.velocity << ", stress by "
                            << drift.stress);
    BOOST_TEST(drift.cells > 999.999);
    BOOST_TEST(drift.velocity < 1e-11);
    BOOST_TEST(drift.stress < 1e-11);
  };
  const auto regular = Placement::uniform;
  check("bspline1, recovered", choice<BSpline1>(40, Strain::recovered), regular, 0.5, 0);
  check("bspline2, cell", choice<BSpline2>(40, Strain::cell), regular, 0.5, 0);
  check("bspline2, recovered", choice<BSpline2>(40, Strain::recovered), regular, 0.5, 0);
  check("wendland_c2, recovered", choice<WendlandC2>(40, Strain::recovered), regular, 0.5, 0);
  check("bspline2, recovered, random points", choice<BSpline2>(40, Strain::recovered),
        Placement::stratified, 0.5, 0);
  check("bspline3, recovered, XPIC", choice<BSpline3>(40, Strain::recovered), regular, 0.1, 2);
}

BOOST_AUTO_TEST_CASE(manufactured_finite_strain_converges_with_order_two) {
  const std::array<std::pair<Ends, Discretization>, 2> cases{
      std::pair(Ends::held, choice<BSpline1>(0, Strain::recovered)),
      std::pair(Ends::free, choice<BSpline2>(0, Strain::recovered))};
  for (const auto& [ends, d] : cases) {
    const Levels levels = refine(ends, d);
    for (std::size_t f = 0; f < 4; ++f) {
      for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
        BOOST_TEST_CONTEXT(names[f] << ", " << elements[k] << " cells") {
          const double order = std::log2(levels[k].of[f] / levels[k + 1].of[f]);
          BOOST_TEST(order >= 1.9);
          BOOST_TEST(order <= 2.1);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
