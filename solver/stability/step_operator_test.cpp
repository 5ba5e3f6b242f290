#include "solver/stability/step_operator.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "reference/problem/errors.hpp"
#include "reference/problem/problem_fixtures.hpp"
#include "solver/column_fixtures.hpp"
#include "solver/stability/galerkin_step.hpp"
#include "solver/staggered/staggered_solver.hpp"

BOOST_AUTO_TEST_SUITE(step_operator)

using namespace porowave;
using namespace porowave::solver;

namespace {

constexpr int elements = 20;

Case paper_case() {
  Case scene;
  scene.problem = fixtures::paper_problem();
  scene.discretization.elements = elements;
  scene.discretization.placement = Placement::stratified;
  scene.time.courant = 0.4;
  scene.time.end = 2e-5;
  return scene;
}

std::vector<double> noise(std::size_t size, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  std::vector<double> values(size);
  for (double& value : values) value = normal(generator);
  return values;
}

double largest(const std::vector<double>& values) {
  double size = 0.0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return size;
}

StepLoad load_of_step(const Problem& problem, long step, double dt) {
  const double t = dt * static_cast<double>(step);
  return {problem.load.mean(t - 0.5 * dt, t + 0.5 * dt), problem.load.value(t - 0.5 * dt),
          problem.load.value(t + 0.5 * dt)};
}

// What points hold whose velocities are q at the nodes and whose cells have these stresses.
PointValues held(const ColumnOperators& operators, const std::vector<double>& q,
                 const std::vector<double>& stress, double h) {
  const std::size_t points = operators.points_of({0, stress.size()}).last;
  PointValues values{std::vector<double>(points), std::vector<double>(points), {}};
  std::vector<double> stairs{0.0};
  for (const double s : stress) stairs.push_back(stairs.back() + h * s);
  const std::vector<double> none(q.size(), 0.0);
  operators.scatter({0.0, none.data(), q.data(), stairs.data(), 1.0}, {0, stress.size()}, values);
  return values;
}

// Largest difference of the stresses of points after some steps from rest, as a share of the
// load's, between the operator and the solver.
double difference_from_run(const Case& scene) {
  ColumnSolver solver(scene);
  const GalerkinStep galerkin(scene);
  const auto step = galerkin.loaded(solver.time_step());
  std::vector<double> state(galerkin.size(), 0.0), next(galerkin.size());
  double difference = 0.0;
  for (long n = 0; n < 25; ++n) {
    step(state, load_of_step(scene.problem, n, solver.time_step()), next);
    state.swap(next);
    solver.step();
    const Snapshot now = solver.snapshot();
    const CarriedFields fields = galerkin.fields(state);
    const double h = fields.node_x[1];
    const auto of_solid =
        held(solver.operators(Phase::solid), fields.solid_velocity, fields.effective_stress, h);
    const auto of_fluid =
        held(solver.operators(Phase::fluid), fields.fluid_velocity, fields.pore_pressure, h);
    difference = std::max({difference, test::largest_difference(of_solid.stress, now.solid.stress),
                           test::largest_difference(of_fluid.stress, now.fluid.stress)});
  }
  return difference / scene.problem.stress_scale();
}

std::vector<Discretization> every_transfer() {
  auto choices = test::column_choices();
  for (const TransferName transfer : {TransferName::shape, TransferName::apic}) {
    for (std::size_t k = 0; k < shape_count; ++k) {
      Discretization d;
      d.transfer = transfer;
      d.shape = ShapeName{k};
      const auto word = to_string(d.shape);
      if (transfer == TransferName::apic && (word == "gimp" || word == "cpgimp")) continue;
      choices.push_back(d);
    }
  }
  return choices;
}

Case with(const Discretization& transfer) {
  Case scene = paper_case();
  const Discretization placed = scene.discretization;
  scene.discretization = transfer;
  scene.discretization.elements = elements;
  scene.discretization.placement = placed.placement;
  scene.discretization.points_per_element = 3;
  if (transfer.transfer == TransferName::apic) scene.time.flip = 0.0;
  return scene;
}

double superposition_error(const StepOperator& step, double dt) {
  const LinearMap map = step.at(dt);
  const auto x = noise(map.size, 1), y = noise(map.size, 2);
  std::vector<double> sum(map.size), ax(map.size), ay(map.size), of_sum(map.size);
  for (std::size_t i = 0; i < map.size; ++i) sum[i] = 3.0 * x[i] - 2.0 * y[i];
  map.apply(x, ax);
  map.apply(y, ay);
  map.apply(sum, of_sum);
  for (std::size_t i = 0; i < map.size; ++i) of_sum[i] -= 3.0 * ax[i] - 2.0 * ay[i];
  return largest(of_sum) / largest(ax);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_run_from_rest_repeats_the_operator_for_every_transfer) {
  for (const Discretization& transfer : every_transfer()) {
    BOOST_TEST_CONTEXT(transfer_names[static_cast<std::size_t>(transfer.transfer)]
                       << ' ' << kernel_word(transfer) << ' ' << test::strain_title(transfer)) {
      BOOST_TEST(difference_from_run(with(transfer)) < 1e-11);
    }
  }
}

BOOST_AUTO_TEST_CASE(so_it_does_for_every_velocity_update_and_end) {
  for (const double flip : {1.0, 0.9, 0.0}) {
    Case scene = paper_case();
    scene.time.flip = flip;
    BOOST_TEST(difference_from_run(scene) < 1e-11, "flip " << flip);
  }
  for (const int order : {1, 2, 5}) {
    Case scene = paper_case();
    scene.time.xpic_order = order;
    BOOST_TEST(difference_from_run(scene) < 1e-11, "xpic " << order);
  }
  for (std::size_t near = 0; near < near_end_names.size(); ++near) {
    for (std::size_t far = 0; far < 3; ++far) {
      Case scene = paper_case();
      scene.problem.column.near = static_cast<NearEnd>(near);
      scene.problem.column.far = static_cast<FarEnd>(far);
      scene.problem.material.intrinsic_permeability = 1e-9;
      scene.problem.load = Load(LoadShape::step, 1e-4);  // small enough for points to stay
      BOOST_TEST(difference_from_run(scene) < 1e-11,
                 near_end_names[near] << ", " << far_end_names[far]);
    }
  }
}

BOOST_AUTO_TEST_CASE(so_it_does_where_a_node_has_one_phase_only) {
  Case scene = paper_case();
  scene.discretization.placement = Placement::random;
  scene.discretization.points_per_element = 1;
  scene.discretization.kernel = kernel_name<BSpline1>;
  scene.discretization.support_radius = 1.0;
  int met = 0;
  for (scene.discretization.seed = 1; scene.discretization.seed <= 30;
       ++scene.discretization.seed) {
    try {
      const ColumnSolver solver(scene);
      if (solver.empty_rows() == 0) continue;
      BOOST_TEST(difference_from_run(scene) < 1e-10, "seed " << scene.discretization.seed);
      ++met;
    } catch (const BreakdownError&) {
      continue;  // no point at the loaded end
    }
  }
  BOOST_TEST(met > 2);
}

BOOST_AUTO_TEST_CASE(a_long_column_is_probed_as_a_short_one) {
  // Beyond some 20 nodes those far apart are probed together.
  Case scene = paper_case();
  scene.discretization.elements = 300;
  scene.time.courant = 0.05;
  BOOST_TEST(difference_from_run(scene) < 1e-11);
  scene.discretization.kernel = kernel_name<WendlandC2>;
  scene.discretization.support_radius = 5.0;
  BOOST_TEST(difference_from_run(scene) < 1e-11);
}

BOOST_AUTO_TEST_CASE(staggered4_steps_differences_of_states_by_the_operator) {
  for (const int time_order : {2, 4}) {
    for (std::size_t near = 0; near < near_end_names.size(); ++near) {
      Case scene = paper_case();
      scene.discretization.scheme = Scheme::staggered4;
      scene.discretization.basis_order = 2;
      scene.discretization.kernel = kernel_name<WendlandC2>;
      scene.discretization.support_radius = 2.0;
      scene.problem.column.near = static_cast<NearEnd>(near);
      scene.time.order = time_order;
      StaggeredSolver one(scene), other(scene);
      const auto step = solver::step_operator(scene);
      const LinearMap map = step->at(one.time_step());
      // Differences of states in physical units: the map's state is scaled, number by number.
      const auto x = noise(map.size, 5);
      std::vector<double> after(map.size), scale(map.size);
      const std::size_t nodes = elements + 1, cells = elements;
      const Material& m = scene.problem.material;
      const double rate = std::pow(wave_speeds(m).p1 * elements / *scene.problem.column.length, 2);
      for (std::size_t i = 0; i < map.size; ++i) {
        const bool velocity = i < 2 * nodes, stress = !velocity && i < 2 * (nodes + cells);
        const bool solid = velocity ? i < nodes
                           : stress ? i < 2 * nodes + cells
                                    : i < 3 * nodes + 2 * cells;
        const double density = solid ? m.solid_partial_density() : m.fluid_partial_density();
        const double modulus = solid ? m.constrained_modulus : m.storage_modulus();
        scale[i] = velocity ? 1.0 / std::sqrt(density)
                   : stress ? std::sqrt(modulus)
                            : rate * std::sqrt(density);
      }
      map.apply(x, after);
      std::vector<double> start(map.size);
      for (std::size_t i = 0; i < map.size; ++i) start[i] = scale[i] * x[i];
      one.set_state(std::vector<double>(map.size, 0.0));
      other.set_state(start);
      for (int n = 0; n < 3; ++n) {
        one.step();
        other.step();
        const auto a = one.state(), b = other.state();
        for (std::size_t i = 0; i < map.size; ++i) {
          BOOST_REQUIRE(std::abs((b[i] - a[i]) / scale[i] - after[i]) < 1e-11);
        }
        const std::vector<double> before = after;
        map.apply(before, after);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_step_remembers_nothing_but_the_state) {
  for (const int time_order : {2, 4}) {
    Case scene = paper_case();
    scene.discretization.scheme = Scheme::staggered4;
    scene.discretization.basis_order = 2;
    scene.discretization.kernel = kernel_name<WendlandC2>;
    scene.discretization.support_radius = 2.0;
    scene.time.order = time_order;
    for (const Scheme scheme : {Scheme::staggered4, Scheme::galerkin}) {
      scene.discretization.scheme = scheme;
      const auto step = solver::step_operator(scene);
      const LinearMap map = step->at(ColumnSolver(paper_case()).time_step());
      const auto x = noise(map.size, 7), other = noise(map.size, 8);
      std::vector<double> first(map.size), between(map.size), again(map.size);
      map.apply(x, first);
      map.apply(other, between);
      map.apply(x, again);
      BOOST_TEST(first == again, boost::test_tools::per_element());
    }
  }
}

BOOST_AUTO_TEST_CASE(steps_can_be_superposed) {
  Case scene = paper_case();
  const double dt = ColumnSolver(scene).time_step();
  BOOST_TEST(superposition_error(*solver::step_operator(scene), dt) < 1e-13);
  scene.discretization.scheme = Scheme::staggered4;
  scene.discretization.basis_order = 2;
  scene.discretization.support_radius = 2.0;
  BOOST_TEST(superposition_error(*solver::step_operator(scene), dt) < 1e-13);
}

BOOST_AUTO_TEST_CASE(the_length_of_a_half_space_is_that_of_its_run) {
  for (const Scheme scheme : {Scheme::galerkin, Scheme::staggered4}) {
    Case scene = paper_case();
    scene.problem.column.length.reset();
    scene.problem.column.far = FarEnd::half_space;
    scene.discretization.scheme = scheme;
    scene.discretization.basis_order = 2;
    scene.discretization.support_radius = 2.0;
    const auto step = solver::step_operator(scene);
    const CarriedFields fields = step->fields(std::vector<double>(step->size(), 0.0));
    BOOST_TEST(fields.node_x.back() == ColumnSolver::grid_length(scene),
               boost::test_tools::tolerance(1e-14));
  }
}

BOOST_AUTO_TEST_CASE(a_state_of_the_wrong_length_is_refused) {
  Case scene = paper_case();
  scene.discretization.scheme = Scheme::staggered4;
  scene.discretization.basis_order = 2;
  scene.discretization.support_radius = 2.0;
  StaggeredSolver solver(scene);
  BOOST_CHECK_THROW(solver.set_state(std::vector<double>(7)), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
