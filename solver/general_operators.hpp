#pragma once

// The general form of a phase's operators, see column_operators.hpp: any transfer, as it is.

#include "solver/column_operators.hpp"

namespace porowave::solver {

class GeneralOperators : public ColumnOperators {
 public:
  explicit GeneralOperators(Transfer<1>&& transfer, std::size_t points)
      : transfer_(std::move(transfer)), points_(points) {}

  // The ranges must be all nodes and all cells.
  void gather(const PointValues& points, IndexRange nodes, double* nodal_velocity,
              double* force) const override;
  void scatter(const PointUpdate& update, IndexRange cells, PointValues& points) const override;
  void to_points(const double* nodal, double* at_points) const override;
  void gradient_at_points(const double* nodal, double* at_points) const override;
  std::vector<double> at_cell_centres(std::span<const double> stress) const override {
    return transfer_.at_cell_centres(stress);
  }
  bool works_on_parts() const override { return false; }
  std::size_t reach() const override { return transfer_.nodal_mass().size(); }
  IndexRange points_of(IndexRange) const override { return {0, points_}; }

 private:
  Transfer<1> transfer_;
  std::size_t points_;
};

}  // namespace porowave::solver
