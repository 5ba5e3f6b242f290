#include "solver/column_solver.hpp"

#ifdef _OPENMP
#include <omp.h>
#endif

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "reference/problem/errors.hpp"
#include "solver/nodal_loops.hpp"
#include "solver/particle_domain.hpp"
#include "solver/time_step.hpp"

namespace porowave::solver {

namespace {

// A half-space ends this much beyond what the fast wave can reach.
constexpr double half_space_margin = 1.05;
// Nodes of one part of the column; a thread takes one at a time.
constexpr std::size_t nodes_of_part = BandedRows::block_rows;
// A step over fewer points (or nodes, where points are not visited) is done sooner than the other
// threads of a busy machine have woken up.
constexpr std::size_t items_worth_threads = 200'000;
// Velocities ahead of the signal that are left out, as a share of the load's.
constexpr double negligible = 1e-30;

Grid<1> make_grid(double length, int elements) {
  return {Vector<1>(0.0), length / elements, CellIndex<1>(elements)};
}

std::size_t threads_at_hand() {
#ifdef _OPENMP
  return static_cast<std::size_t>(omp_get_max_threads());
#else
  return 1;
#endif
}

template <class T>
void put_in_order(const std::vector<std::size_t>& order, std::vector<T>& values) {
  const std::vector<T> old = values;
  for (std::size_t k = 0; k < order.size(); ++k) values[k] = old[order[k]];
}

}  // namespace

ColumnSolver::PhaseState ColumnSolver::start(const Discretization& choice, double spacing,
                                             Phase phase, double density) {
  PlacedPoints placed = place_points(choice, spacing, phase);
  PhaseState state;
  state.points.x.reserve(placed.x.size());
  state.points.mass.reserve(placed.x.size());
  for (std::size_t p = 0; p < placed.x.size(); ++p) {
    state.points.x.emplace_back(placed.x[p]);
    state.points.mass.push_back(density * placed.volume[p]);
  }
  state.points.volume = std::move(placed.volume);
  state.points.volume.shrink_to_fit();
  if (choice.transfer != TransferName::mls) state.points.domain = state.points.volume;
  state.values.velocity.assign(placed.x.size(), 0.0);
  state.values.stress.assign(placed.x.size(), 0.0);
  if (choice.transfer == TransferName::apic) state.values.velocity_gradient = state.values.stress;
  const auto nodes = static_cast<std::size_t>(choice.elements) + 1;
  state.nodes.resize(nodes);
  state.displacement.assign(nodes, 0.0);
  return state;
}

ColumnSolver::ColumnSolver(const Case& scene)
    : scene_(scene),
      grid_(make_grid(grid_length(scene), scene.discretization.elements)),
      dt_(0.0),
      steps_(step_count(scene, grid_.spacing)),
      solid_(start(scene.discretization, grid_.spacing, Phase::solid,
                   scene.problem.material.solid_partial_density())),
      fluid_(start(scene.discretization, grid_.spacing, Phase::fluid,
                   scene.problem.material.fluid_partial_density())),
      node_count_(static_cast<std::size_t>(grid_.node_count())),
      window_(SignalWindow::whole_column(node_count_)) {
  dt_ = scene.time.end / static_cast<double>(steps_);
  make_weights();
  const bool needs_both = scene.problem.column.near != NearEnd::velocity;
  if (needs_both && (solid_.nodes.mass[0] <= 0.0 || fluid_.nodes.mass[0] <= 0.0)) {
    throw BreakdownError(
        "step 0: no point within reach of the loaded end x = 0, nodal mass = 0; "
        "more points per element or a larger support_radius would reach it");
  }
  const bool parts = solid_.prepared.operators->works_on_parts();
  part_nodes_ = parts ? nodes_of_part : node_count_;
  if (parts) {
    window_ =
        SignalWindow::at_rest(node_count_, guard(), negligible * scene.problem.velocity_scale());
  }
  lagged_ = guard() <= part_nodes_;
  if (scene.time.path != StepPath::points) freeze();
  choose_threads();
}

double ColumnSolver::grid_length(const Case& scene) {
  if (scene.problem.column.length) return *scene.problem.column.length;
  return half_space_margin * wave_speeds(scene.problem.material).p1 * scene.time.end;
}

std::size_t ColumnSolver::point_count() const {
  return solid_.points.x.size() + fluid_.points.x.size();
}

std::size_t ColumnSolver::reduced_rows() const {
  return solid_.prepared.reduced_rows + fluid_.prepared.reduced_rows;
}

std::size_t ColumnSolver::empty_rows() const {
  return solid_.prepared.empty_rows + fluid_.prepared.empty_rows;
}

StepPath ColumnSolver::path() const {
  return frozen_ && frozen_steps_ == step_ ? StepPath::frozen : StepPath::points;
}

std::size_t ColumnSolver::guard() const {
  return std::max(solid_.prepared.operators->reach(), fluid_.prepared.operators->reach());
}

void ColumnSolver::use_threads([[maybe_unused]] std::size_t most) {
#ifdef _OPENMP
  threads_ = std::max<std::size_t>(most, 1);
#else
  threads_ = 1;
#endif
  const std::vector<double> nodal(part_nodes_ + 3);
  scratch_.assign(threads_, {nodal, nodal});
}

void ColumnSolver::choose_threads() {
  const std::size_t items = frozen_ ? node_count_ : point_count();
  use_threads(items < items_worth_threads ? 1 : threads_at_hand());
}

void ColumnSolver::sort_points(PhaseState& state) {
  const auto& x = state.points.x;
  const auto before = [](const Vector<1>& a, const Vector<1>& b) { return a[0] < b[0]; };
  if (std::is_sorted(x.begin(), x.end(), before)) return;
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return before(x[a], x[b]); });
  put_in_order(order, state.points.x);
  for (auto* values :
       {&state.points.volume, &state.points.mass, &state.points.domain, &state.values.velocity,
        &state.values.stress, &state.values.velocity_gradient}) {
    if (!values->empty()) put_in_order(order, *values);
  }
}

void ColumnSolver::make_weights() {
  for (PhaseState* state : {&solid_, &fluid_}) {
    sort_points(*state);
    state->prepared.operators.reset();
  }
  for (PhaseState* state : {&solid_, &fluid_}) {
    if (state == &fluid_ && phases_share_points()) {
      share_weights();
      break;
    }
    state->prepared = prepare_phase(state->points, grid_, scene_.discretization, scene_.time);
    state->nodes.mass = std::move(state->prepared.nodal_mass);
    state->nodes.volume = std::move(state->prepared.nodal_volume);
  }
  update_ = PreparedUpdate(scene_.problem, dt_, solid_.nodes, fluid_.nodes);
}

bool ColumnSolver::phases_share_points() const {
  const PointSet<1>& s = solid_.points;
  const PointSet<1>& f = fluid_.points;
  return s.x == f.x && s.volume == f.volume && s.domain == f.domain;
}

// Weights depend on places and volumes alone, nodal masses also on the density, one of each phase.
void ColumnSolver::share_weights() {
  const Material& m = scene_.problem.material;
  fluid_.prepared = solid_.prepared;
  fluid_.nodes.volume = solid_.nodes.volume;
  fluid_.nodes.mass = solid_.nodes.mass;
  for (double& mass : fluid_.nodes.mass) {
    mass *= m.fluid_partial_density() / m.solid_partial_density();
  }
}

void ColumnSolver::move_points() {
  if (convects_domains(scene_.discretization.shape)) {
    for (PhaseState* state : {&solid_, &fluid_}) {
      std::vector<double> strain(state->points.x.size());
      state->prepared.operators->gradient_at_points(solid_.displacement.data(), strain.data());
      stretch_domains(strain, state->points.domain);
    }
  }
  for (PhaseState* state : {&solid_, &fluid_}) {
    std::vector<double> moved(state->points.x.size());
    state->prepared.operators->to_points(state->displacement.data(), moved.data());
    for (std::size_t p = 0; p < moved.size(); ++p) {
      // A point of a run that breaks down stays until find_breakdown sees its velocity.
      if (std::isfinite(moved[p])) state->points.x[p][0] += moved[p];
    }
    std::fill(state->displacement.begin(), state->displacement.end(), 0.0);
  }
}

void ColumnSolver::freeze() {
  if (!FrozenColumn::possible(*solid_.prepared.operators)) {
    if (scene_.time.path == StepPath::automatic) return;
    throw InputError(
        "time.path = \"frozen\" is not possible with this transfer: expected \"auto\" "
        "or \"points\"");
  }
  const Material& m = scene_.problem.material;
  frozen_.emplace(
      solid_.prepared.operators, fluid_.prepared.operators, update_,
      FrozenColumn::Constants{scene_.time.flip, m.solid_fraction(), m.porosity,
                              dt_ * m.constrained_modulus, -dt_ * m.storage_modulus(), dt_});
}

void ColumnSolver::thaw() {
  if (!frozen_) return;
  frozen_->settle(solid_.values, fluid_.values);
  frozen_->displacements(solid_.displacement, fluid_.displacement);
  frozen_.reset();
}

StepLoad ColumnSolver::load_of_step(long step) const {
  const double t = dt_ * static_cast<double>(step);
  return load_between(t - 0.5 * dt_, t + 0.5 * dt_);
}

StepLoad ColumnSolver::load_between(double before, double after) const {
  const Load& load = scene_.problem.load;
  return {load.mean(before, after), load.value(before), load.value(after)};
}

IndexRange ColumnSolver::part(std::size_t k) const {
  return {k * part_nodes_, std::min((k + 1) * part_nodes_, window_.nodes)};
}

// The parts [parts.first, parts.last), to the nodes and back to the points. A part can go back when
// its neighbours have been to the nodes: then its values are still in the cache. What lies beside
// the parts of another thread is left to finish_parts.
bool ColumnSolver::sweep_parts(const StepLoad& load, IndexRange parts, PartScratch& scratch) {
  bool moved = false;
  for (std::size_t k = parts.first; k < parts.last; ++k) {
    moved = sweep_to_nodes(load, part(k), scratch) || moved;
    if (lagged_ && k >= parts.first + 2) sweep_to_points(part(k - 1), scratch);
  }
  return moved;
}

void ColumnSolver::finish_parts(IndexRange parts, PartScratch& scratch) {
  for (std::size_t k = parts.first; k < parts.last; ++k) {
    const bool inside = k > parts.first && k + 1 < parts.last;
    if (!(lagged_ && inside)) sweep_to_points(part(k), scratch);
  }
}

bool ColumnSolver::sweep(const StepLoad& load) {
  const std::size_t parts = (window_.nodes + part_nodes_ - 1) / part_nodes_;
  bool moved = false;
#ifdef _OPENMP
  if (threads_ > 1) {
#pragma omp parallel num_threads(static_cast <int>(threads_)) reduction(|| : moved)
    {
      const auto me = static_cast<std::size_t>(omp_get_thread_num());
      const auto all = static_cast<std::size_t>(omp_get_num_threads());
      const IndexRange mine{parts * me / all, parts * (me + 1) / all};
      moved = sweep_parts(load, mine, scratch_[me]);
#pragma omp barrier
      finish_parts(mine, scratch_[me]);
    }
    return moved;
  }
#endif
  moved = sweep_parts(load, {0, parts}, scratch_[0]);
  finish_parts({0, parts}, scratch_[0]);
  return moved;
}

bool ColumnSolver::sweep_to_nodes(const StepLoad& load, IndexRange nodes, PartScratch& scratch) {
  solid_.prepared.operators->gather(
      solid_.values, nodes, solid_.nodes.velocity.data() + nodes.first, scratch.first.data());
  fluid_.prepared.operators->gather(
      fluid_.values, nodes, fluid_.nodes.velocity.data() + nodes.first, scratch.second.data());
  if (body_force_) add_body_force(nodes, scratch.first.data(), scratch.second.data());
  update_.apply(scene_.problem, load, nodes, {scratch.first.data(), scratch.second.data()},
                solid_.nodes, fluid_.nodes);
  const double limit = reweight_share * grid_.spacing;
  bool moved = false;
  for (PhaseState* state : {&solid_, &fluid_}) {
    moved = add_displacement(dt_, state->nodes.new_velocity.data() + nodes.first, nodes.size(),
                             limit, state->displacement.data() + nodes.first) ||
            moved;
  }
  return moved;
}

void ColumnSolver::sweep_to_points(IndexRange nodes, PartScratch& scratch) {
  const Material& m = scene_.problem.material;
  const IndexRange cells{nodes.first, std::min(nodes.last, node_count_ - 1)};
  const double flip = scene_.time.flip;
  const auto at = [&](const std::vector<double>& nodal) { return nodal.data() + nodes.first; };
  const double* vs = at(solid_.nodes.new_velocity);
  const double* vf = at(fluid_.nodes.new_velocity);
  const int xpic = scene_.time.xpic_order;
  solid_.prepared.operators->scatter(
      {flip, at(solid_.nodes.velocity), vs, vs, dt_ * m.constrained_modulus, xpic}, cells,
      solid_.values);
  // ṗ = −K (n_s ∂v_s + n_f ∂v_f), both gradients at the fluid's points.
  // With a node to either side, as far as the column reaches.
  const std::size_t before = cells.first > 0 ? 1 : 0;
  const std::size_t beyond = cells.last + 1 < node_count_ ? 1 : 0;
  double* mixture = scratch.first.data() + before;
  combine(m.solid_fraction(), vs - before, m.porosity, vf - before,
          before + cells.size() + 1 + beyond, scratch.first.data());
  fluid_.prepared.operators->scatter(
      {flip, at(fluid_.nodes.velocity), vf, mixture, -dt_ * m.storage_modulus(), xpic}, cells,
      fluid_.values);
}

void ColumnSolver::step() {
  if (frozen_) {
    step_frozen(1);
    return;
  }
  const bool moved = sweep(load_of_step(step_));
  ++step_;
  window_.widen(solid_.nodes.new_velocity, fluid_.nodes.new_velocity);
  if (moved) renew_weights();
}

void ColumnSolver::advance(long last) {
  while (step_ < last && !held_up()) {
    if (frozen_) {
      step_frozen(std::min(last - step_, safe_steps()));
    } else {
      step();
    }
  }
}

bool ColumnSolver::held_up() const {
  return scene_.time.path == StepPath::frozen && !frozen_;
}

long ColumnSolver::safe_steps() const {
  if (step_ < single_until_ || !lagged_) return 1;
  const std::size_t steps =
      std::min(frozen_->most_steps(), frozen_->steps_before(reweight_share * grid_.spacing));
  return std::max(static_cast<long>(steps), 1L);
}

// Points must be asked for after the very step in which they may have moved too far. Should that be
// one of several steps, which seldom happens, they are made again one by one.
void ColumnSolver::step_frozen(long steps) {
  std::array<StepLoad, FrozenColumn::longest_chunk> loads{};
  const auto count = static_cast<std::size_t>(steps);
  for (std::size_t k = 0; k < count; ++k) loads[k] = load_of_step(step_ + static_cast<long>(k));
  const SignalWindow window_before = window_;
  frozen_->advance({scene_.problem, update_, solid_.nodes, fluid_.nodes}, {loads.data(), count},
                   window_, threads_);
  const double limit = reweight_share * grid_.spacing;
  const bool surely_near = frozen_->displacement_bound() <= limit;
  if (!surely_near && steps > 1) {
    frozen_->undo();
    window_ = window_before;
    single_until_ = step_ + steps;
    return;
  }
  step_ += steps;
  frozen_steps_ += steps;
  if (surely_near) return;
  // The bound is cheap, the displacements themselves are not: only where it does not do.
  frozen_->displacements(solid_.displacement, fluid_.displacement);
  if (!(frozen_->displacement_bound() > limit)) return;
  thaw();
  renew_weights();
}

void ColumnSolver::renew_weights() {
  points_moved_ = true;
  move_points();
  make_weights();
}

}  // namespace porowave::solver
