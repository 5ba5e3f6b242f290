#pragma once

#include <string>
#include <vector>

#include "reference/column_solution.hpp"
#include "reports/gnuplot.hpp"

namespace porowave::reports {

/// One value of the reference whose inversion is to be shown.
struct ContourPanel {
  std::string title;
  Problem problem;
  double x;  ///< m
  double t;  ///< s
};

/// The s plane of each value: size of the integrand of its largest group of waves, the cut, the
/// branch point, and the contour with its nodes; the upper half, the lower mirrors it.
/// Throws InputError for a value without waves.
Figure contour_figure(const std::string& name, const std::string& caption,
                      const std::vector<ContourPanel>& panels);

}  // namespace porowave::reports
