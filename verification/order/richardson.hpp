#pragma once

#include <array>

namespace porowave::verification {

/// Richardson extrapolation of a quantity computed on three grids, for problems whose solution is
/// not known. Source: Celik et al., J. Fluids Eng. 130 (2008) 078001; Roache (1998).
struct Richardson {
  double order = 0.0;         ///< NaN if none fits
  double extrapolated = 0.0;  ///< the value at h = 0
  double gci = 0.0;           ///< grid convergence index of the finest grid, relative to its value
  bool oscillating = false;   ///< the differences change sign: the order is that of their sizes
};

/// Values on grids of falling spacing, coarse to fine; ratios need not be equal. `safety` is that
/// of the GCI (1.25 for three grids). Throws std::invalid_argument if spacings do not fall or a
/// value is not finite.
Richardson extrapolate(const std::array<double, 3>& spacing, const std::array<double, 3>& value,
                       double safety = 1.25);

}  // namespace porowave::verification
