#pragma once

// The step of ColumnSolver as a linear map (step_operator.hpp), for every transfer.
//
//   v = W q, f = F d             rows from nodes and cells through points to nodes
//   v' from v, f and the load    PreparedUpdate
//   q ← flip (q − v) + v'        or XPIC (velocity_noise.hpp): q ← v' + (I − (I − W)^(m−1)) (q − v)
//   d ← d + c (b_(i+1) − b_i)    c, b of PointUpdate; d/h is the stress of the cell

#include <Eigen/Sparse>

#include "solver/column_solver.hpp"
#include "solver/stability/step_operator.hpp"

namespace porowave::solver {

class GalerkinStep : public StepOperator {
 public:
  // Throws as ColumnSolver.
  explicit GalerkinStep(const Case& scene);

  std::size_t size() const override { return 4 * cells_ + 2; }
  LinearMap at(double time_step) const override;
  CarriedFields fields(std::span<const double> state) const override;

  // The step with a load: what a run from rest must repeat.
  std::function<void(std::span<const double> in, const StepLoad& load, std::span<double> out)>
  loaded(double time_step) const;

 private:
  using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  struct PhaseRows {
    Rows velocity;  // W
    Rows force;     // F
  };
  // Parts of a state.
  struct Offsets {
    std::size_t fluid_velocity, effective_stress, pore_pressure;
  };
  // Numbers of a state by its parts in physical units.
  struct Scales {
    double solid_velocity, fluid_velocity, effective_stress, pore_pressure;
  };
  struct Scratch;

  static PhaseRows probe(const ColumnOperators& operators, std::size_t cells, bool affine);
  void step(std::span<const double> in, const StepLoad& load, Scratch& at,
            std::span<double> out) const;
  void update_velocities(const Rows& rows, const std::vector<double>& before,
                         const std::vector<double>& after, Eigen::VectorXd& q) const;

  Case scene_;
  std::size_t cells_;
  double spacing_;
  PhaseRows solid_;
  PhaseRows fluid_;
  PhaseNodes solid_nodes_;
  PhaseNodes fluid_nodes_;
  Offsets offset_;
  Scales scale_;
};

}  // namespace porowave::solver
