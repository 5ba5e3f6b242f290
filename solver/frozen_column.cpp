#include "solver/frozen_column.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "solver/simd.hpp"

namespace porowave::solver {

struct FrozenColumn::Scratch {
  // Eight values of the part before, the part, and one node beyond.
  struct Line {
    alignas(64) std::array<double, part_nodes + 16> values;  // filled by the step
    double* data() { return values.data() + 8; }
    const double* data() const { return values.data() + 8; }
  };
  std::size_t first;  // node
  Line solid_velocity, fluid_velocity, effective_stress, pore_pressure, new_solid, new_fluid;
};

namespace {

constexpr std::size_t part_nodes = FrozenColumn::part_nodes;

struct Arrays {
  const double* solid_velocity;
  const double* fluid_velocity;
  const double* effective_stress;  // of the cells behind the nodes; those before stand before
  const double* pore_pressure;
  double* new_solid;
  double* new_fluid;
};

Arrays arrays_of(FrozenColumn::Scratch& at, std::size_t node) {
  const std::size_t k = node - at.first;
  return {at.solid_velocity.data() + k,   at.fluid_velocity.data() + k,
          at.effective_stress.data() + k, at.pore_pressure.data() + k,
          at.new_solid.data() + k,        at.new_fluid.data() + k};
}

POROWAVE_VECTORISED void move_nodes(const NodeCoefficients* coefficients, double ns, double nf,
                                    const Arrays& at, std::size_t eights) {
  for (std::size_t k = 0; k < eights; ++k) {
    const std::size_t i = 8 * k;
    Eight effective, pressure, before, vs, vf, new_vs, new_vf;
    read(at.effective_stress + i, effective);
    read(at.effective_stress + i - 1, before);
    effective -= before;
    read(at.pore_pressure + i, pressure);
    read(at.pore_pressure + i - 1, before);
    pressure -= before;
    read(at.solid_velocity + i, vs);
    read(at.fluid_velocity + i, vf);
    move_free(coefficients[k], 0, ns, nf, effective, pressure, vs, vf, new_vs, new_vf);
    write(new_vs, at.new_solid + i);
    write(new_vf, at.new_fluid + i);
  }
}

// q ← flip (q − v) + v'; gives Σ v'².
POROWAVE_VECTORISED double update_node_values(double flip, const double* __restrict v,
                                              const double* __restrict v_new,
                                              const double* __restrict q, std::size_t eights,
                                              double* __restrict q_new) {
  Eight squares = {};
  for (std::size_t i = 0; i < 8 * eights; i += 8) {
    Eight before, after, value;
    read(v + i, before);
    read(v_new + i, after);
    read(q + i, value);
    squares += after * after;
    write(flip * (value - before) + after, q_new + i);
  }
  double sum = 0.0;
  for (int k = 0; k < 8; ++k) sum += squares[k];
  return sum;
}

// e ← e + solid (v_s' differences) + fluid (v_f' differences)
POROWAVE_VECTORISED void update_cell_values(double solid, double fluid, const Arrays& at,
                                            const double* const* e, std::size_t eights,
                                            double effective, double* const* e_new) {
  for (std::size_t i = 0; i < 8 * eights; i += 8) {
    Eight here, next, value;
    read(at.new_solid + i, here);
    read(at.new_solid + i + 1, next);
    const Eight solid_rise = next - here;
    read(at.new_fluid + i, here);
    read(at.new_fluid + i + 1, next);
    const Eight fluid_rise = next - here;
    read(e[0] + i, value);
    write(value + effective * solid_rise, e_new[0] + i);
    read(e[1] + i, value);
    write(value + (solid * solid_rise + fluid * fluid_rise), e_new[1] + i);
  }
}

std::vector<int> cells_of_points(const CompactOperators& compact) {
  std::vector<int> cell(compact.points_of({0, compact.cell_count()}).last);
  for (std::size_t c = 0; c < compact.cell_count(); ++c) {
    const IndexRange points = compact.points_of({c, c + 1});
    std::fill(cell.begin() + static_cast<std::ptrdiff_t>(points.first),
              cell.begin() + static_cast<std::ptrdiff_t>(points.last), static_cast<int>(c));
  }
  return cell;
}

std::shared_ptr<const BandedRows> node_band(const CompactOperators& compact) {
  const std::vector<int> cell = cells_of_points(compact);
  return std::make_shared<BandedRows>(compact.node_rows(), [&](std::size_t p) {
    const double t = compact.place_in_cell(p);
    return PointRow{cell[p], {1.0 - t, t}};
  });
}

std::shared_ptr<const BandedRows> cell_band(const CompactOperators& compact) {
  const std::vector<int> cell = cells_of_points(compact);
  return std::make_shared<BandedRows>(compact.cell_rows(), [&](std::size_t p) {
    return compact.shared_strains().row(static_cast<std::size_t>(cell[p]),
                                        compact.place_in_cell(p));
  });
}

std::shared_ptr<const CompactOperators> compact_form(
    const std::shared_ptr<const ColumnOperators>& operators) {
  auto compact = std::dynamic_pointer_cast<const CompactOperators>(operators);
  if (!compact) throw std::invalid_argument("frozen column: operators without compact form");
  return compact;
}

void settle_phase(const CompactOperators& at, const double* q, const double* e,
                  PointValues& points) {
  at.to_points(q, points.velocity.data());
  for (std::size_t c = 0; c < at.cell_count(); ++c) {
    const IndexRange there = at.points_of({c, c + 1});
    for (std::size_t p = there.first; p < there.last; ++p) {
      const PointRow row = at.shared_strains().row(c, at.place_in_cell(p));
      points.stress[p] = row.values[0] * e[row.first];
      if (row.values[1] != 0.0) points.stress[p] += row.values[1] * e[row.first + 1];
    }
  }
}

}  // namespace

FrozenColumn::FrozenColumn(const std::shared_ptr<const ColumnOperators>& solid,
                           const std::shared_ptr<const ColumnOperators>& fluid,
                           const PreparedUpdate& update, const Constants& constants)
    : solid_points_(compact_form(solid)),
      fluid_points_(compact_form(fluid)),
      constants_(constants),
      spacing_(solid_points_->spacing()),
      node_count_(solid_points_->cell_count() + 1) {
  const bool shared = solid_points_ == fluid_points_;
  const auto nodes = node_band(*solid_points_);
  const auto cells = cell_band(*solid_points_);
  to_nodes_ =
      std::make_shared<BandedPair>(nodes, shared ? nodes : node_band(*fluid_points_), node_count_);
  to_cells_ =
      std::make_shared<BandedPair>(cells, shared ? cells : cell_band(*fluid_points_), node_count_);
  if (shared) {
    regular_ = RegularNodes(*nodes, *cells, update, constants.solid_fraction, constants.porosity,
                            node_count_);
  }
  const std::size_t parts = (node_count_ + part_nodes - 1) / part_nodes;
  states_.fill(at_rest());
  ends_.resize(parts + 1);  // beyond the last part nothing moves
}

FrozenColumn::State FrozenColumn::at_rest() const {
  const PaddedValues nodal(node_count_, to_nodes_->reach() + 8);
  const PaddedValues cellwise(node_count_, to_cells_->reach() + 8);
  return {nodal, nodal, cellwise, cellwise};
}

bool FrozenColumn::possible(const ColumnOperators& points) {
  return dynamic_cast<const CompactOperators*>(&points) != nullptr;
}

void FrozenColumn::update_specials(const StepLoad& load, const NodeUpdate& by, IndexRange nodes,
                                   Scratch& at) const {
  PhaseNodes& solid = by.solid;
  PhaseNodes& fluid = by.fluid;
  for (const std::size_t i : by.update.special(nodes)) {
    const std::size_t k = i - nodes.first;
    const double* effective = at.effective_stress.data() + k;
    const double* pressure = at.pore_pressure.data() + k;
    const double pressure_force = pressure[0] - pressure[-1];
    solid.force[i] = effective[0] - effective[-1] - constants_.solid_fraction * pressure_force;
    fluid.force[i] = -constants_.porosity * pressure_force;
    solid.velocity[i] = at.solid_velocity.data()[k];
    fluid.velocity[i] = at.fluid_velocity.data()[k];
    update_node(by.problem, load, constants_.time_step, i, solid, fluid);
    at.solid_velocity.data()[k] = solid.velocity[i];
    at.fluid_velocity.data()[k] = fluid.velocity[i];
    at.new_solid.data()[k] = solid.new_velocity[i];
    at.new_fluid.data()[k] = fluid.new_velocity[i];
  }
}

void FrozenColumn::gather(const State& before, IndexRange eights, Scratch& at) const {
  const std::size_t k = eights.first * 8 - at.first;
  to_nodes_->multiply(eights, before.solid_q.data(), before.fluid_q.data(),
                      at.solid_velocity.data() + k, at.fluid_velocity.data() + k);
  to_cells_->multiply(eights, before.solid_e.data(), before.fluid_e.data(),
                      at.effective_stress.data() + k, at.pore_pressure.data() + k);
  // The cell before the first node belongs to others; there is none before the column.
  if (eights.first == 0) {
    at.effective_stress.data()[-1] = at.pore_pressure.data()[-1] = 0.0;
    return;
  }
  to_cells_->multiply({eights.first - 1, eights.first}, before.solid_e.data(),
                      before.fluid_e.data(), at.effective_stress.data() + k - 8,
                      at.pore_pressure.data() + k - 8);
}

FrozenColumn::Squares FrozenColumn::update_values(const State& before, IndexRange eights,
                                                  Scratch& at, State& after) const {
  const std::size_t first = eights.first * 8;
  const Arrays arrays = arrays_of(at, first);
  const double factor = constants_.pore_pressure / spacing_;
  const double* e[2] = {before.solid_e.data() + first, before.fluid_e.data() + first};
  double* e_new[2] = {after.solid_e.data() + first, after.fluid_e.data() + first};
  update_cell_values(factor * constants_.solid_fraction, factor * constants_.porosity, arrays, e,
                     eights.size(), constants_.effective_stress / spacing_, e_new);
  return {update_node_values(constants_.flip, arrays.solid_velocity, arrays.new_solid,
                             before.solid_q.data() + first, eights.size(),
                             after.solid_q.data() + first),
          update_node_values(constants_.flip, arrays.fluid_velocity, arrays.new_fluid,
                             before.fluid_q.data() + first, eights.size(),
                             after.fluid_q.data() + first)};
}

FrozenColumn::Squares FrozenColumn::step_regular_nodes(const State& before, IndexRange eights,
                                                       Scratch& at, State& after) const {
  const std::size_t i = eights.first * 8;
  const double factor = constants_.pore_pressure / spacing_;
  double* solid = at.new_solid.data() + (i - at.first);
  double* fluid = at.new_fluid.data() + (i - at.first);
  const std::size_t count = 8 * eights.size();
  const RegularResult result =
      step_regular(regular_.stencil(),
                   {constants_.flip, constants_.effective_stress / spacing_,
                    factor * constants_.solid_fraction, factor * constants_.porosity},
                   {before.solid_q.data() + i, before.fluid_q.data() + i, before.solid_e.data() + i,
                    before.fluid_e.data() + i, after.solid_q.data() + i, after.fluid_q.data() + i,
                    after.solid_e.data() + i, after.fluid_e.data() + i},
                   eights.size(), solid[count], fluid[count]);
  solid[0] = result.solid.first;
  fluid[0] = result.fluid.first;
  solid[count - 1] = result.solid.last;
  fluid[count - 1] = result.fluid.last;
  return {result.solid.squares, result.fluid.squares};
}

double FrozenColumn::step_part(Turn turn, const StepLoad& load, const NodeUpdate& by,
                               IndexRange nodes) {
  const State& before = states_[turn.before];
  State& after = states_[turn.after];
  Scratch at;  // large, and all that is read of it is written below
  at.first = nodes.first;
  const std::size_t eights = (nodes.size() + 7) / 8;
  const IndexRange part{nodes.first / 8, nodes.first / 8 + eights};
  const IndexRange run = regular_.in_block(nodes.first / part_nodes);
  const IndexRange regular{std::min(run.first, part.last), std::min(run.last, part.last)};
  const std::array<IndexRange, 2> others =
      regular.size() > 0
          ? std::array{IndexRange{part.first, regular.first}, IndexRange{regular.last, part.last}}
          : std::array{part, IndexRange{part.last, part.last}};
  for (const IndexRange& other : others) {
    if (other.size() == 0) continue;
    gather(before, other, at);
    move_nodes(&by.update.coefficients(other.first), constants_.solid_fraction, constants_.porosity,
               arrays_of(at, 8 * other.first), other.size());
  }
  update_specials(load, by, nodes, at);
  std::fill_n(at.new_solid.data() + 8 * eights, 8, 0.0);
  std::fill_n(at.new_fluid.data() + 8 * eights, 8, 0.0);

  Squares squares;
  if (regular.size() > 0) squares = step_regular_nodes(before, regular, at, after);
  for (const IndexRange& other : others) {
    if (other.size() == 0) continue;
    const Squares there = update_values(before, other, at, after);
    squares.solid += there.solid;
    squares.fluid += there.fluid;
  }
  PartEnds& ends = ends_[nodes.first / part_nodes];
  ends = {at.new_solid.data()[0], at.new_fluid.data()[0], 0.0, 0.0};
  if (8 * eights == part_nodes) {  // otherwise it reaches beyond the signal or the column
    ends.solid_last = at.new_solid.data()[part_nodes - 1];
    ends.fluid_last = at.new_fluid.data()[part_nodes - 1];
  }
  return std::max(squares.solid, squares.fluid);
}

void FrozenColumn::step_cell_behind(Turn turn, std::size_t part) {
  const std::size_t c = (part + 1) * part_nodes - 1;
  if (c + 1 >= node_count_) return;
  const State& before = states_[turn.before];
  State& after = states_[turn.after];
  const double factor = constants_.pore_pressure / spacing_;
  const double solid_rise = ends_[part + 1].solid_first - ends_[part].solid_last;
  const double fluid_rise = ends_[part + 1].fluid_first - ends_[part].fluid_last;
  after.solid_e.data()[c] =
      before.solid_e.data()[c] + constants_.effective_stress / spacing_ * solid_rise;
  after.fluid_e.data()[c] =
      before.fluid_e.data()[c] +
      factor * (constants_.solid_fraction * solid_rise + constants_.porosity * fluid_rise);
}

void FrozenColumn::displacements(std::span<double> solid, std::span<double> fluid) {
  const double ns = constants_.solid_fraction;
  const double nf = constants_.porosity;
  const State& now = states_[now_];
  solid[0] = motion_.solid_first;
  fluid[0] = motion_.fluid_first;
  double largest = std::max(std::abs(solid[0]), std::abs(fluid[0]));
  for (std::size_t c = 0; c + 1 < node_count_; ++c) {
    const double solid_rise =
        now.solid_e.data()[c] * constants_.time_step * spacing_ / constants_.effective_stress;
    const double mixture_rise =
        now.fluid_e.data()[c] * constants_.time_step * spacing_ / constants_.pore_pressure;
    solid[c + 1] = solid[c] + solid_rise;
    fluid[c + 1] = fluid[c] + (mixture_rise - ns * solid_rise) / nf;
    largest = std::max({largest, std::abs(solid[c + 1]), std::abs(fluid[c + 1])});
  }
  motion_.bound = largest;
}

void FrozenColumn::settle(PointValues& solid, PointValues& fluid) const {
  const State& now = states_[now_];
  settle_phase(*solid_points_, now.solid_q.data(), now.solid_e.data(), solid);
  settle_phase(*fluid_points_, now.fluid_q.data(), now.fluid_e.data(), fluid);
}

std::array<std::span<const double>, 2> FrozenColumn::node_values() const {
  const State& now = states_[now_];
  return {std::span(now.solid_q.data(), node_count_), std::span(now.fluid_q.data(), node_count_)};
}

std::array<std::span<const double>, 2> FrozenColumn::cell_values() const {
  const State& now = states_[now_];
  return {std::span(now.solid_e.data(), node_count_ - 1),
          std::span(now.fluid_e.data(), node_count_ - 1)};
}

}  // namespace porowave::solver
