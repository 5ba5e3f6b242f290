#pragma once

// What one phase contributes to a step of the column, as two operators made once for the points
// where they are:
//
//   gather    points to nodes: v_i = Σ_p Φ_p(x_i) v_p and the force of the stress, −∫ ∂N_i s dx
//   scatter   nodes to points: v_p ← flip v_p + Σ_i N_i(x_p) (v_i' − flip v_i),
//             s_p ← s_p + c Σ_i ∂N_i(x_p) b_i, v_i and v_i' the nodal velocities before and after
//
// Both work on a part of the column, so that parts can run side by side or be left out. There are
// two forms of the same operators:
//
//   compact   points sorted along the column, linear N: a row of weights touches neighbouring
//             points, the strain is one number a cell (or that and the difference to a neighbour,
//             shared_strains.hpp), the force at a node is the difference of the cells' stresses
//             beside it, S_i − S_(i−1). S is the moving least squares value in the cell's middle,
//             or for `shape` Σ_p V_p s_p/h.
//   general   any Transfer<1>, by its sparse rows, with the affine velocities of apic and with
//   XPIC;
//             whole column only

#include <memory>
#include <span>
#include <vector>

#include "solver/range_rows.hpp"
#include "solver/transfer.hpp"

namespace porowave::solver {

// Values of all points of a phase.
struct PointValues {
  std::vector<double> velocity;           // m/s
  std::vector<double> stress;             // Pa
  std::vector<double> velocity_gradient;  // C_p of apic, 1/s; empty for other transfers
};

// What scatter does to points; nodal values from the first node of the part on. Of b also the
// values one node before and one beyond the part must be there, as far as the column reaches.
struct PointUpdate {
  double flip;           // 1 FLIP ... 0 PIC
  const double* before;  // v_i, m/s
  const double* after;   // v_i', m/s
  const double* b;       // m/s
  double c;              // Pa s
  int xpic_order = 0;    // general form only: XPIC of that order, flip = 1
};

class ColumnOperators {
 public:
  virtual ~ColumnOperators() = default;

  // Nodal velocity (m/s) and force (N) of the nodes [nodes.first, nodes.last), from the velocities
  // and stresses of all points. Both results are as long as the range.
  virtual void gather(const PointValues& points, IndexRange nodes, double* nodal_velocity,
                      double* force) const = 0;
  // Updates the points of the cells [cells.first, cells.last).
  virtual void scatter(const PointUpdate& update, IndexRange cells, PointValues& points) const = 0;
  // Σ_i N_i(x_p) u_i for all points, and with ∂N_i.
  virtual void to_points(const double* nodal, double* at_points) const = 0;
  virtual void gradient_at_points(const double* nodal, double* at_points) const = 0;
  // The stress in the middle of every cell as Transfer::at_cell_centres gives it.
  virtual std::vector<double> at_cell_centres(std::span<const double> stress) const = 0;
  // Whether parts of the column are possible.
  virtual bool works_on_parts() const = 0;
  // How many nodes farther the velocity of a node can be felt after a step, at most.
  virtual std::size_t reach() const = 0;
  // The points of the cells [cells.first, cells.last); all points if there are no parts.
  virtual IndexRange points_of(IndexRange cells) const = 0;
};

struct PreparedPhase {
  std::shared_ptr<const ColumnOperators> operators;
  std::vector<double> nodal_mass;  // as Transfer gives them
  std::vector<double> nodal_volume;
  std::size_t reduced_rows = 0;
  std::size_t empty_rows = 0;
};

// The operators of a phase, compact where that form is available. `points` must be sorted by x
// (std::invalid_argument otherwise, and as Transfer throws).
PreparedPhase prepare_phase(const PointSet<1>& points, const Grid<1>& grid,
                            const Discretization& choice, const TimeSettings& time = {});

}  // namespace porowave::solver
