#pragma once

#include <vector>

#include "reference/column_solution.hpp"
#include "reference/contour_choice.hpp"
#include "reference/inversion.hpp"

namespace porowave::reference {

/// How one group of waves was inverted.
struct ExplainedGroup {
  std::size_t waves;  ///< arrivals in the group
  double oldest;      ///< s since the oldest of them arrived
  ContourChoice choice;
  double bound;  ///< of the part of the value, as a share of the load
  /// Sums with the nodes of level 0, 1, ... of the contour (FourSums), and how many nodes each
  /// took.
  std::vector<FourSums> by_level;
  std::vector<std::size_t> nodes_by_level;
  std::vector<Complex> nodes;  ///< those of the last level whose terms count, by distance

  /// log10 of the integrand times |s|, as a share of the load, at points of the s plane; rows by
  /// points. Shows the saddle that the contour goes through.
  std::vector<double> log_heights(const Problem& problem, const std::vector<Complex>& s) const;
  std::vector<Arrival> arrivals;
};

/// The groups of waves that make up the value at (x, t), each with the contour that the solution
/// uses for it. For pictures and for measurements of cost; values are those of ColumnSolution::at.
/// Throws InputError as that does.
std::vector<ExplainedGroup> explain(const ColumnSolution& solution, double x, double t);

}  // namespace porowave::reference
