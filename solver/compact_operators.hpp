#pragma once

// The compact form of a phase's operators, see column_operators.hpp: points sorted along the
// column, linear shape functions. 8 bytes a point for its place in its cell, and 8 for every weight
// of nodes and cell middles.

#include <vector>

#include "solver/column_operators.hpp"
#include "solver/shared_strains.hpp"

namespace porowave::solver {

class CompactOperators : public ColumnOperators {
 public:
  // Takes the rows of the transfer over. `points` must be those of the transfer, sorted by x.
  CompactOperators(Transfer<1>&& transfer, const PointSet<1>& points, const Grid<1>& grid);

  void gather(const PointValues& points, IndexRange nodes, double* nodal_velocity,
              double* force) const override;
  void scatter(const PointUpdate& update, IndexRange cells, PointValues& points) const override;
  void to_points(const double* nodal, double* at_points) const override;
  void gradient_at_points(const double* nodal, double* at_points) const override;
  std::vector<double> at_cell_centres(std::span<const double> stress) const override;
  bool works_on_parts() const override { return true; }
  std::size_t reach() const override { return reach_; }
  IndexRange points_of(IndexRange cells) const override {
    return {first_point_[cells.first], first_point_[cells.last]};
  }

  std::size_t cell_count() const { return first_point_.size() - 1; }
  double spacing() const { return spacing_; }
  const RangeRows& node_rows() const { return node_rows_; }                // Φ at the nodes
  const RangeRows& cell_rows() const { return cell_rows_; }                // S of the cells
  double place_in_cell(std::size_t p) const { return place_in_cell_[p]; }  // (x_p − x_i)/h
  const SharedStrains& shared_strains() const { return shared_strains_; }

 private:
  // Walks there from the cell `near`.
  std::size_t cell_of(std::size_t point, std::size_t near) const;
  std::size_t reach_of_rows() const;

  RangeRows node_rows_;
  RangeRows cell_rows_;
  std::vector<std::size_t> first_point_;  // of every cell, and the number of points
  std::vector<double> place_in_cell_;
  SharedStrains shared_strains_;
  std::vector<double> mean_factor_;  // from S to the mean stress of a cell; empty for mls
  double spacing_;
  std::size_t reach_ = 0;
};

}  // namespace porowave::solver
