#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "reference/column_solution.hpp"
#include "reports/gnuplot.hpp"
#include "reports/run_history.hpp"
#include "solver/case.hpp"

namespace porowave::reports {

/// One row of a figure of profiles: a run and what it is compared with.
struct ProfileRow {
  std::string title;
  solver::Case scene;
  solver::Snapshot snapshot;
  /// Marked and named P1 or P2; if absent, the jumps of the reference that can be seen.
  std::optional<std::vector<WaveFront>> fronts = {};
  /// Points of a phase that are drawn; of more than these the lowest and the highest in each of
  /// half as many equal parts of the column, so that none that stands out is lost.
  std::size_t most_points = std::numeric_limits<std::size_t>::max();
};

/// Rows of effective stress and pore pressure at the material points over the reference, with the
/// fronts marked and empty elements shaded. All rows share their axes, which show the reference and
/// at most as much again above and below it.
Figure profile_figure(const std::string& name, const std::string& caption,
                      const std::vector<ProfileRow>& rows);

/// One curve of error against element length and CPU time.
struct ConvergenceCurve {
  std::string title;
  struct Level {
    int elements;
    double element_length;  ///< m
    double error;           ///< relative L2 of the reconstructed effective stress
    double cpu_seconds;
  };
  std::vector<Level> levels;
};

Figure convergence_figure(const std::string& name, const std::string& caption,
                          const std::vector<ConvergenceCurve>& curves);

}  // namespace porowave::reports
