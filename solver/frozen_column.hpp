#pragma once

// A column without its points. While the weights stay and the material is linear, everything that
// a step does to points that started at rest, without stress, is a combination of shape functions:
//
//   v_p = Σ_i N_i(x_p) q_i      q ← flip (q − v) + v'
//   s_p = e(cell of p)          e ← e + c (b_(i+1) − b_i)/h      (or of two: shared_strains.hpp)
//
// with flip, v, v', b, c of PointUpdate. So the nodes need only q, the cells e, of either phase:
//
//   v_i = (W q)_i,  W = Φ N         S_c = (B e)_c,  B = Φ (cell of p)
//
// The strain of a cell stands for ∂N u: summed in the cell it does not lose the digits that the
// difference of large displacements would, and displacements follow from it when asked for. Points
// are made up for when they are asked for.
//
// Amid regular points all rows of W and B are the same: regular_nodes.hpp.
//
// A step reads the values before it and writes those after it elsewhere, part by part of 256 nodes.
// A part needs its neighbours' last step and no more, so several steps go through the parts as one
// wave, which stays in the cache: frozen_chunk.cpp. No bit depends on how many they are, nor on the
// number of threads.

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "solver/banded_pair.hpp"
#include "solver/compact_operators.hpp"
#include "solver/prepared_update.hpp"
#include "solver/regular_nodes.hpp"
#include "solver/signal_window.hpp"

namespace porowave::solver {

class FrozenColumn {
 public:
  static constexpr std::size_t part_nodes = BandedRows::block_rows;

  // What a step is made of, for one problem and one time step.
  struct Constants {
    double flip;              // 1 FLIP ... 0 PIC
    double solid_fraction;    // n_s
    double porosity;          // n_f
    double effective_stress;  // Δt E_oed, Pa s
    double pore_pressure;     // −Δt K, Pa s
    double time_step;         // s
  };
  // Nodal values of one part, one a thread.
  struct Scratch;

  // `update` as all steps will get it. Throws std::invalid_argument if an operator has no compact
  // form.
  FrozenColumn(const std::shared_ptr<const ColumnOperators>& solid,
               const std::shared_ptr<const ColumnOperators>& fluid, const PreparedUpdate& update,
               const Constants& constants);
  // Whether a phase with these operators can be frozen.
  static bool possible(const ColumnOperators& points);

  // What moves the nodes: `solid` and `fluid` are used where `update` must ask update_node.
  struct NodeUpdate {
    const Problem& problem;
    const PreparedUpdate& update;
    PhaseNodes& solid;
    PhaseNodes& fluid;
  };
  // A step for each of the loads, not more than most_steps(). After each step `window` is widened
  // if need be. Threads are used if there are enough parts for them.
  void advance(const NodeUpdate& by, std::span<const StepLoad> loads, SignalWindow& window,
               std::size_t threads);
  static constexpr std::size_t longest_chunk = 16;
  // How many steps can be made at once: longest_chunk, or one if parts reach beyond the next ones.
  std::size_t most_steps() const;
  // As it was before the last call of advance, once. `window` is the caller's to set back.
  void undo();

  // An upper bound of the displacement of any node since the start, m. It never falls in a step.
  double displacement_bound() const { return motion_.bound; }
  // How many steps, as the last one was, may come before the bound is at half its way to `limit`.
  std::size_t steps_before(double limit) const;
  // The displacements themselves, which make the bound sharp.
  void displacements(std::span<double> solid, std::span<double> fluid);

  // Velocities and stresses of all points.
  void settle(PointValues& solid, PointValues& fluid) const;
  // q of the nodes and e of the cells. No point has a larger velocity, nor more than twice the
  // stress.
  std::array<std::span<const double>, 2> node_values() const;
  std::array<std::span<const double>, 2> cell_values() const;

 private:
  // q and e of both phases at one time.
  struct State {
    PaddedValues solid_q, fluid_q;  // m/s
    PaddedValues solid_e, fluid_e;  // Pa
  };
  // Which state a step reads, and which one it writes.
  struct Turn {
    std::size_t before;
    std::size_t after;
  };
  // New velocities at the ends of a part, for the cells between parts.
  struct PartEnds {
    double solid_first = 0.0, fluid_first = 0.0, solid_last = 0.0, fluid_last = 0.0;
  };
  // Displacements, m: of node 0, and a bound of all; the bound's rise in the last step.
  struct Motion {
    double solid_first = 0.0, fluid_first = 0.0;
    double bound = 0.0, rise = 0.0;
  };
  struct Chunk;  // frozen_chunk.cpp

  State at_rest() const;
  // A step of some nodes of one part, from its first one on; gives Σ v'² of the faster phase.
  double step_part(Turn turn, const StepLoad& load, const NodeUpdate& by, IndexRange nodes);
  // The cell between this part and the next one, if there is one, once both have made the step.
  void step_cell_behind(Turn turn, std::size_t part);

  // Of some eights of nodes: velocities and forces; new q and e from the new velocities; a step.
  struct Squares {
    double solid = 0.0, fluid = 0.0;  // Σ v'²
  };
  void gather(const State& before, IndexRange eights, Scratch& at) const;
  Squares update_values(const State& before, IndexRange eights, Scratch& at, State& after) const;
  Squares step_regular_nodes(const State& before, IndexRange eights, Scratch& at,
                             State& after) const;
  void update_specials(const StepLoad& load, const NodeUpdate& by, IndexRange nodes,
                       Scratch& at) const;

  std::shared_ptr<const CompactOperators> solid_points_;
  std::shared_ptr<const CompactOperators> fluid_points_;
  std::shared_ptr<const BandedPair> to_nodes_;  // W
  std::shared_ptr<const BandedPair> to_cells_;  // B
  RegularNodes regular_;
  Constants constants_;
  double spacing_;
  std::size_t node_count_;
  std::array<State, 3> states_;  // now, and two that steps write in turns
  std::size_t now_ = 0;
  std::size_t undone_ = 0;  // the state before the last advance
  Motion motion_;
  Motion undone_motion_;
  std::vector<PartEnds> ends_;  // of the step that a part made last
};

}  // namespace porowave::solver
