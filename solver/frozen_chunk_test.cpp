// Several frozen steps at a time: not a bit may depend on how many.

#include <boost/test/unit_test.hpp>
#include <cstring>
#include <random>

#include "reference/problem/problem_fixtures.hpp"
#include "solver/column_fixtures.hpp"
#include "solver/column_solver.hpp"

BOOST_AUTO_TEST_SUITE(frozen_chunk)

using namespace porowave;
using namespace porowave::solver;

namespace {

bool same_bits(std::span<const double> a, std::span<const double> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

void check_same(const ColumnSolver& a, const ColumnSolver& b) {
  BOOST_TEST_REQUIRE(a.steps_done() == b.steps_done());
  BOOST_TEST(a.frozen_steps() == b.frozen_steps());
  const Snapshot s = a.snapshot();
  const Snapshot t = b.snapshot();
  for (const auto phase : {&Snapshot::solid, &Snapshot::fluid}) {
    for (const auto values : {&PhasePoints::x, &PhasePoints::velocity, &PhasePoints::stress}) {
      BOOST_TEST(same_bits(s.*phase.*values, t.*phase.*values));
    }
  }
  for (const auto field : {&Snapshot::effective_stress, &Snapshot::pore_pressure,
                           &Snapshot::solid_velocity, &Snapshot::fluid_velocity}) {
    BOOST_TEST(same_bits(s.*field, t.*field));
  }
}

double cell_length(const Case& scene) {
  return *scene.problem.column.length / scene.discretization.elements;
}

void set_steps(Case& scene, long steps) {
  scene.time.end = static_cast<double>(steps) * scene.time.courant * cell_length(scene) /
                   wave_speeds(scene.problem.material).p1;
}

// Regular points of both phases, as many cells as wanted, a load that stays.
Case regular_scene(int elements, long steps, double load = 1.0) {
  Case scene;
  scene.problem = fixtures::paper_problem(Load(LoadShape::step, load));
  scene.discretization.elements = elements;
  scene.discretization.points_per_element = 1;
  set_steps(scene, steps);
  return scene;
}

// Scenes of every kind that can be frozen.
class Scenes {
 public:
  explicit Scenes(unsigned seed) : generator_(seed) {}

  std::size_t below(std::size_t count) { return generator_() % count; }
  template <class T>
  T one_of(std::initializer_list<T> choices) {
    return choices.begin()[below(choices.size())];
  }

  Case next() {
    Case scene;
    scene.problem = fixtures::paper_problem();
    scene.problem.column.near =
        one_of({NearEnd::drained_traction, NearEnd::sealed_traction, NearEnd::fluid_pressure});
    scene.problem.column.far =
        one_of({FarEnd::rigid_sealed, FarEnd::rigid_drained, FarEnd::free_drained});
    const auto choices = test::column_choices();
    Discretization& d = scene.discretization;
    d = choices[below(choices.size())];
    d.elements = one_of({12, 60, 255, 256, 257, 300, 511, 512, 513, 700, 768, 1030, 1500});
    d.points_per_element = one_of({2, 3, 4});
    d.placement = one_of(
        {Placement::uniform, Placement::uniform, Placement::jittered, Placement::stratified});
    d.seed = generator_();
    scene.time.flip = one_of({1.0, 0.9, 0.0});
    set_steps(scene, 400);
    scene.problem.load = load(scene.time.end);
    for (std::size_t gaps = below(3); gaps > 0; --gaps) {
      d.empty_elements.push_back((static_cast<double>(5 + below(d.elements - 6)) + 0.5) *
                                 cell_length(scene));
    }
    return scene;
  }

 private:
  Load load(double end) {
    switch (below(4)) {
      case 0:
        return Load(LoadShape::step, 1.0);
      case 1:
        return Load(LoadShape::smooth_ramp, 1.0, 0.1 * end);
      case 2:
        return Load(LoadShape::block, 1.0, 0.013 * end);  // gone within a chunk
      default:
        return Load(1.0, {0.0, 0.1 * end, 0.1 * end, end}, {0.0, 1.0, -2.0, 0.5});
    }
  }

  std::mt19937 generator_;
};

}  // namespace

BOOST_AUTO_TEST_CASE(several_steps_are_as_many_single_ones) {
  Scenes scenes(7);
  for (int k = 0; k < 60; ++k) {
    const Case scene = scenes.next();
    BOOST_TEST_CONTEXT("scene " << k << ": " << test::title(scene.discretization) << ", "
                                << scene.discretization.elements << " cells") {
      ColumnSolver single(scene);
      ColumnSolver several(scene);
      if (scenes.below(2) == 0) {
        single.disregard_causality();
        several.disregard_causality();
      }
      several.use_threads(1 + scenes.below(3));
      for (int stop = 0; stop < 3; ++stop) {  // at numbers that are no multiples of anything
        const long last = single.steps_done() + 1 + static_cast<long>(scenes.below(120));
        while (single.steps_done() < last) single.step();
        several.advance(last);
        BOOST_TEST(several.frozen_steps() == last);
        check_same(single, several);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(several_steps_have_the_load_of_each) {
  // An impulse within one step, at any place in a chunk.
  for (long hit = 0; hit < 40; ++hit) {
    Case scene = regular_scene(40, 48);
    const double dt = ColumnSolver(scene).time_step();
    const double t = dt * static_cast<double>(hit);
    scene.problem.load = Load(1.0, {t, t, t + 0.2 * dt, t + 0.2 * dt}, {0.0, 1.0, 1.0, 0.0});
    ColumnSolver single(scene);
    ColumnSolver several(scene);
    while (single.steps_done() < 45) single.step();
    several.advance(45);
    check_same(single, several);
  }
}

BOOST_AUTO_TEST_CASE(threads_share_several_steps) {
  // 160 parts, the last of them short: with sixteen steps enough for two threads, else for more.
  ColumnSolver start(regular_scene(160 * 256 - 100, 100'000));
  start.disregard_causality();
  for (const std::size_t threads : {2u, 3u, 5u}) {
    for (const long steps : {2l, 7l, 16l, 35l}) {
      ColumnSolver single(start);
      ColumnSolver several(start);
      several.use_threads(threads);
      for (long last = steps; last <= 70; last += steps) {
        several.advance(last);
        while (single.steps_done() < last) single.step();
      }
      check_same(single, several);
    }
  }
}

BOOST_AUTO_TEST_CASE(threads_share_a_signal_on_its_way) {
  // The wave has passed two thirds of the column: enough parts for threads, and some left out.
  ColumnSolver start(regular_scene(6000, 20'000));
  start.advance(8000);
  for (const std::size_t threads : {2u, 3u}) {
    ColumnSolver single(start);
    ColumnSolver several(start);
    several.use_threads(threads);
    for (long last = 8002; last <= 8200; last += 2) {
      single.step();
      single.step();
      several.advance(last);
    }
    check_same(single, several);
  }
}

BOOST_AUTO_TEST_CASE(points_are_asked_for_after_the_same_step) {
  // From a load that moves nothing far to one that does so in the first steps.
  for (const double load : {1e4, 1e5, 1e6, 3e6, 1e7, 1e8}) {
    for (const LoadShape shape : {LoadShape::step, LoadShape::smooth_ramp}) {
      Case scene = regular_scene(300, 200);
      scene.problem.load = Load(shape, load, has_duration(shape) ? 0.2 * scene.time.end : 0.0);
      ColumnSolver single(scene);
      ColumnSolver several(scene);
      for (long last = 1; last <= 190; last += 27) {
        while (single.steps_done() < last) single.step();
        several.advance(last);
        check_same(single, several);
      }
      BOOST_TEST((single.frozen_steps() == 190) == (load == 1e4));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_jump_that_moves_points_too_far_is_met_at_its_step) {
  // Not to be foreseen from the steps before it; the signal is on its way.
  for (long jump = 80; jump < 130; jump += 3) {
    Case scene = regular_scene(300, 200);
    const double t = (static_cast<double>(jump) + 0.3) * ColumnSolver(scene).time_step();
    scene.problem.load = Load(1.0, {0.0, t, t}, {1e3, 1e3, 1e8});
    ColumnSolver single(scene);
    ColumnSolver several(scene);
    while (single.steps_done() < jump + 20) single.step();
    several.advance(jump + 20);
    BOOST_TEST(single.frozen_steps() > jump);
    BOOST_TEST(single.frozen_steps() < jump + 16);
    check_same(single, several);
  }
}

BOOST_AUTO_TEST_CASE(a_run_ends_where_single_steps_would) {
  Case scene = regular_scene(300, 200, 1e7);
  ColumnSolver single(scene);
  while (single.path() == StepPath::frozen) single.step();
  scene.time.path = StepPath::frozen;
  ColumnSolver run(scene);
  const auto breakdown = run.run();
  BOOST_TEST_REQUIRE(breakdown.has_value());
  BOOST_TEST(breakdown->step == single.steps_done());
  check_same(run, single);
}

BOOST_AUTO_TEST_SUITE_END()
