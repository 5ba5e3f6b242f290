#pragma once

#include <functional>

#include "reference/problem/problem.hpp"
#include "verification/faults/fault.hpp"

namespace porowave::verification::faults {

using ReferenceFunction = std::function<Fields(const Problem&, double x, double t)>;

/// Compares with the rows of reference/tables/truth_step.csv whose drag is moderate (rate times
/// time below 30, which Talbot's contour can do). Caught if a row is off by more than 1e-6 of the
/// load; says by how much the worst one is.
Catch caught_by_truth(const ReferenceFunction& values);
/// How many rows that are.
int truth_rows_compared();

}  // namespace porowave::verification::faults
