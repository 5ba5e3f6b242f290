#pragma once

// The vector of Dim coordinates or components that the whole room uses.

#include <Eigen/Core>

namespace porowave::solver {

template <int Dim>
using Vector = Eigen::Matrix<double, Dim, 1>;

}  // namespace porowave::solver
