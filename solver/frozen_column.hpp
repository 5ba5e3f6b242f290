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
// A step reads the values before it and writes those after it elsewhere, part by part of 256 nodes,
// in any order or side by side: no bit depends on that.

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "solver/banded_pair.hpp"
#include "solver/compact_operators.hpp"
#include "solver/prepared_update.hpp"
#include "solver/regular_nodes.hpp"

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

  // A step of the nodes [nodes.first, nodes.last), nodes.first a multiple of part_nodes, not more
  // than that many. `solid` and `fluid` are used where `update` must ask update_node.
  void step(const Problem& problem, const StepLoad& load, const PreparedUpdate& update,
            IndexRange nodes, PhaseNodes& solid, PhaseNodes& fluid);
  // After all parts of a step.
  void end_step();
  // An upper bound of the displacement of any node since the start, m.
  double displacement_bound() const { return displacement_bound_; }
  // The displacements themselves, which make the bound sharp.
  void displacements(std::span<double> solid, std::span<double> fluid);

  // Velocities and stresses of all points.
  void settle(PointValues& solid, PointValues& fluid) const;
  // q of the nodes and e of the cells. No point has a larger velocity, nor more than twice the
  // stress.
  std::array<std::span<const double>, 2> node_values() const;
  std::array<std::span<const double>, 2> cell_values() const;

 private:
  // q or e of both phases.
  struct Fields {
    PaddedValues solid;
    PaddedValues fluid;
  };
  // New velocities at the ends of a part, for the cells between parts.
  struct PartEnds {
    double solid_first = 0.0, fluid_first = 0.0, solid_last = 0.0, fluid_last = 0.0;
    double squares = 0.0;  // sum of all squares
  };

  // Of some eights of nodes: velocities and forces; new q and e from the new velocities; a step.
  struct Squares {
    double solid = 0.0, fluid = 0.0;  // Σ v'²
  };
  void gather(IndexRange eights, Scratch& at) const;
  Squares update_values(IndexRange eights, Scratch& at);
  Squares step_regular_nodes(IndexRange eights, Scratch& at);
  void update_specials(const Problem& problem, const StepLoad& load, const PreparedUpdate& update,
                       IndexRange nodes, Scratch& at, PhaseNodes& solid, PhaseNodes& fluid) const;

  std::shared_ptr<const CompactOperators> solid_points_;
  std::shared_ptr<const CompactOperators> fluid_points_;
  std::shared_ptr<const BandedPair> to_nodes_;  // W
  std::shared_ptr<const BandedPair> to_cells_;  // B
  RegularNodes regular_;
  Constants constants_;
  double spacing_;
  std::size_t node_count_;
  Fields nodes_;  // q, m/s
  Fields cells_;  // e, Pa
  Fields new_nodes_;
  Fields new_cells_;
  std::vector<PartEnds> ends_;
  double solid_first_displacement_ = 0.0;  // of node 0, m
  double fluid_first_displacement_ = 0.0;
  double displacement_bound_ = 0.0;
};

}  // namespace porowave::solver
